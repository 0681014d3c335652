"""Actuators of MJCF: their limits at the joints; their structure is reported as lost."""

from collections.abc import Iterable
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


def axis_names(connections: Iterable[Connection], root: Element) -> tuple[str, ...]:
    """Return the joints that are driven: joints with actuators in the order of these, then the others."""
    free = [one.name for one in connections if one.motion is not Motion.NONE and one.following is None]
    named = [_joint_of(one) for one in _actuators(root)]
    return tuple(dict.fromkeys([*(name for name in named if name in set(free)), *free]))


def driven(
    connections: Iterable[Connection], root: Element, settings: Settings, notes: Notes
) -> tuple[Connection, ...]:
    """Return connections whose efforts are not above those of their actuators."""
    efforts: dict[str, float] = {}
    others: list[Element] = []
    for one in _actuators(root):
        if one.name != "motor":
            others.append(one)
        most = _most(settings.whole(one, MAIN), settings, notes)
        if most:
            efforts.setdefault(_joint_of(one), most)
    if others:
        notes.gather(_AS_MOTORS, others[0].span, (one.name for one in others))
    return tuple(
        replace(one, limits=replace(one.limits, effort=_least(one.limits.effort, efforts.get(one.name))))
        for one in connections
    )


def _least(*efforts: float | None) -> float | None:
    return min((one for one in efforts if one), default=None)


def _actuators(root: Element) -> list[Element]:
    return [part for actuator in root.all("actuator") for part in actuator.children]


def _joint_of(actuator: Element) -> str:
    attributes = actuator.attributes
    return attributes.get("joint", attributes.get("jointinparent", "")).strip()


def _most(actuator: Element, settings: Settings, notes: Notes) -> float | None:
    """Return the greatest effort at the joint [N·m | N]; nothing where the actuator does not say it."""
    gear = abs(numbers_of(actuator, "gear", notes, (1.0, 0.0, 0.0, 0.0, 0.0, 0.0), least=1)[0])
    keys = ["forcerange", "ctrlrange"] if actuator.name == "motor" else ["forcerange"]
    ranges = [range_of(actuator, key, settings, notes) for key in keys]
    bounds = [max(map(abs, one)) for one in ranges if one]
    return gear * min(bounds) if bounds and min(bounds) > 0.0 else None
