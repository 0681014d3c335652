"""Joints of MJCF: hinges and slides about points of a body."""

from dataclasses import replace

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.exchange.assembly.description import Connection, Limits, Motion, Resistance
from ropsim.exchange.assembly.joint_limits import UNSAID
from ropsim.exchange.files.values import direction_of, number_of, numbers_of
from ropsim.exchange.files.xml_tree import Element
from ropsim.exchange.losses.diagnostics import BAD_NUMBER, JOINT_IMPOSSIBLE
from ropsim.exchange.losses.gathered import Topic, shown
from ropsim.exchange.losses.loss_diagnostics import LOST_MOTION
from ropsim.exchange.losses.notes import Notes
from ropsim.exchange.mjcf.keywords import Keyword, keyword_of
from ropsim.exchange.mjcf.settings import Settings
from ropsim.model import WITHOUT_END
from ropsim.spatial import Pose

_FREE = Limits(-WITHOUT_END, WITHOUT_END)
_SPRING = Topic(LOST_MOTION, "springs", "the springs of joints {} do not go over")
_DAMPING = Topic(
    LOST_MOTION, "damping that grows", "damping that grows with the speed does not go over, of joints {}"
)
_MOTIONS = {"hinge": Motion.TURN, "slide": Motion.SLIDE}


@frozen_dataclass
class PlacedJoint:
    """A joint of a body.

    Attributes:
        element: of it, with the attributes of its class.
        frame: in which it says point and axis, in the frame of its body.
    """

    element: Element
    frame: Pose

    def anchor(self, notes: Notes) -> Pose:
        """Return the point about which the joint turns as a frame of the body, with the axes of that."""
        point = numbers_of(self.element, "pos", notes, (0.0, 0.0, 0.0))
        return Pose((self.frame @ Pose(np.array(point))).position)

    def axis(self, notes: Notes) -> tuple[float, float, float]:
        """Return the direction of the joint in the frame of its body."""
        own = direction_of(self.element, "axis", notes, (0.0, 0.0, 1.0))
        if self.frame.orientation[0] == 1.0:
            return own
        x, y, z = (self.frame.rotation() @ np.array(own)).tolist()
        return (x, y, z)


def connection_of(
    placed: PlacedJoint, name: str, ends: tuple[str, str], X: Pose, settings: Settings, notes: Notes
) -> Connection:
    """Return the connection of a joint; its child frame stands in the anchor of the joint.

    Args:
        placed: the joint.
        name: of the joint.
        ends: names of the bodies that it joins.
        X: frame of the moved body in that of the body that carries it, where the joint has not moved it.
        settings: of the file.
        notes: for errors.
    """
    joint = placed.element
    kind = joint.attributes.get("type", "hinge")
    if kind not in _MOTIONS:
        words = f"joint `{name}` is of type `{shown(kind)}`, which no single drive moves"
        notes.add(JOINT_IMPOSSIBLE, joint.span, words, f"allowed are {', '.join(_MOTIONS)}")
    made = Connection(name, _MOTIONS.get(kind, Motion.TURN), *ends, X @ placed.anchor(notes), joint.span)
    unit = settings.angle_unit if made.motion is Motion.TURN else 1.0
    if any(numbers_of(joint, "stiffness", notes, (0.0, 0.0, 0.0), least=1)):
        notes.gather(_SPRING, joint.span, [name])
    return replace(
        made,
        axis=placed.axis(notes),
        zero=number_of(joint, "ref", notes) * unit,
        limits=_limits(joint, made.motion, unit, settings, notes),
        resistance=_resistance(joint, name, notes),
    )


def _limits(joint: Element, motion: Motion, unit: float, settings: Settings, notes: Notes) -> Limits:
    efforts = range_of(joint, "actuatorfrcrange", settings, notes)
    effort = max(map(abs, efforts)) if efforts else None
    ends = range_of(joint, "range", settings, notes)
    if ends is None:
        return replace(UNSAID if motion is Motion.SLIDE else _FREE, effort=effort)
    lower, upper = (unit * value for value in ends)
    return Limits(lower, upper, effort=effort)


def range_of(element: Element, key: str, settings: Settings, notes: Notes) -> tuple[float, float] | None:
    """Return a range of a joint or actuator in the unit of the file; None where none is in force.

    A range is in force where its switch says so (`limited`, `forcelimited` and so on), and with `auto` if
    the file has `autolimits` and the range is not empty.
    """
    said = keyword_of(element, key.replace("range", "limited"), notes)
    lower, upper = numbers_of(element, key, notes, (0.0, 0.0))
    if said is Keyword.FALSE or (said is Keyword.AUTO and not (settings.autolimits and lower != upper)):
        return None
    if lower > upper:
        words = f'`{element.name}` has {key}="{lower:g} {upper:g}", which ends below its start'
        notes.add(BAD_NUMBER, element.span, words, "the lower limit must be the smaller number")
        return None
    return lower, upper


def _resistance(joint: Element, name: str, notes: Notes) -> Resistance:
    viscous, *rest = numbers_of(joint, "damping", notes, (0.0, 0.0, 0.0), least=1)
    if any(rest):
        notes.gather(_DAMPING, joint.span, [name])
    dry, rotor = number_of(joint, "frictionloss", notes), number_of(joint, "armature", notes)
    if min(viscous, dry, rotor) < 0.0:
        words = f"friction or armature of joint `{name}` is negative"
        notes.add(BAD_NUMBER, joint.span, words, "friction resists: check the sign")
    return Resistance(viscous, dry, rotor)
