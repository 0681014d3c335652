"""Mechanisms that stations have beside their arms: linear track, turntable."""

from math import pi

import numpy as np

from ropsim.model import (
    BASE_LINK,
    Box,
    Drive,
    EffortAmplifier,
    Friction,
    Gear,
    IdealMotor,
    JointLimits,
    JointType,
    Link,
    Mechanism,
    ParameterOrigin,
    Revolve,
    Shape,
    limited,
)
from ropsim.spatial import Array, Pose

_FRAME, _PLATE, _STEEL, _ACCENT = "#3d464f", "#cfd4d8", "#a3abb3", "#e2702b"
_ALONG_X = Pose(orientation=np.array([1.0, 0.0, 1.0, 0.0]))  # Ry(90°): z of the joint points along x
_BACK = _ALONG_X.inverse()
_ESTIMATE = (
    ParameterOrigin(
        "limits, masses, drive", "estimated", "round numbers for equipment of this kind; set by the caller"
    ),
)


def linear_track(length: float, carriage_mass: float = 250.0, name: str = "linear_track") -> Mechanism:
    """Return a track on the floor along x of its base frame; the carriage stands in the middle of it at 0.

    Its frame of mounting, the frame of the link, lies on the carriage and has the axes of the base frame.

    Args:
        length: travel of the carriage [m], > 0.
        carriage_mass: [kg].
        name: of the mechanism.
    """
    half, height = length / 2.0, 0.35
    limits = JointLimits(-half, half, 2.0, 3.0, 30.0, 12_000.0)
    beds = [
        Shape(Box((length + 1.0, 0.12, 0.2)), Pose(np.array([0.0, side, 0.1])), _FRAME)
        for side in (-0.35, 0.35)
    ]
    rails = [
        Shape(Box((length + 1.0, 0.06, 0.06)), Pose(np.array([0.0, side, 0.23])), _STEEL)
        for side in (-0.35, 0.35)
    ]
    plate = Shape(Box((0.9, 0.95, 0.09)), Pose(np.array([0.0, 0.0, -0.045])), _PLATE)
    return _sliding(
        name, "Linear track", limits, height, (carriage_mass, (0.9, 0.95, 0.09)), (*beds, *rails), (plate,)
    )


def turntable(
    radius: float, height: float = 0.7, inertia: float = 40.0, name: str = "turntable"
) -> Mechanism:
    """Return a table that turns about z of its base frame; the frame of its link lies in the middle on top.

    Args:
        radius: of the plate [m], > 0.
        height: of its upper side over the floor [m].
        inertia: of plate and load about the axis [kg·m²].
        name: of the mechanism.
    """
    limits = JointLimits(-2.0 * pi, 2.0 * pi, 2.0, 4.0, 40.0, 600.0)
    mass = 2.0 * inertia / radius**2  # of a disc
    plate = Revolve(((0.0, -0.05), (radius, -0.05), (radius, 0.0), (0.0, 0.0)))
    post = Revolve(((0.0, 0.0), (0.6 * radius, 0.0), (0.6 * radius, 0.04), (0.3 * radius, height - 0.05)))
    mark = Shape(Box((0.25 * radius, 0.03, 0.004)), Pose(np.array([0.8 * radius, 0.0, 0.001])), _ACCENT)
    return Mechanism(
        name=name,
        title="Turntable",
        joints=(limited("1", JointType.REVOLUTE, Pose(np.array([0.0, 0.0, height])), limits, BASE_LINK),),
        links=(
            Link(
                mass,
                np.array([0.0, 0.0, -0.025]),
                np.diag([inertia / 2.0, inertia / 2.0, inertia]),
                (Shape(plate, Pose(), _PLATE), mark),
            ),
        ),
        drives=(_drive(120.0, 2e-3, 8.0, 1e-3, 0.1),),
        home=np.zeros(1),
        origins=_ESTIMATE,
        base_shapes=(Shape(post, Pose(), _FRAME),),
    )


def _drive(ratio: float, rotor: float, most: float, viscous: float, dry: float) -> Drive:
    return Drive(EffortAmplifier(most), IdealMotor(rotor), Gear(ratio), Friction(viscous, dry, -dry, 0.005))


def _sliding(
    name: str,
    title: str,
    limits: JointLimits,
    height: float,
    body: tuple[float, tuple[float, float, float]],
    base_shapes: tuple[Shape, ...],
    shapes: tuple[Shape, ...],
) -> Mechanism:
    """Return a mechanism that slides along x; its body is a plate, the frame of mounting that of its link.

    A joint slides along its own z, so a fixed joint turns the frame of the plate back into that of the base.
    """
    mass, size = body
    slide = limited(
        "1", JointType.PRISMATIC, Pose(np.array([0.0, 0.0, height])) @ _ALONG_X, limits, BASE_LINK
    )
    plate = limited("plate", JointType.FIXED, _BACK, limits, 0)
    pinion = 0.04  # [m] of the pinion that runs on the rack
    return Mechanism(
        name=name,
        title=title,
        joints=(slide, plate),
        links=(Link(0.0, np.zeros(3), np.zeros((3, 3))), Link(mass, np.zeros(3), _box(mass, size), shapes)),
        drives=(_drive(8.0 / pinion, 3e-3, 1.2 * limits.max_effort * pinion / 8.0, 1e-3, 0.1),),
        home=np.zeros(1),
        origins=_ESTIMATE,
        base_shapes=base_shapes,
    )


def _box(mass: float, size: tuple[float, float, float]) -> Array:
    """Return the moments of a homogeneous box about its centre [kg·m²]."""
    squares = np.array(size) ** 2
    return np.diag(mass / 12.0 * (squares.sum() - squares))
