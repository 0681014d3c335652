"""Rules V2, V3 and V8: known opcodes, operands in range, sound constants."""

import math
from collections import ChainMap
from collections.abc import Collection, Iterator, Mapping

from ropsim.core import Diagnostic, Span, did_you_mean, near
from ropsim.icr import diagnostics as kinds
from ropsim.icr.opcodes import OPCODES, POSTURE, WORDS, OperandKind
from ropsim.icr.program import Operand, Procedure, Program, Step, text_place
from ropsim.icr.types import MAX_EXTERNAL, Constant, Type, has_form, reals, rotation

UNIT_TOLERANCE = 1e-6
"""How far the length of a quaternion may be from 1: quaternions typed with 7 digits are accepted."""
MAX_AXES = 32
MAX_NUMBER = 65535
MAX_POINTS = 1000
"""Poses that one curve may lead through: more do not fit on a stack that every rule can check."""
_MAX_INDEX = {OperandKind.INDEX: MAX_AXES - 1, OperandKind.CATEGORY: 2}
_MAX_COUNT = {"MKJ": MAX_AXES, "MKEXT": MAX_EXTERNAL, "MOVE.SPL": MAX_POINTS, "TURNS": MAX_AXES}
_SHARES = {"SPD.PTP", "ACC.PTP"}
_SPEEDS = _SHARES | {"SPD.LIN", "SPD.ORI", "ACC.LIN", "ACC.ORI", "JERK"}
_POSITIVE = _SPEEDS | {"MOVE.CIRC.A", "TRACK"}
_SETTERS = {"OUT", "TRIG.DIST", "TRIG.TIME"}
_OF_CHANNELS = _SETTERS | {"WAIT.IN", "GUARD", "TRACK"}
_NOT_NEGATIVE = {"ZONE.DIST", "WAIT.T", "TRIG.DIST", "TRIG.TIME"}
_PLAIN = {
    name for name, opcode in OPCODES.items() if not opcode.operands and name not in _POSITIVE | _NOT_NEGATIVE
}
"""Instructions without operands that take any values of their types."""


def setting_fault(mnemonic: str, value: float) -> str:
    """Return the fault of a modal value, or an empty string; shared by verifier and machine."""
    if mnemonic in _SHARES and not 0.0 < value <= 1.0:
        return f"`{mnemonic}` is given {value!r}, allowed are shares above 0 up to 1"
    if mnemonic in _POSITIVE and value <= 0.0:
        return f"`{mnemonic}` is given {value!r}, allowed are values above 0"
    if mnemonic in _NOT_NEGATIVE and value < 0.0:
        return f"`{mnemonic}` is given {value!r}, allowed are values from 0"
    return ""


def check_operands(program: Program, procedure: Procedure) -> Iterator[Diagnostic]:
    """Yield the faults of single instructions of a procedure."""
    names = _names(program, procedure)
    for index, step in enumerate(procedure.code):
        if _is_sound(step):
            continue
        if next(_faults(program, procedure, names, index, None), None):  # unneeded if there are no faults
            yield from _faults(program, procedure, names, index, text_place(program, procedure, index))


def _is_sound(step: Step) -> bool:
    """Return whether an instruction is right wherever it stands, as is seen at once for most of them."""
    mnemonic, operands = step
    if operands:
        return mnemonic == "PUSH" and len(operands) == 1 and _is_whole(operands[0])
    return mnemonic in _PLAIN


def _is_whole(operand: Operand) -> bool:
    """Return whether an operand is a constant that keeps rule V8."""
    return isinstance(operand, Constant) and next(check_constant(operand, None, ""), None) is None


def _faults(
    program: Program,
    procedure: Procedure,
    names: Mapping[OperandKind, Collection[str]],
    index: int,
    place: Span | None,
) -> Iterator[Diagnostic]:
    """Yield the faults of an instruction, reported at a place."""
    step = procedure.code[index]
    opcode = OPCODES.get(step.mnemonic)
    if opcode is None:
        close = near(step.mnemonic, OPCODES)
        hint = "near: " + ", ".join(f"`{name}`" for name in close) if close else ""
        yield kinds.OPCODE_UNKNOWN.at(place, f"unknown instruction `{step.mnemonic}`", hint=hint)
    elif len(step.operands) != len(opcode.operands):
        message = f"`{step.mnemonic}` has {len(step.operands)} operands, allowed: {len(opcode.operands)}"
        yield kinds.OPERAND_WRONG.at(place, message)
    else:
        for kind, operand in zip(opcode.operands, step.operands, strict=True):
            if kind is OperandKind.CONSTANT:
                yield from _check_pushed(operand, place)
            elif kind is OperandKind.POSTURE:
                if not isinstance(operand, str) or not POSTURE.match(operand):
                    message = f"`POSTURE` has operand {operand!r}, allowed are words with - between"
                    yield kinds.OPERAND_WRONG.at(place, message)
            elif kind in names:
                yield from _check_name(step, kind, operand, names[kind], place)
            else:
                yield from _check_number(step, kind, operand, len(procedure.code), place)
        yield from _check_use(program, procedure, index, place)


