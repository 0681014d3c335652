"""Which instructions of a program can be carried out from some of its places on."""

from collections.abc import Iterable

from ropsim.icr.opcodes import OPCODES, OperandKind
from ropsim.icr.program import Program

Place = tuple[int, int]
"""Procedure and instruction of a code."""


def reached(program: Program, places: Iterable[Place]) -> set[Place]:
    """Return the instructions that can come from some places on, without those behind a return."""
    waiting = list(places)
    seen: set[Place] = set()
    while waiting:
        place = waiting.pop()
        if place in seen:
            continue
        seen.add(place)
        procedure, index = place
        step = program.procedures[procedure].code[index]
        opcode = OPCODES[step.mnemonic]
        if opcode.operands == (OperandKind.LABEL,):
            waiting.append((procedure, int(str(step.operands[0]))))
        if opcode.operands == (OperandKind.PROCEDURE,):
            waiting.append((program.procedure_numbers[str(step.operands[0])], 0))
        if not opcode.ends_flow and index + 1 < len(program.procedures[procedure].code):
            waiting.append((procedure, index + 1))
    return seen
