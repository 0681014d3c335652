"""Actuators of MJCF: their limits at the joints; their structure is reported as lost."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

from ropsim.exchange.assembly.description import Connection, Motion
from ropsim.exchange.files.values import numbers_of
from ropsim.exchange.files.xml_tree import Element
from ropsim.exchange.losses.gathered import Topic
from ropsim.exchange.losses.loss_diagnostics import LOST_DRIVE
from ropsim.exchange.losses.notes import Notes
from ropsim.exchange.mjcf.defaults import MAIN
from ropsim.exchange.mjcf.joints import range_of
from ropsim.exchange.mjcf.settings import Settings

_AS_MOTORS = Topic(LOST_DRIVE, "control of actuators", "actuators {} go over as sources of effort")
_ABSENT = Topic(
    LOST_DRIVE,
    "actuators of other joints",
    "actuators of joints {} are left out: the robot has no such joints",
)
_UNBOUNDED = Topic(
    LOST_DRIVE,
    "efforts without bounds",
    "joints {} have actuators with limits and others without: together they have no greatest effort",
    "write the greatest effort into `actuatorfrcrange` of the joints",
)
_Ranges = Mapping[str, Sequence[tuple[float, float] | None]]
"""Least and greatest effort of each actuator at its joint, by the joint; None for one without bounds."""


def axis_names(connections: Iterable[Connection], root: Element) -> tuple[str, ...]:
    """Return the joints that are driven: joints with actuators in the order of these, then the others."""
    free = [one.name for one in connections if one.motion is not Motion.NONE and one.following is None]
    named = [_joint_of(one) for one in _actuators(root)]
    return tuple(dict.fromkeys([*(name for name in named if name in set(free)), *free]))


def driven(
    connections: Iterable[Connection], root: Element, settings: Settings, notes: Notes
) -> tuple[Connection, ...]:
    """Return connections whose efforts are not above those of their actuators together."""
    ranges: dict[str, list[tuple[float, float] | None]] = {}
    others: list[Element] = []
    for one in _actuators(root):
        if one.name != "motor":
            others.append(one)
        ranges.setdefault(_joint_of(one), []).append(_range(settings.whole(one, MAIN), settings, notes))
    if others:
        notes.gather(_AS_MOTORS, others[0].span, (one.name for one in others))
    _note_lost(connections, ranges, root, notes)
    efforts = {name: _sum(each) for name, each in ranges.items()}
    return tuple(
        replace(one, limits=replace(one.limits, effort=_least(one.limits.effort, efforts.get(one.name))))
        for one in connections
    )


def _note_lost(connections: Iterable[Connection], ranges: _Ranges, root: Element, notes: Notes) -> None:
    """Note the joints whose actuators have limits that do not go over."""
    known = {one.name for one in connections}
    span = root.children[0].span
    absent = [name for name in ranges if name and name not in known]
    if absent:
        notes.gather(_ABSENT, span, absent)
    unbounded = [name for name, each in ranges.items() if name in known and None in each and any(each)]
    if unbounded:
        notes.gather(_UNBOUNDED, span, unbounded)


def _sum(ranges: Iterable[tuple[float, float] | None]) -> float | None:
    """Return the greatest effort of actuators together: MuJoCo adds their forces."""
    lower = upper = 0.0
    for one in ranges:
        if one is None:
            return None
        lower, upper = lower + one[0], upper + one[1]
    return max(abs(lower), abs(upper)) or None


def _least(*efforts: float | None) -> float | None:
    return min((one for one in efforts if one), default=None)


def _actuators(root: Element) -> list[Element]:
    return [part for actuator in root.all("actuator") for part in actuator.children]


def _joint_of(actuator: Element) -> str:
    attributes = actuator.attributes
    return attributes.get("joint", attributes.get("jointinparent", "")).strip()


def _range(actuator: Element, settings: Settings, notes: Notes) -> tuple[float, float] | None:
    """Return the efforts at the joint [N·m | N]; None where the actuator does not bound them."""
    gear = numbers_of(actuator, "gear", notes, (1.0, 0.0, 0.0, 0.0, 0.0, 0.0), least=1)[0]
    force = range_of(actuator, "forcerange", settings, notes)
    control = range_of(actuator, "ctrlrange", settings, notes) if actuator.name == "motor" else None
    ends = control or force
    if ends is None:
        return None
    if force is not None:
        ends = min(max(ends[0], force[0]), force[1]), min(max(ends[1], force[0]), force[1])
    first, second = gear * ends[0], gear * ends[1]
    return min(first, second), max(first, second)