def check_constant(constant: Constant, place: Span | None, what: str) -> Iterator[Diagnostic]:
    """Yield the faults of a constant (rule V8)."""
    if not has_form(constant):
        yield kinds.OPERAND_WRONG.at(place, f"{what}: the value does not fit type {constant.type.value}")
    elif not all(map(math.isfinite, reals(constant))):
        yield kinds.NOT_FINITE.at(place, f"{what}: found {constant.value!r}, only finite numbers are allowed")
    elif quaternion := rotation(constant):
        length = math.hypot(*quaternion)
        if abs(length - 1.0) > UNIT_TOLERANCE or quaternion[0] < 0.0:
            message = f"{what}: quaternion {quaternion!r} has length {length:.9g} and w = {quaternion[0]!r}"
            yield kinds.NOT_UNIT_QUATERNION.at(place, message, hint="write it with length 1 and w >= 0")


def _names(program: Program, procedure: Procedure) -> dict[OperandKind, Collection[str]]:
    return {
        OperandKind.VARIABLE: ChainMap(procedure.numbers, program.numbers),
        OperandKind.PROCEDURE: program.procedure_numbers,
        OperandKind.FRAME: {one.name for one in program.frames} | {""},
        OperandKind.TOOL: {one.name for one in program.tools} | {""},
        OperandKind.LIST: {one.name for one in program.lists},
        OperandKind.CHANNEL: {one.name for one in program.channels},
        **{kind: set(words) for kind, words in WORDS.items()},
    }


def _check_pushed(operand: Operand, place: Span | None) -> Iterator[Diagnostic]:
    if isinstance(operand, Constant):
        yield from check_constant(operand, place, "`PUSH`")
    else:
        yield kinds.OPERAND_WRONG.at(place, f"`PUSH` needs a constant, found {operand!r}")


def _check_name(
    step: Step, kind: OperandKind, operand: Operand, names: Collection[str], place: Span | None
) -> Iterator[Diagnostic]:
    if not isinstance(operand, str):
        yield kinds.OPERAND_WRONG.at(place, f"`{step.mnemonic}` needs the name of a {kind.value}")
    elif operand not in names:
        message = f"{kind.value} `{operand}` is not declared"
        yield kinds.NAME_UNDECLARED.at(place, message, hint=did_you_mean(operand, filter(None, names)))


def _check_number(
    step: Step, kind: OperandKind, operand: Operand, size: int, place: Span | None
) -> Iterator[Diagnostic]:
    low = 1 if kind is OperandKind.COUNT else 0
    high = size - 1 if kind is OperandKind.LABEL else _MAX_INDEX.get(kind, MAX_NUMBER)
    if kind is OperandKind.COUNT:
        high = _MAX_COUNT[step.mnemonic]
    if isinstance(operand, bool) or not isinstance(operand, int):
        yield kinds.OPERAND_WRONG.at(place, f"`{step.mnemonic}` needs a number, found {operand!r}")
    elif kind is OperandKind.LABEL and operand == size:
        message = f"`{step.mnemonic}` leads past the last instruction"
        yield kinds.FALLS_OFF_END.at(place, message, hint="put `RET` or `HALT` after the label")
    elif not low <= operand <= high:
        message = f"`{step.mnemonic}` has operand {operand}, allowed are {low} to {high}"
        yield kinds.OPERAND_WRONG.at(place, message)


def _check_use(
    program: Program, procedure: Procedure, index: int, place: Span | None
) -> Iterator[Diagnostic]:
    """Check properties of several operands: kinds of channels, constants given to modal instructions."""
    step = procedure.code[index]
    names_one = step.mnemonic in _OF_CHANNELS and step.operands
    channel = program.channel(str(step.operands[-1])) if names_one else None
    if step.mnemonic in _SETTERS and channel and not channel.is_output:
        message = f"`{step.mnemonic}` needs an output, `{channel.name}` is {channel.kind}"
        yield kinds.OPERAND_WRONG.at(place, message)
    if step.mnemonic == "WAIT.IN" and channel and channel.type is not Type.BOOL:
        message = f"`WAIT.IN` needs a channel of type BOOL, `{channel.name}` is {channel.type.value}"
        yield kinds.OPERAND_WRONG.at(place, message)
    if step.mnemonic == "GUARD" and channel and (step.operands[0] == "is") != (channel.type is Type.BOOL):
        wanted = "of type BOOL" if step.operands[0] == "is" else "that is a number"
        message = (
            f"`GUARD {step.operands[0]}` needs a channel {wanted}, `{channel.name}` is {channel.type.value}"
        )
        yield kinds.OPERAND_WRONG.at(place, message)
    if step.mnemonic == "TRACK" and channel and channel.type is not Type.REAL:
        message = f"`TRACK` needs a channel of type REAL, `{channel.name}` is {channel.type.value}"
        yield kinds.OPERAND_WRONG.at(place, message)
    before = procedure.code[index - 1] if index else None
    if before and before.mnemonic == "PUSH" and before.operands:
        constant = before.operands[0]
        value = constant.value if isinstance(constant, Constant) else None
        if isinstance(value, float) and math.isfinite(value):
            fault = setting_fault(step.mnemonic, value)
            if fault:
                yield kinds.SPEED_NOT_POSITIVE.at(place, fault)
