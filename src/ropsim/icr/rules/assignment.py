"""Rule V7: a value in every variable before it is read."""

from collections.abc import Container, Iterable, Iterator, Mapping
from itertools import pairwise
from typing import NamedTuple

from ropsim.core import Diagnostic
from ropsim.icr import diagnostics as kinds
from ropsim.icr.opcodes import ENDS_FLOW
from ropsim.icr.program import Procedure, Program, Step, text_place
from ropsim.icr.rules.calls import callees_first
from ropsim.icr.rules.flow import JUMPS, successors
from ropsim.icr.rules.held import Held, Slot, Slots, common, held_before, missing, ways

_NONE: Slots = frozenset()
_new = tuple.__new__
"""Makes a slot or a block in a fifth of the time of its class."""
_LEAVES = ENDS_FLOW | JUMPS
"""Behind these control may go on elsewhere, or nowhere."""


class _Block(NamedTuple):
    """Instructions that are carried out one after the other from the first one on.

    Attributes:
        reads: variables that it reads before assigning them, with the first place.
        gives: variables that are assigned behind it.
        following: the first instructions of the blocks to which it leads.
        is_return: whether its last instruction returns.
    """

    reads: Mapping[Slot, int]
    gives: Slots
    following: tuple[int, ...]
    is_return: bool


class Need(NamedTuple):
    """A variable that may be read without a value, and the instruction where that happens."""

    slot: Slot
    at: int


class Summary(NamedTuple):
    """Effect of a procedure on variables.

    Attributes:
        needs: its own variables, and global ones, that are read before a value was given in it; global ones
            may get theirs from the caller.
        needed: the global ones of them.
        assigns: global variables that have a value whenever it returns; None where it never does.
    """

    needs: tuple[Need, ...]
    needed: Slots
    assigns: Slots | None


def check_assignment(program: Program) -> Iterator[Diagnostic]:
    """Yield where a variable may be read without a value (V7); needs rules V1 to V6."""
    procedures = {one.name: one for one in program.procedures}
    for name, needs in unassigned(program).items():
        for need in needs:
            place = text_place(program, procedures[name], need.at)
            message = f"variable `{need.slot.name}` may be read in `{name}` before it has a value"
            yield kinds.NOT_ASSIGNED.at(place, message, hint="store a value first on every way")


def unassigned(program: Program) -> Mapping[str, tuple[Need, ...]]:
    """Return, by procedure, the variables that rule V7 refuses: locals, and in `main` also globals."""
    summaries: dict[str, Summary] = {}
    main = program.procedure("main")
    given = given_at_once(main.code, main.numbers) if main is not None else _NONE
    for procedure in callees_first(program):
        start = _NONE if procedure.name == "main" else given
        summaries[procedure.name] = summary(procedure, summaries, start)
    refused = {one.name: refused_needs(one.name, summaries[one.name]) for one in program.procedures}
    return {name: needs for name, needs in refused.items() if needs}


def refused_needs(procedure: str, found: Summary) -> tuple[Need, ...]:
    """Return the reads that rule V7 refuses in a procedure: of locals, and in `main` also of globals."""
    return tuple(need for need in found.needs if procedure == "main" or not need.slot.is_global)


def given_at_once(code: Iterable[Step], own: Container[str]) -> Slots:
    """Return the variables that `main` assigns before its first jump or call; all procedures can read them.

    Args:
        code: of `main`.
        own: names of its own variables.
    """
    given = []
    for step in code:
        if step.mnemonic == "CALL" or step.mnemonic in JUMPS:
            break
        if step.mnemonic == "STORE" and step.operands[0] not in own:
            given.append(Slot(str(step.operands[0]), is_global=True))
    return frozenset(given)


class Passage(NamedTuple):
    """Effect of a part of a procedure on variables; control enters it at its first instruction only.

    Attributes:
        needs: variables that are read before a value was given in it.
        gives: variables that are assigned whenever its end is reached; None if it never is.
    """

    needs: tuple[Need, ...]
    gives: Slots | None


def passage(part: Procedure, known: Mapping[str, Summary]) -> Passage:
    """Return the effect of a part of a procedure on variables.

    Args:
        part: its code, with the variables of the procedure that it uses; a jump behind its end leaves it.
        known: effects of its callees, by name.
    """
    end = len(part.code)
    if not end:
        return Passage((), _NONE)
    _, before, needs = _followed(part, known, _NONE, end)
    return Passage(tuple(needs.values()), before[end].all() if end in before else None)


