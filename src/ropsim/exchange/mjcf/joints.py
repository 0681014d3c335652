"""Joints of MJCF: hinges and slides about points of a body."""

from collections.abc import Iterator
from dataclasses import replace
from math import inf

import numpy as np

from ropsim.exchange.assembly.description import Connection, Limits, Motion, Resistance
from ropsim.exchange.assembly.joint_limits import UNSAID
from ropsim.exchange.files.values import direction_of, number_of, numbers_of
from ropsim.exchange.files.xml_tree import Element
from ropsim.exchange.losses.diagnostics import BAD_NUMBER, JOINT_IMPOSSIBLE
from ropsim.exchange.losses.gathered import Topic, shown
from ropsim.exchange.losses.loss_diagnostics import LOST_MOTION
from ropsim.exchange.losses.notes import Notes
from ropsim.exchange.mjcf.settings import Settings
from ropsim.model import WITHOUT_END
from ropsim.spatial import Pose

_FREE = Limits(-WITHOUT_END, WITHOUT_END)
_SPRING = Topic(LOST_MOTION, "springs", "the springs of joints {} do not go over")
_DAMPING = Topic(
    LOST_MOTION, "damping that grows", "damping that grows with the speed does not go over, of joints {}"
)
_MOTIONS = {"hinge": Motion.TURN, "slide": Motion.SLIDE}


def is_free(body: Element) -> bool:
    """Return whether a body moves about freely."""
    return any(frees(one) for one in body.children)


def frees(joint: Element) -> bool:
    """Return whether an element lets its body move about freely."""
    return joint.name == "freejoint" or (joint.name == "joint" and joint.attributes.get("type") == "free")


def free_base(world: Element) -> Element | None:
    """Return the free body with the most joints, which is the base if no joint stands on a fixed one."""
    counts: list[tuple[int, Element]] = []
    for body in _bodies(world):
        joints = sum(not frees(one) for one in _descendants(body) if one.name == "joint")
        if joints and not is_free(body):
            return None
        counts.append((joints, body))
    most = max((count for count, _ in counts), default=0)
    return next((body for count, body in counts if count == most), None) if most else None


def _bodies(element: Element) -> Iterator[Element]:
    """Yield the bodies of a world, including those in frames."""
    waiting = list(reversed(element.children))
    while waiting:
        one = waiting.pop()
        if one.name == "body":
            yield one
        elif one.name == "frame":
            waiting += reversed(one.children)


def _descendants(element: Element) -> Iterator[Element]:
    waiting = [element]
    while waiting:
        one = waiting.pop()
        yield one
        waiting += one.children


def connection_of(
    joint: Element, name: str, ends: tuple[str, str], X: Pose, settings: Settings, notes: Notes
) -> Connection:
    """Return the connection of a joint; its child frame stands in the anchor of the joint.

    Args:
        joint: with the attributes of its class.
        name: of the joint.
        ends: names of the bodies that it joins.
        X: frame of the moved body in that of the body that carries it, where the joint has not moved it.
        settings: of the file.
        notes: for errors.
    """
    kind = joint.attributes.get("type", "hinge")
    if kind not in _MOTIONS:
        words = f"joint `{name}` is of type `{shown(kind)}`, which no single drive moves"
        notes.add(JOINT_IMPOSSIBLE, joint.span, words, f"allowed are {', '.join(_MOTIONS)}")
    made = Connection(
        name, _MOTIONS.get(kind, Motion.TURN), *ends, X @ Pose(anchor_of(joint, notes)), joint.span
    )
    unit = settings.angle if made.motion is Motion.TURN else 1.0
    if number_of(joint, "stiffness", notes):
        notes.gather(_SPRING, joint.span, [name])
    return replace(
        made,
        axis=direction_of(joint, "axis", notes, (0.0, 0.0, 1.0)),
        zero=number_of(joint, "ref", notes) * unit,
        limits=_limits(joint, name, made.motion, unit, settings, notes),
        resistance=_resistance(joint, name, notes),
    )


def anchor_of(joint: Element, notes: Notes) -> np.ndarray:
    """Return the point about which a joint turns, in the frame of its body [m], shape (3,)."""
    return np.array(numbers_of(joint, "pos", notes, (0.0, 0.0, 0.0)))


def _limits(
    joint: Element, name: str, motion: Motion, unit: float, settings: Settings, notes: Notes
) -> Limits:
    effort = _most(joint, "actuatorfrcrange", notes)
    said = joint.attributes.get("limited", "auto")
    limited = said == "true" or (said == "auto" and settings.limits == "true" and "range" in joint.attributes)
    if not limited:
        return replace(UNSAID if motion is Motion.SLIDE else _FREE, effort=effort)
    lower, upper = (unit * value for value in numbers_of(joint, "range", notes, (0.0, 0.0)))
    if lower > upper:
        words = f"joint `{name}` has the lower limit {lower:g} and the upper limit {upper:g} [rad, m]"
        notes.add(BAD_NUMBER, joint.span, words, "the lower limit must be the smaller number")
        return _FREE
    return Limits(lower, upper, effort=effort)


def _most(element: Element, key: str, notes: Notes) -> float | None:
    if key not in element.attributes:
        return None
    lower, upper = numbers_of(element, key, notes, (0.0, 0.0))
    most = max(abs(lower), abs(upper))
    return most if 0.0 < most < inf else None


def _resistance(joint: Element, name: str, notes: Notes) -> Resistance:
    viscous, *rest = numbers_of(joint, "damping", notes, (0.0, 0.0, 0.0), least=1)
    if any(rest):
        notes.gather(_DAMPING, joint.span, [name])
    dry, rotor = number_of(joint, "frictionloss", notes), number_of(joint, "armature", notes)
    if min(viscous, dry, rotor) < 0.0:
        words = f"friction or armature of joint `{name}` is negative"
        notes.add(BAD_NUMBER, joint.span, words, "friction resists: check the sign")
    return Resistance(viscous, dry, rotor)
