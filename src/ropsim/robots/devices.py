"""Mechanisms of devices: one axis each, of a belt, a slide or a turntable; without drives."""

from dataclasses import replace

from ropsim.model import Box, Joint, JointType, Link, Material, Mechanism, Shape, rod
from ropsim.spatial import ALONG_X, Pose, frozen, translation

_FREE = 1e9
"""Limit of an axis without a limit [rad | m]."""

_DARK, _STEEL = "#3d4248", "#9aa0a6"


def conveyor(length: float, width: float, height: float, colour: str = _DARK) -> Mechanism:
    """Return a conveyor: its base frame is at the start of the belt, amid its surface, x along it.

    Parts on it move with its one link; the belt itself is drawn as standing still.

    Args:
        length: of the belt [m].
        width: of the belt [m].
        height: of belt and frame below the surface [m].
        colour: of the belt, `#rrggbb`.
    """
    thick = min(0.03, height / 2.0)
    base = (
        Shape(
            Box((length, width, thick)),
            translation(length / 2.0, 0.0, -thick / 2.0),
            colour,
            material=Material.RUBBER,
        ),
        Shape(
            Box((length, 0.8 * width, height - thick)),
            translation(length / 2.0, 0.0, -(height + thick) / 2.0),
            _STEEL,
        ),
    )
    return shaped_conveyor(base)


def shaped_conveyor(shapes: tuple[Shape, ...]) -> Mechanism:
    """Return a conveyor of any look.

    Args:
        shapes: of belt and frame in the base frame, which is at the start of the belt, amid its surface, with
            x along it.
    """
    return _mechanism("conveyor", "Conveyor", JointType.PRISMATIC, ALONG_X, (), shapes)


def slide(shapes: tuple[Shape, ...]) -> Mechanism:
    """Return a body that slides along x of the base frame: a door, a clamp, an axis of a gantry.

    Args:
        shapes: of the body, in its frame, which is the base frame at coordinate 0.
    """
    turned = tuple(replace(one, pose=ALONG_X.inverse() @ one.pose) for one in shapes)
    return _mechanism("slide", "Slide", JointType.PRISMATIC, ALONG_X, turned, ())


def rotary(shapes: tuple[Shape, ...], base: tuple[Shape, ...] | None = None) -> Mechanism:
    """Return a body that turns about z of the base frame.

    Args:
        shapes: of the body, in its frame, which is the base frame at coordinate 0.
        base: of what carries it, in the base frame; None for a short post.
    """
    post = rod([0.0, 0.0, -0.06], [0.0, 0.0, -0.05], 0.05, colour=_STEEL)
    carrier = (post,) if base is None else base
    return _mechanism("rotary", "Turntable", JointType.REVOLUTE, Pose(), shapes, carrier)


def _mechanism(
    name: str,
    title: str,
    type_: JointType,
    placement: Pose,
    shapes: tuple[Shape, ...],
    base: tuple[Shape, ...],
) -> Mechanism:
    joint = Joint("1", type_, placement, 0.0, -_FREE, _FREE, _FREE, _FREE, _FREE)
    link = Link(0.0, frozen([0.0] * 3), frozen([[0.0] * 3] * 3), shapes)
    return Mechanism(name, title, (joint,), (link,), (), frozen([0.0]), base_shapes=base)
