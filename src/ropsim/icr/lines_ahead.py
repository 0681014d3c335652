"""Which lines of a program can still be carried out when one of its lines is at work."""

from collections.abc import Iterable, Iterator

from ropsim.icr.opcodes import OPCODES, OperandKind
from ropsim.icr.program import Program

Place = tuple[int, int]
"""Procedure and instruction of a code."""


def lines_ahead(program: Program, line: int) -> frozenset[int]:
    """Return the lines of the source that can follow upon a line, itself among them.

    How the procedures were called is not known: a return leads behind every call.

    Args:
        program: in which the verifier finds nothing.
        line: from 1; one that the code does not have can have all lines behind it.
    """
    at_work = {
        (number, index)
        for number, procedure in enumerate(program.procedures)
        for index, there in enumerate(procedure.lines)
        if there == line
    }
    places = reached(program, [*at_work, *_behind_calls(program, {number for number, _ in at_work})])
    lines = (
        procedure.lines[index]
        for number, procedure in enumerate(program.procedures)
        for index in range(len(procedure.code))
        if not at_work or (number, index) in places
    )
    return frozenset(lines)


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


def _behind_calls(program: Program, called: set[int]) -> Iterator[Place]:
    """Yield the instructions behind the calls of procedures, and behind those of their callers."""
    waiting = {program.procedures[number].name for number in called}
    known = set(waiting)
    while waiting:
        name = waiting.pop()
        for number, procedure in enumerate(program.procedures):
            for index, step in enumerate(procedure.code):
                if step.mnemonic == "CALL" and str(step.operands[0]) == name:
                    if index + 1 < len(procedure.code):
                        yield number, index + 1
                    waiting |= {procedure.name} - known
                    known.add(procedure.name)
