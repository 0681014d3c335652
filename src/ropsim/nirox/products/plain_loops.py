"""Closed chains of files of AP242: where each is cut, and which of its joints is an axis.

AP242 says that joints form a loop and not which of them follow. Each loop is cut at its first joint; of its
other joints of one freedom the first is an axis, unless an earlier loop contains it: linkages of machines,
four-bars, slider-cranks, parallelograms, have a single freedom in each loop.
"""

from collections.abc import Mapping, Sequence

from ropsim.core import frozen_dataclass
from ropsim.part21 import Record, Reference


@frozen_dataclass
class Loops:
    """Roles of the pairs of a file in its loops.

    Attributes:
        cuts: loop and pair of each cut, by their numbers.
        passive: pairs that are no axes.
    """

    cuts: tuple[tuple[int, int], ...]
    passive: frozenset[int]


def loops_of(known: Mapping[int, Record], pairs: Sequence[int], single: Sequence[int]) -> Loops:
    """Return the cuts of the loops of a file, and the pairs that follow.

    Args:
        known: records of the file by their numbers.
        pairs: of the mechanism.
        single: pairs with one freedom.
    """
    pair_of = {joint: pair for pair in pairs for joint in _references(known.get(pair), 5)}
    cuts: list[tuple[int, int]] = []
    axes, passive = set[int](), set[int]()
    for number, record in known.items():
        if record.keyword != "KINEMATIC_LOOP":
            continue
        edges = [joint for edge in _references(record, 1) for joint in _references(known.get(edge), 3)]
        members = [pair_of[joint] for joint in edges if joint in pair_of]
        if not members or members[0] in passive | axes:
            continue
        first, *others = members
        cuts.append((number, first))
        passive.add(first)
        free = [pair for pair in single if pair in others and pair not in passive]
        if not axes.intersection(free):
            axes.update(free[:1])
        passive.update(pair for pair in free if pair not in axes)
    return Loops(tuple(cuts), frozenset(passive))


def _references(record: Record | None, place: int) -> list[int]:
    if record is None or place >= len(record.values):
        return []
    value = record.values[place]
    listed = value if isinstance(value, tuple) else (value,)
    return [one.number for one in listed if isinstance(one, Reference)]
