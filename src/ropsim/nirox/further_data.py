"""Data of a file that the model does not hold: kept, so that writing the robot writes them again."""

from collections.abc import Mapping
from dataclasses import field
from types import MappingProxyType

from ropsim.core import frozen_dataclass
from ropsim.model import RobotModel
from ropsim.nirox.building import UNSET, FurtherFrame, Key
from ropsim.nirox.readers.seen import Seen
from ropsim.nirox.writers.built import built
from ropsim.part21 import Instance, Record, Reference, Value, references

_OWN: Mapping[str, tuple[int, ...]] = MappingProxyType(
    {
        "RIGID_LINK_MASS_PROPERTIES": (4,),
        "DC_SERVO_MOTOR": (8, 9, 10),
        "IDEAL_EFFORT_SOURCE": (2,),
        "GEAR_TRANSMISSION": (2, 3),
        "LINK_GEOMETRY": (2, 3),
        "PARAMETER_ORIGIN": (2,),
    }
)
"""Parameters that the model does not hold, in addition to all texts."""
_REPLACED = frozenset(
    ("STRIBECK_FRICTION", "LUGRE_FRICTION", "LOAD_DEPENDENT_FRICTION", "SCREW_TRANSMISSION")
)
"""Entities that the model holds in a part only, and that are written again unchanged."""


@frozen_dataclass
class FurtherData:
    """Data of a file in addition to its robot.

    Attributes:
        instances: all of the file, by their numbers.
        keys: keys of the instances that the model holds.
        numbers: of the instances that it does not hold, in the order of the file.
        changes: of instances that it holds: parameters as they would be written, and as the file has them.
        further: further elements of lists in these instances, by key and parameter.
        replaced: of partially held instances: the written instance, and the number of the original.
        frames: other frames than the mechanical interface.
    """

    instances: Mapping[int, Instance] = field(default_factory=dict)
    keys: Mapping[int, Key] = field(default_factory=dict)
    numbers: tuple[int, ...] = ()
    changes: Mapping[tuple[Key, int], tuple[Value, Value]] = field(default_factory=dict)
    further: Mapping[tuple[Key, int], tuple[int, ...]] = field(default_factory=dict)
    replaced: Mapping[Key, tuple[tuple[Value, ...], int]] = field(default_factory=dict)
    frames: tuple[FurtherFrame, ...] = ()


NOTHING = FurtherData()


def further_data_of(seen: Seen, robot: RobotModel, frames: tuple[FurtherFrame, ...]) -> FurtherData:
    """Return the data of a file in addition to its robot.

    Args:
        seen: the file after reading.
        robot: that was read.
        frames: of the file, except the mechanical interface.
    """
    records = built(robot, frames).building.records
    changes: dict[tuple[Key, int], tuple[Value, Value]] = {}
    further: dict[tuple[Key, int], tuple[int, ...]] = {}
    replaced: dict[Key, tuple[tuple[Value, ...], int]] = {}
    unwritten: set[int] = set()
    for number, key in seen.keys.items():
        original = seen.population.instances[number].records[0]
        own = records.get(key, (None,))[0]
        if original.keyword in _REPLACED:
            if own is None:
                unwritten.add(number)
            else:
                replaced[key] = own.values, number
        elif own is not None and (own.keyword, len(own.values)) == (original.keyword, len(original.values)):
            _compare(seen, key, own, original, changes, further)
    instances = seen.instances
    numbers = tuple(one for one in instances if one not in seen.taken or one in unwritten)
    return FurtherData(instances, dict(seen.keys), numbers, changes, further, replaced, frames)


def _compare(
    seen: Seen,
    key: Key,
    own: Record,
    original: Record,
    changes: dict[tuple[Key, int], tuple[Value, Value]],
    further: dict[tuple[Key, int], tuple[int, ...]],
) -> None:
    """Note the parameters of an instance that the file has otherwise and that the model does not hold."""
    for place, (ours, theirs) in enumerate(zip(own.values, original.values, strict=True)):
        if isinstance(theirs, tuple):
            others = tuple(one for one in references(theirs) if one not in seen.taken)
            if others:
                further[key, place] = others
        elif ours != theirs and not isinstance(theirs, Reference):
            is_text = isinstance(theirs, str) and (isinstance(ours, str) or ours is UNSET)
            if is_text or place in _OWN.get(own.keyword, ()):
                changes[key, place] = ours, theirs
