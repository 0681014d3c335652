"""Facts of one station in a recording: its robot, the limits of the axes, its controller."""

from dataclasses import replace

import numpy as np

from ropsim.controller import CompiledLaw, PythonLaw
from ropsim.flow import AxisFacts, AxisType, IntegrationFacts, StationFacts
from ropsim.model import (
    ControllerFile,
    ControllerModel,
    CurrentLoopMotor,
    Drive,
    JointType,
    RobotModel,
    ThermalDcMotor,
)

_TYPES = {JointType.REVOLUTE: AxisType.REVOLUTE, JointType.PRISMATIC: AxisType.PRISMATIC}


def station_facts(
    name: str,
    robot: RobotModel,
    controller: ControllerModel,
    plant_steps: int,
    integration: IntegrationFacts | None,
) -> StationFacts:
    """Return the facts of a station before it runs a program.

    Args:
        name: of the station.
        robot: its arm.
        controller: its controller.
        plant_steps: integration steps per control tick, 1 where nothing is integrated.
        integration: how drives and arm are integrated; None where nothing is.
    """
    rates = controller.rates
    return StationFacts(
        name,
        control_hz=float(rates.control_hz),
        interpolation_ticks=rates.interpolation_ticks,
        plant_steps=plant_steps,
        integration=integration,
        robot=robot.name,
        title=robot.title,
        axes=_axes(robot),
        origins=(*robot.origins, *controller.origins),
    )


def with_law(
    station: StationFacts, controller: ControllerModel, law: CompiledLaw | PythonLaw | None
) -> StationFacts:
    """Return a station with the name of its joint controller; None is the law of the controller model."""
    if law is None:
        file = controller.gains
        return replace(station, law=file.path if isinstance(file, ControllerFile) else controller.kind.value)
    return replace(station, law=law.name if isinstance(law, CompiledLaw) else type(law).__name__)


def _axes(robot: RobotModel) -> tuple[AxisFacts, ...]:
    limits = [_drive_limits(drive) for drive in robot.drives] or [(np.inf,) * 3] * robot.n
    return tuple(
        AxisFacts(
            joint.name,
            _TYPES[joint.measure],
            -np.inf if joint.is_endless else float(joint.lower),
            np.inf if joint.is_endless else float(joint.upper),
            float(joint.max_speed),
            float(joint.max_effort),
            *own,
        )
        for joint, own in zip(robot.axis_joints, limits, strict=True)
    )


def _drive_limits(drive: Drive) -> tuple[float, float, float]:
    """Return the largest current, the lasting current [A], and the greatest rise of the winding [K]."""
    amplifier, motor = drive.amplifier, drive.motor
    watched = motor if isinstance(motor, CurrentLoopMotor) else amplifier
    current = float(getattr(watched, "max_current", np.inf))
    rise = float(getattr(amplifier, "max_rise", np.inf))
    lasting = motor.lasting_current(rise) if isinstance(motor, ThermalDcMotor) else np.inf
    return current, float(lasting), rise
