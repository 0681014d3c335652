"""Losses of a robot in a file of any format: drives, looks, and remarks."""

from collections.abc import Callable, Iterable
from math import isfinite

import numpy as np

from ropsim.core import Diagnostic
from ropsim.exchange.files.names import link_name
from ropsim.exchange.losses.gathered import listed
from ropsim.exchange.losses.loss_diagnostics import LOST_DESCRIPTION, LOST_DRIVE
from ropsim.model import (
    BacklashGear,
    Cylinder,
    Drive,
    EffortAmplifier,
    Elastic,
    Friction,
    Hydraulic,
    HydraulicMotor,
    HydraulicVane,
    IdealMotor,
    LaggingMotor,
    Linkage,
    Material,
    Polyline,
    Prism,
    Revolve,
    RobotModel,
    Shape,
    ValveAmplifier,
)

_TESTS: tuple[tuple[str, Callable[[Drive], bool]], ...] = (
    (
        "amplifiers with their voltages and currents",
        lambda one: not isinstance(one.amplifier, EffortAmplifier | ValveAmplifier),
    ),
    ("motor constants", lambda one: not isinstance(one.motor, IdealMotor | LaggingMotor | Hydraulic)),
    ("lags of torques", lambda one: isinstance(one.motor, LaggingMotor)),
    ("valves, oil and supply", lambda one: isinstance(one.motor, Hydraulic)),
    (
        "displacements and chambers of hydraulic motors",
        lambda one: isinstance(one.motor, HydraulicMotor | HydraulicVane),
    ),
    ("gear ratios", lambda one: not isinstance(one.transmission, Linkage) and abs(one.ratio_at(0.0)) != 1.0),
    ("cylinders with their areas, strokes and pins", lambda one: isinstance(one.transmission, Linkage)),
    ("stiffness and damping of gears", lambda one: isinstance(one.transmission, Elastic)),
    ("play of gears", lambda one: isinstance(one.transmission, BacklashGear)),
    (
        "differences of dry friction between the two directions",
        lambda one: one.friction.coulomb_positive != -one.friction.coulomb_negative,
    ),
    ("friction beyond its viscous and its Coulomb part", lambda one: not isinstance(one.friction, Friction)),
)


def friction_at_joint(drive: Drive, q: float) -> tuple[float, float]:
    """Return viscous [N·m·s/rad | N·s/m] and dry friction [N·m | N] at the joint at q [rad | m]."""
    friction, ratio = drive.friction, drive.ratio_at(q)
    dry = (friction.coulomb_positive - friction.coulomb_negative) / 2.0
    return friction.viscous * ratio * ratio, abs(ratio) * dry


def rotor_at_joint(drive: Drive, q: float) -> float:
    """Return the inertia of the rotor at the joint [kg·m² | kg], where that is at q [rad | m]."""
    ratio = drive.ratio_at(q)
    return drive.turning_inertia * ratio * ratio


def drive_losses(robot: RobotModel) -> Iterable[Diagnostic]:
    """Yield the losses of drives in all formats."""
    axes = [joint.name for joint in robot.axis_joints]
    for what, lost in _TESTS:
        names = [name for name, drive in zip(axes, robot.drives, strict=False) if lost(drive)]
        if names:
            yield LOST_DRIVE.at(
                None, f"{what} of axes {listed(names)} do not go over", data={"axes": tuple(names)}
            )
    smooth = [
        name
        for name, drive in zip(axes, robot.drives, strict=False)
        if drive.friction.coulomb_positive and drive.friction.smoothing_speed != Friction().smoothing_speed
    ]
    if smooth:
        words = f"the speed over which dry friction of axes {listed(smooth)} sets in does not go over"
        yield LOST_DRIVE.at(None, words, data={"axes": tuple(smooth)})


def can_write(shape: Shape) -> bool:
    """Return whether the formats have a solid like that of a shape."""
    if isinstance(shape.solid, Cylinder):
        return shape.solid.top_radius == shape.solid.radius
    return not isinstance(shape.solid, Revolve | Prism | Polyline)


def look_losses(robot: RobotModel) -> Iterable[Diagnostic]:
    """Yield the shapes that go into no format, and materials of surfaces."""
    bodies = [("base", robot.base_shapes)]
    bodies += [
        (link_name(joint.name), link.shapes) for joint, link in zip(robot.joints, robot.links, strict=True)
    ]
    lost = [name for name, shapes in bodies if not all(map(can_write, shapes))]
    if lost:
        words = f"cones, outlines, bodies of revolution and lines of {listed(lost)} do not go over"
        yield LOST_DESCRIPTION.at(None, words, hint="make meshes of them", data={"links": tuple(lost)})
    surfaces = [name for name, shapes in bodies if any(one.material is not Material.PAINT for one in shapes)]
    if surfaces:
        words = f"what the surfaces of {listed(surfaces)} look as if made of does not go over"
        yield LOST_DESCRIPTION.at(None, words, data={"links": tuple(surfaces)})


def word_losses(robot: RobotModel, home: str = "the home position") -> Iterable[Diagnostic]:
    """Yield the losses of remarks on a robot in all formats.

    Args:
        robot: to be written.
        home: how its home position is called; empty where the format holds it.
    """
    zero = np.clip(0.0, robot.lower_limits, robot.upper_limits)
    rows = (
        ("the title", robot.title != robot.name),
        (home, bool(home) and not np.array_equal(robot.home, zero)),
        ("the DH table", bool(robot.dh)),
        ("where its numbers come from", bool(robot.origins)),
        ("which of its axes are external", bool(robot.external)),
        ("its rated payload", isfinite(robot.rated_payload)),
        ("limits of tool paths", robot.path_limits is not None),
        ("its class", robot.arm_class is not None),
    )
    lost = [what for what, is_lost in rows if is_lost]
    if lost:
        yield LOST_DESCRIPTION.at(None, f"of `{robot.name}` these do not go over: {', '.join(lost)}")
