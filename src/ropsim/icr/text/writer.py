"""Program -> canonical ICR text."""

from ropsim.icr.opcodes import OPCODES, OperandKind
from ropsim.icr.program import LibraryText, Procedure, Program, Step
from ropsim.icr.text.literals import written
from ropsim.icr.text.operands import written_operand
from ropsim.icr.text.tokens import named, quoted
from ropsim.icr.types import Constant


def disassemble(program: Program) -> str:
    """Return the canonical text of a program.

    ASCII, one record per line, two blanks before instructions, shortest round-trip numbers, labels `L0 L1
    ...` in the order of addresses: `disassemble(assemble(text))` is a fixpoint.
    """
    records = [f"ICR {program.version} {named(program.name)}"]
    if program.source:
        records.append(f"SOURCE {quoted(program.source)}")
    records += (_library(one) for one in program.libraries)
    if program.axes is not None:
        records.append(f"REQUIRE AXES {program.axes}")
    if program.capabilities:
        records.append("REQUIRE CAP " + " ".join(map(named, sorted(program.capabilities))))
    records += [f"VAR {named(one.name)} {one.type.value}" for one in program.variables]
    records += [f"IO {one.kind} {named(one.name)} {one.type.value}" for one in program.channels]
    records += [f"FRAMEDEF {named(one.name)} {_numbers(one.pose)}" for one in program.frames]
    records += [f"TOOLDEF {named(one.name)} {_numbers(one.pose or ())}".rstrip() for one in program.tools]
    for one in program.lists:
        records += [f"LIST {named(one.name)}", *(f"ROW {_numbers(pose)}" for pose in one.poses)]
    for procedure in program.procedures:
        records += _procedure(procedure)
    return "\n".join(records) + "\n"


def _library(one: LibraryText) -> str:
    return f"TASKTEXT {named(one.procedure)} {quoted(one.source)} {quoted(one.version)}"


def _numbers(values: tuple[float, ...]) -> str:
    return " ".join(map(repr, values))


def _procedure(procedure: Procedure) -> list[str]:
    records = [f"PROC {named(procedure.name)}"]
    records += [f"PARAM {named(one.name)} {one.type.value}" for one in procedure.parameters]
    records += [f"LOCAL {named(one.name)} {one.type.value}" for one in procedure.locals]
    records += [f"RESULT {one.value}" for one in procedure.results]
    labels = _labels(procedure)
    line = 0
    for index, step in enumerate(procedure.code):
        if index in labels:
            records.append(f"{labels[index]}:")
        here = procedure.lines[index]
        if here != line:
            records.append(f"  LINE {here}")
            line = here
        records.append(f"  {_step(step, labels)}")
    if len(procedure.code) in labels:
        records.append(f"{labels[len(procedure.code)]}:")
    return [*records, "END"]


def _labels(procedure: Procedure) -> dict[int, str]:
    targets: set[int] = set()
    for step in procedure.code:
        opcode = OPCODES.get(step.mnemonic)
        if opcode and opcode.operands == (OperandKind.LABEL,):
            targets.update(operand for operand in step.operands if isinstance(operand, int))
    return {target: f"L{number}" for number, target in enumerate(sorted(targets))}


def _step(step: Step, labels: dict[int, str]) -> str:
    if not step.operands:
        return step.mnemonic
    if step.mnemonic == "PUSH" and isinstance(step.operands[0], Constant) and len(step.operands) == 1:
        return f"PUSH {written(step.operands[0])}"
    opcode = OPCODES.get(step.mnemonic)
    if opcode is None or len(opcode.operands) != len(step.operands):
        words = [named(one) if isinstance(one, str) else repr(one) for one in step.operands]
    else:
        words = [
            written_operand(kind, one, labels if kind is OperandKind.LABEL else {})
            for kind, one in zip(opcode.operands, step.operands, strict=True)
        ]
    return " ".join([step.mnemonic, *words])
