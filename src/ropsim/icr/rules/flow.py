"""Rules V4 and V5: typed stack, saved modal states and moves by data flow, no dead code, no fall-through."""

from collections.abc import Iterator
from typing import NamedTuple

from ropsim.core import Diagnostic
from ropsim.icr import diagnostics as kinds
from ropsim.icr.opcodes import ENDS_FLOW, OPCODES
from ropsim.icr.program import Procedure, Program, Step, text_place
from ropsim.icr.rules.stack import Fault, Stack, effect
from ropsim.icr.types import Constant

JUMPS = {"JMP", "JF", "JT"}
_PREFIXES = {"TRIG.DIST", "TRIG.TIME", "GUARD", "TRACK"}
_ONCE = {"GUARD": "a move ends by one condition", "TRACK": "a move is corrected by one sensor"}
_JOINT_MOVES = {"MOVE.PTP", "MOVE.PTP.J", "HOME"}
_LOSING = {"HALT", "RET", "CALL", "STOP", "SYNC", "OUT", "WAIT.T", "WAIT.IN", "MSG", "GRIP"}
"""Instructions not allowed between a prefix and its move: procedure ends, and robot instructions."""


class _State(NamedTuple):
    """Known state before an instruction.

    Attributes:
        stack: types on the stack.
        depth: number of saved modal states.
        prefixes: instructions that wait for the next move.
    """

    stack: Stack
    depth: int
    prefixes: frozenset[str] = frozenset()


def successors(procedure: Procedure, index: int) -> tuple[int, ...]:
    """Return the instructions that may follow instruction `index`."""
    step = procedure.code[index]
    follow: tuple[int, ...] = () if step.mnemonic in ENDS_FLOW else (index + 1,)
    if step.mnemonic in JUMPS and isinstance(step.operands[0], int):
        return (*follow, step.operands[0])
    return follow


def check_reachability(program: Program, procedure: Procedure) -> Iterator[Diagnostic]:
    """Yield where control falls off the end, and the first instruction of every dead range (V5)."""
    size = len(procedure.code)
    if size == 0:
        place = program.declared_at.get(f"PROC {procedure.name}")
        yield kinds.FALLS_OFF_END.at(place, f"procedure `{procedure.name}` has no instructions")
        return
    seen = {0}
    work = [0]
    while work:
        for target in successors(procedure, work.pop()):
            if target < size and target not in seen:
                seen.add(target)
                work.append(target)
    if size - 1 in seen and procedure.code[-1].mnemonic not in ENDS_FLOW:
        place = text_place(program, procedure, size - 1)
        message = f"procedure `{procedure.name}` ends without `RET`, `HALT`, `TRAP`, `STOP` or `JMP`"
        yield kinds.FALLS_OFF_END.at(place, message)
    for index in range(1, size):
        if index not in seen and index - 1 in seen:
            place = text_place(program, procedure, index)
            message = f"`{procedure.code[index].mnemonic}` in `{procedure.name}` can never be reached"
            yield kinds.CODE_UNREACHABLE.at(place, message)


def check_stack(program: Program, procedure: Procedure) -> tuple[Diagnostic, ...]:
    """Return the faults of types, saved modal states and prefixes of moves on all ways (V4)."""
    return tuple(_flow(program, procedure)[1])


def stacks(program: Program, procedure: Procedure) -> dict[int, Stack]:
    """Return the types on the stack before each instruction of a verified procedure."""
    return {index: state.stack for index, state in _flow(program, procedure)[0].items()}


def _flow(program: Program, procedure: Procedure) -> tuple[dict[int, _State], list[Diagnostic]]:
    states = {0: _State((), 0)}
    known: dict[tuple[object, _State], _State | Fault] = {}
    found: list[Diagnostic] = []
    work = [0]
    while work:
        index = work.pop()
        step, before = procedure.code[index], states[index]
        alike = _without_value(step), before
        after = known.get(alike) or known.setdefault(alike, _after(program, procedure, step, before))
        if isinstance(after, Fault):
            place = text_place(program, procedure, index)
            found.append(after.kind.at(place, after.message, hint=after.hint))
            continue
        for target in successors(procedure, index):
            if target >= len(procedure.code):
                continue
            if target not in states:
                states[target] = after
                work.append(target)
            elif states[target] != after:
                message = f"ways join here with {_shown(states[target])} and with {_shown(after)}"
                found.append(kinds.JOIN_DIFFERS.at(text_place(program, procedure, target), message))
    return states, found


def _without_value(step: Step) -> object:
    """Return the key of an instruction for the types on the stack: constants of one type are equal."""
    operand = step.operands[0] if step.operands else None
    return (step.mnemonic, operand.type) if isinstance(operand, Constant) else step


def _after(program: Program, procedure: Procedure, step: Step, before: _State) -> _State | Fault:
    depth = before.depth
    if step.mnemonic == "MODAL.SAVE":
        depth += 1
    elif step.mnemonic == "MODAL.RESTORE":
        depth -= 1
    prefixes = before.prefixes
    if step.mnemonic in _ONCE and step.mnemonic in prefixes:
        message = f"`{step.mnemonic}` stands twice before a move"
        return Fault(kinds.PREFIX_LOST, message, _ONCE[step.mnemonic])
    if step.mnemonic in _PREFIXES:
        prefixes |= {step.mnemonic}
    elif prefixes and step.mnemonic in _LOSING:
        waiting = _listed(prefixes)
        message = f"`{step.mnemonic}` stands between {waiting} and its move"
        return Fault(kinds.PREFIX_LOST, message, f"put {waiting} right before a move")
    elif "TRACK" in prefixes and step.mnemonic in _JOINT_MOVES:
        message = f"`TRACK` stands before `{step.mnemonic}`, which has no path of the tool"
        return Fault(kinds.PREFIX_LOST, message, "a sensor corrects `MOVE.LIN`, `MOVE.CIRC` and `MOVE.SPL`")
    elif OPCODES[step.mnemonic].is_move:
        prefixes = frozenset()
    if depth < 0:
        return Fault(kinds.MODAL_UNBALANCED, "`MODAL.RESTORE` without `MODAL.SAVE` before it")
    if step.mnemonic == "RET" and depth:
        message = f"`RET` in `{procedure.name}` with {depth} saved modal states, allowed: none"
        return Fault(kinds.MODAL_UNBALANCED, message, "put `MODAL.RESTORE` before `RET`")
    stack = effect(program, procedure, step, before.stack)
    return stack if isinstance(stack, Fault) else _State(stack, depth, prefixes)


def _shown(state: _State) -> str:
    types = " ".join(one.value for one in state.stack)
    waiting = f", {_listed(state.prefixes)} without its move" if state.prefixes else ""
    return f"stack [{types}], {state.depth} saved modal states{waiting}"


def _listed(prefixes: frozenset[str]) -> str:
    return " and ".join(f"`{one}`" for one in sorted(prefixes))
