"""Which variables hold a value at each instruction: sets that only grow along a way, kept as chains.

A set is a chain: the variables that came last, and the set before them. So all sets of a procedure together
take memory in proportion to its code. At joins the variables of both chains beyond their common end are kept.
Instructions are processed in reverse postorder until nothing changes, which takes a single pass if each loop
has a single entry (G. A. Kildall, "A unified approach to global program optimization", POPL 1973; J. B. Kam
and J. D. Ullman, "Global data flow analysis and iterative algorithms", J. ACM 1976).
"""

from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import reduce
from typing import NamedTuple

from ropsim.core import frozen_dataclass, frozen_without_equality, maker


class Slot(NamedTuple):
    """A variable as one procedure sees it."""

    name: str
    is_global: bool


Slots = frozenset[Slot]


@frozen_without_equality
class Held:
    """A set of variables.

    Attributes:
        last: variables added last.
        before: the set before that, None for none.
        depth: number of links before this one.
    """

    last: Slots
    before: "Held | None" = None
    depth: int = 0

    def with_also(self, slots: Slots) -> "Held":
        """Return a set that also has these variables."""
        return _held(slots, self, self.depth + 1) if slots else self

    def all(self) -> Slots:
        """Return the variables of the whole chain."""
        found: list[Slots] = []
        link: Held | None = self
        while link is not None:
            found.append(link.last)
            link = link.before
        return _union(found)


_held = maker(Held)


@frozen_dataclass
class Ways:
    """The ways through the instructions of a procedure.

    Attributes:
        order: instructions that are reached, in topological order of the paths without loops.
        sources: from where each of them is reached.
    """

    order: tuple[int, ...]
    sources: Mapping[int, tuple[int, ...]]


def ways(following: Callable[[int], Iterable[int]]) -> Ways:
    """Return the ways that lead from instruction 0 to its successors, and so on."""
    left: list[int] = []
    sources: dict[int, list[int]] = {0: []}
    path: list[tuple[int, Iterator[int]]] = [(0, iter(following(0)))]
    while path:
        index, targets = path[-1]
        target = next(targets, None)
        if target is None:
            left.append(index)
            path.pop()
        elif target in sources:
            sources[target].append(index)
        else:
            sources[target] = [index]
            path.append((target, iter(following(target))))
    return Ways(tuple(reversed(left)), {target: tuple(found) for target, found in sources.items()})


def held_before(way: Ways, start: Slots, given: Callable[[int], Slots]) -> dict[int, Held]:
    """Return the variables assigned before each instruction, on every path to it.

    Args:
        way: through the procedure.
        start: assigned variables at its start.
        given: variables assigned by an instruction.
    """
    place = {index: number for number, index in enumerate(way.order)}
    back: dict[int, list[int]] = {}
    for index, sources in way.sources.items():
        for source in sources:
            if place[source] >= place[index]:
                back.setdefault(index, []).append(source)
    root = Held(start)
    bounds: dict[int, Held] = {}
    while True:
        before, after = _passed(way, root, given, bounds)
        # The set at the end of a loop includes the set at its entry, unless the loop has a second entry.
        held = {index: common([before[index], *(after[one] for one in back[index])]) for index in back}
        smaller = {index: one for index, one in held.items() if _lacks(one, before[index])}
        if not smaller:
            return before
        bounds |= smaller


def common(sets: list[Held]) -> Held:
    """Return the intersection of one or more sets; the first one itself if equal."""
    if len(sets) == 1:
        return sets[0]
    deepest_first = sorted(sets[1:], key=lambda one: -one.depth)
    return _both(sets[0], reduce(_both, deepest_first))


def missing(before: Mapping[int, Held], read: Mapping[int, Iterable[Slot]]) -> list[tuple[int, Slot]]:
    """Return the variables that an instruction reads and that hold no value before it, in no order."""
    asked: dict[Held, list[int]] = {}
    for index in read:
        if index in before:
            asked.setdefault(before[index], []).append(index)
    further = _tree(asked)
    count: dict[Slot, int] = {}
    found: list[tuple[int, Slot]] = []
    work = [(link, 1) for link in further.get(None, ())]
    while work:
        link, change = work.pop()
        for slot in link.last:
            count[slot] = count.get(slot, 0) + change
        if change > 0:
            for index in asked.get(link, ()):
                found += [(index, slot) for slot in read[index] if not count.get(slot, 0)]
            work.append((link, -1))
            work += [(one, 1) for one in further.get(link, ())]
    return found


def _tree(links: Iterable[Held]) -> dict[Held | None, list[Held]]:
    """Return which links come after each, as far as they lead to those given; None for those at the start."""
    further: dict[Held | None, list[Held]] = {}
    seen: set[Held] = set()
    for one in links:
        link: Held | None = one
        while link is not None and link not in seen:
            seen.add(link)
            further.setdefault(link.before, []).append(link)
            link = link.before
    return further


def _union(parts: Iterable[Slots]) -> Slots:
    none: Slots = frozenset()
    return none.union(*parts)


def _lacks(one: Held, other: Held) -> bool:
    """Return whether a set, which is a subset of another one, is smaller."""
    return one is not other and one.all() != other.all()


def _passed(
    way: Ways, start: Held, given: Callable[[int], Slots], bounds: Mapping[int, Held]
) -> tuple[dict[int, Held], dict[int, Held]]:
    """Go through all instructions once; return the assigned variables before and after each."""
    before: dict[int, Held] = {}
    after: dict[int, Held] = {}
    for index in way.order:
        sources = [after[source] for source in way.sources[index] if source in after]
        if len(sources) == 1 and index and index not in bounds:
            before[index] = sources[0]
            after[index] = sources[0].with_also(given(index))
            continue
        if index in bounds:
            sources.append(bounds[index])
        if index == 0:
            sources.append(start)
        before[index] = common(sources)
        after[index] = before[index].with_also(given(index))
    return before, after


def _both(one: Held, other: Held) -> Held:
    """Return the intersection of two sets, `one` itself if equal."""
    beyond: list[Slots] = []
    others: list[Slots] = []
    here, there = one, other
    while here is not there:
        if here.depth >= there.depth:
            assert here.before is not None
            beyond.append(here.last)
            here = here.before
        else:
            assert there.before is not None
            others.append(there.last)
            there = there.before
    mine = _union(beyond)
    shared = mine & _union(others)
    return one if len(shared) == len(mine) else here.with_also(shared)
