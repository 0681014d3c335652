"""Combined results of consecutive parts of the control statements."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import chain
from typing import TypeVar

from ropsim.core import Diagnostic, Span, frozen_dataclass
from ropsim.language.check.one_part import CheckedPart
from ropsim.language.check.scope.body import Made, Unfit
from ropsim.program import Block, Local, SignalUse

T = TypeVar("T")


@frozen_dataclass
class CheckedParts:
    """Some checked parts.

    Attributes:
        block: their statements, as far as they are correct.
        locals: variables that they make, by name.
        found: findings, in the order in which they were made.
        made: variables that an assignment made first, and where.
        declared: variables of all tasks that they declare by their first values, and where.
        unfit: values among the findings that do not fit first values.
        quantities: variables with whole numbers that stand in place of a quantity, with its unit.
        read: names of the variables that are read.
        signals: that they name, by name.
        calls: tasks that they call, and where.
        impossible: arcs and curves of them whose points make none.
        may_end: whether something in one of them is not reached, or nothing behind one of its statements.
    """

    block: Block
    locals: Mapping[str, Local]
    found: tuple[Diagnostic, ...]
    made: Mapping[str, Made]
    declared: Mapping[str, Made]
    unfit: tuple[Unfit, ...]
    quantities: frozenset[tuple[str, str]]
    read: frozenset[str]
    signals: Mapping[str, SignalUse]
    calls: tuple[tuple[str, Span], ...]
    impossible: tuple[Diagnostic, ...]
    may_end: bool


def joined(parts: Sequence[CheckedPart], impossible: Iterable[tuple[Diagnostic, ...]]) -> CheckedParts:
    """Return the combined results of consecutive parts."""
    return CheckedParts(
        tuple(chain.from_iterable(one.block for one in parts)),
        first_of({local.name: local for local in one.locals} for one in parts),
        tuple(chain.from_iterable(one.found for one in parts)),
        first_of(one.made for one in parts),
        first_of(one.declared for one in parts),
        tuple(chain.from_iterable(one.unfit for one in parts)),
        frozenset().union(*(one.quantities for one in parts)),
        frozenset().union(*(one.read for one in parts)),
        {signal.name: signal for one in parts for signal in one.signals},
        tuple(chain.from_iterable(one.calls for one in parts)),
        tuple(chain.from_iterable(impossible)),
        any(one.late or one.end is not None for one in parts),
    )


@frozen_dataclass
class Together:
    """Combined evidence of all groups of parts for variables.

    Attributes:
        locals: variables that they make.
        read: names of the variables that are read.
        has_unread: whether a variable that an assignment made is not read.
    """

    locals: tuple[Local, ...]
    read: frozenset[str]
    has_unread: bool


def together(
    groups: Sequence[CheckedParts], before: Sequence[CheckedParts], known: Together | None
) -> Together:
    """Return the combined evidence of groups; `known` is that of the groups `before`, which saves time."""
    if known is not None and len(groups) == len(before) and all(map(_are_alike, groups, before)):
        return known
    read: frozenset[str] = frozenset().union(*(one.read for one in groups))
    is_read = all(one.made.keys() <= read for one in groups)
    return Together(tuple(first_of(one.locals for one in groups).values()), read, not is_read)


def _are_alike(one: CheckedParts, other: CheckedParts) -> bool:
    """Return whether two groups have the same evidence for variables."""
    if one is other:
        return True
    are_locals = [*one.locals.values()] == [*other.locals.values()]  # the order counts
    return are_locals and one.read == other.read and one.made.keys() == other.made.keys()


def late(parts: Iterable[CheckedPart]) -> Iterator[tuple[Span, Span]]:
    """Yield where statements are not reached, each with that before it, which does not go on."""
    end: Span | None = None
    for one in parts:
        if end is not None:
            if one.block and one.block[0].span != end:
                yield one.block[0].span, end
            if one.block:
                return
            continue
        yield from one.late
        if one.end is not None and one.end + 1 < len(one.block):
            return
        end = one.block[one.end].span if one.end is not None else None


def first_of(tables: Iterable[Mapping[str, T]]) -> dict[str, T]:
    """Return the first value of each name, in the order of the names."""
    found: dict[str, T] = {}
    for one in tables:
        if found.keys().isdisjoint(one):
            found |= one
        else:
            found |= {name: value for name, value in one.items() if name not in found}
    return found
