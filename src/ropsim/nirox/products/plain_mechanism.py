"""Files of AP242 that hold a mechanism and say nothing of an arm: the arm that follows from it."""

from collections.abc import Iterator
from dataclasses import replace

from ropsim.nirox.building import UNSET
from ropsim.nirox.products.plain_loops import loops_of
from ropsim.part21 import ExchangeFile, Instance, Record, Reference, Value

SCHEMA = "AP242"
"""How the names of the schemas begin."""
_SINGLE = ("REVOLUTE_PAIR", "PRISMATIC_PAIR", "SCREW_PAIR")
_NO_ARM: tuple[Value, ...] = ("", "")
_GRAVITY: tuple[Value, ...] = (0.0, 0.0, -9.81)


def with_arm(file: ExchangeFile) -> ExchangeFile | None:
    """Return a file with an arm of its first mechanism; None if it has no mechanism.

    The base is the link that the file calls so, else the one to which no joint leads; axes are all pairs of
    one freedom except followers in closed chains (`plain_loops`), in the order of the file; the rest position
    is the first state of the mechanism.

    Args:
        file: without an arm.
    """
    known = {one.number: one.records[0] for one in file.instances}
    mechanism = next(_all(known, "MECHANISM_REPRESENTATION"), None)
    if mechanism is None or len(known[mechanism].values) < 2:
        return None
    pairs = [
        one for relation in _references(known[mechanism], 1) for one in _references(known.get(relation), 5)
    ]
    ends = [
        [end for place in (1, 2) for end in _references(known.get(joint), place)]
        for pair in pairs
        for joint in _references(known.get(pair), 5)
    ]
    base = _base(known) or next((one[0] for one in ends if one and _is_root(one[0], ends)), None)
    if base is None:
        return None
    axes = [
        one for one in pairs if one in known and known[one].keyword.removesuffix("_WITH_RANGE") in _SINGLE
    ]
    loops = loops_of(known, pairs, axes)
    axes = [one for one in axes if one not in loops.passive]
    states = [
        one
        for one in _all(known, "MECHANISM_STATE_REPRESENTATION")
        if mechanism in _references(known[one], 3)
    ]
    home: Value = Reference(states[0]) if states else UNSET
    name = known[mechanism].values[0]
    ends_of_arm = Reference(mechanism), Reference(base), tuple(map(Reference, dict.fromkeys(axes)))
    arm = Record("ROBOT_ARM", (name, *_NO_ARM, *ends_of_arm, (), _GRAVITY, home))
    added = [arm, *(Record("LOOP_CUT", (Reference(loop), Reference(pair))) for loop, pair in loops.cuts)]
    made = [Instance(number, (record,)) for number, record in enumerate(added, start=max(known) + 1)]
    return replace(file, instances=(*file.instances, *made))


def _base(known: dict[int, Record]) -> int | None:
    """Return the link that a property of the file calls the base of its mechanism."""
    for number in _all(known, "KINEMATIC_PROPERTY_MECHANISM_REPRESENTATION"):
        for representation in _references(known[number], 2):
            for link in _references(known.get(representation), 3):
                return link
    return None


def _is_root(link: int, ends: list[list[int]]) -> bool:
    return all(link != one[-1] for one in ends)


def _all(known: dict[int, Record], keyword: str) -> Iterator[int]:
    return (number for number, record in known.items() if record.keyword == keyword)


def _references(record: Record | None, place: int) -> list[int]:
    """Return the instances that a parameter refers to."""
    if record is None or place >= len(record.values):
        return []
    value = record.values[place]
    listed = value if isinstance(value, tuple) else (value,)
    return [one.number for one in listed if isinstance(one, Reference)]