def needs_of_passages(passages: Iterable[tuple[Passage, int]]) -> tuple[Need, ...]:
    """Return the variables that may be read without a value in parts that follow each other.

    Args:
        passages: effect of each, and the number of its instructions.
    """
    given: list[Slots] = []
    held: set[Slot] = set()
    needs: dict[Slot, Need] = {}
    start = 0
    for one, size in passages:
        for need in one.needs:
            if need.slot in held or need.slot in needs:
                continue
            if any(need.slot in slots for slots in reversed(given)):  # mostly one that is not far above
                held.add(need.slot)
            else:
                needs[need.slot] = Need(need.slot, start + need.at)
        if one.gives is None:
            break
        given.append(one.gives)
        start += size
    return tuple(needs.values())


def joint_passage(passages: Iterable[tuple[Passage, int]]) -> Passage:
    """Return the combined effect of consecutive parts.

    Args:
        passages: effect of each, and the number of its instructions.
    """
    held: set[Slot] = set()
    needs: dict[Slot, Need] = {}
    start = 0
    for one, size in passages:
        for need in one.needs:
            if need.slot not in held:
                needs.setdefault(need.slot, Need(need.slot, start + need.at))
        if one.gives is None:
            return Passage(tuple(needs.values()), None)
        held |= one.gives
        start += size
    return Passage(tuple(needs.values()), frozenset(held))


def summary(procedure: Procedure, known: Mapping[str, Summary], given: Slots) -> Summary:
    """Return the effect of a procedure on variables.

    Args:
        procedure: that passes the rules before.
        known: effects of its callees, by name.
        given: global variables that have a value before it is called.
    """
    start = frozenset(Slot(variable.name, is_global=False) for variable in procedure.parameters)
    blocks, before, found = _followed(procedure, known, start, -1)
    needs = {slot: need for slot, need in found.items() if slot not in given}
    ends = [held.with_also(blocks[index].gives) for index, held in before.items() if blocks[index].is_return]
    assigns = _global(common(ends).all()) - given if ends else None
    return Summary(tuple(needs.values()), _global(needs), assigns)


def _followed(
    procedure: Procedure, known: Mapping[str, Summary], start: Slots, end: int
) -> tuple[dict[int, _Block], dict[int, Held], dict[Slot, Need]]:
    """Return the blocks of code, the assigned variables before each reached one, and the missing ones.

    Args:
        procedure: the code.
        known: effects of its callees, by name.
        start: assigned variables at its start.
        end: the instruction behind which nothing follows, -1 where the code says so itself.
    """
    blocks = _blocks(procedure, known)
    if end >= 0:
        blocks[end] = _Block({}, _NONE, (), is_return=False)
    before = held_before(
        ways(lambda index: blocks[index].following), start, lambda index: blocks[index].gives
    )
    reads = {index: one.reads for index, one in blocks.items() if one.reads}
    needs: dict[Slot, Need] = {}
    for at, slot in sorted((blocks[index].reads[slot], slot) for index, slot in missing(before, reads)):
        needs.setdefault(slot, Need(slot, at))
    return blocks, before, needs


def _blocks(procedure: Procedure, known: Mapping[str, Summary]) -> dict[int, _Block]:
    """Return the blocks of code by their first instructions."""
    code = procedure.code
    starts = {0, len(code)}
    calls: dict[int, Summary] = {}
    for index, (mnemonic, operands) in enumerate(code):
        if mnemonic in _LEAVES:
            starts.add(index + 1)
            if mnemonic in JUMPS and isinstance(operands[0], int):
                starts.add(operands[0])
        elif mnemonic == "CALL":
            calls[index] = called = known[str(operands[0])]
            if called.assigns is None:
                starts.add(index + 1)
    return {first: _block(procedure, calls, first, last) for first, last in pairwise(sorted(starts))}


def _block(procedure: Procedure, calls: Mapping[int, Summary], first: int, last: int) -> _Block:
    """Return the block from an instruction up to another one."""
    own = procedure.numbers
    reads: dict[Slot, int] = {}
    gives: set[Slot] = set()
    for index, (mnemonic, operands) in enumerate(procedure.code[first:last], first):
        if mnemonic == "STORE":
            gives.add(_new(Slot, (operands[0], operands[0] not in own)))
        elif mnemonic == "LOAD":
            slot = _new(Slot, (operands[0], operands[0] not in own))
            if slot not in gives:
                reads.setdefault(slot, index)
        elif mnemonic == "CALL":
            for slot in calls[index].needed - gives:
                reads.setdefault(slot, index)
            gives |= calls[index].assigns or _NONE
    never_returns = last - 1 in calls and calls[last - 1].assigns is None
    following = () if never_returns else successors(procedure, last - 1)
    return _new(_Block, (reads, frozenset(gives), following, procedure.code[last - 1].mnemonic == "RET"))


def _global(slots: Iterable[Slot]) -> Slots:
    return frozenset(slot for slot in slots if slot.is_global)
