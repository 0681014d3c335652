"""Drives and limits of motion as instances."""

from collections.abc import Iterator
from math import inf

from ropsim.core import Diagnostic
from ropsim.model import (
    BacklashGear,
    BallScrew,
    CurrentLimitedAmplifier,
    CurrentLoopMotor,
    DcMotor,
    Drive,
    EffortAmplifier,
    Elastic,
    Gear,
    GuardedAmplifier,
    Hydraulic,
    HydraulicCylinder,
    HydraulicMotor,
    HydraulicVane,
    IdealMotor,
    LaggingMotor,
    Linkage,
    RobotModel,
    ThermalDcMotor,
    ValveAmplifier,
    VoltageAmplifier,
    usual_back_efficiency,
)
from ropsim.nirox.building import UNSET, Building, bounded
from ropsim.nirox.diagnostics import LOST
from ropsim.nirox.writers.frictions import write_friction
from ropsim.nirox.writers.hydraulics import write_hydraulic, write_linkage
from ropsim.part21 import TRUE, Reference, Value

_JOINED = (
    "take a DC motor at a voltage amplifier, or a hydraulic one whose valve gets its rated current at most"
)


def write_drives(building: Building, robot: RobotModel) -> None:
    """Make the drives of the axes and the limits of all joints."""
    drives = dict(zip(robot.axes, robot.drives, strict=False)) if not _impossible(robot) else {}
    for number, joint in enumerate(robot.joints):
        drive = drives.get(number)
        if drive is not None:
            _drive_train(building, robot, number, drive)
            write_friction(building, number, drive.friction)
            if drive.link is not None:
                numbers = (drive.link.stiffness, drive.link.damping, drive.link.hub_inertia)
                pair = building.at(("pair", number))
                building.add(("link elasticity", number), "LINK_ELASTICITY", pair, *map(float, numbers))
        motion = (inf, inf, inf) if drive else (joint.max_speed, joint.max_acceleration, joint.max_jerk)
        limits = (*motion, joint.max_effort)
        if any(one != inf for one in limits):
            pair = building.at(("pair", number))
            building.add(("limits", number), "JOINT_LIMITS", pair, *map(bounded, limits))


def drive_losses(robot: RobotModel) -> Iterator[Diagnostic]:
    """Yield that the drives do not go over where one of them is of blocks that the schema does not join."""
    names = _impossible(robot)
    if names:
        words = f"drives of `{robot.name}` do not go over: of axes {', '.join(names)} motor and amplifier"
        yield LOST.at(None, f"{words} are not those of one kind", hint=_JOINED)


def _impossible(robot: RobotModel) -> list[str]:
    return [
        joint.name
        for joint, drive in zip(robot.axis_joints, robot.drives, strict=False)
        if not _joined(drive)
    ]


def _joined(drive: Drive) -> bool:
    """Return whether the schema joins the amplifier and the motor of a drive."""
    match drive.amplifier, drive.motor:
        case ValveAmplifier(most), HydraulicMotor() | HydraulicCylinder() | HydraulicVane():
            is_linked = isinstance(drive.transmission, Linkage)
            is_rated = most == drive.motor.rated_input
            return is_rated and is_linked is isinstance(drive.motor, HydraulicCylinder)
        case ValveAmplifier(), _:
            return False
        case _, HydraulicMotor() | HydraulicCylinder() | HydraulicVane():
            return False
        case GuardedAmplifier(), ThermalDcMotor():
            return True
        case (GuardedAmplifier(), _) | (_, ThermalDcMotor()):
            return False
    return isinstance(drive.amplifier, EffortAmplifier) is isinstance(
        drive.motor, IdealMotor | LaggingMotor | CurrentLoopMotor
    )


def _drive_train(building: Building, robot: RobotModel, number: int, drive: Drive) -> None:
    joint, gear = robot.joints[number], drive.transmission
    motor, amplifier = _motor(building, number, joint.name, drive)
    if isinstance(gear, Linkage):
        through = write_linkage(building, robot, number, gear)
    elif isinstance(gear, BallScrew):
        through = _screw(building, number, joint.name, drive, gear)
    else:
        through = _gear(building, number, joint.name, drive, gear)
    limits = map(bounded, (joint.max_speed, joint.max_acceleration, joint.max_jerk))
    ends = building.at(("pair", number)), motor, through, amplifier
    building.add(("drive", number), "DRIVE_TRAIN", f"drive {joint.name}", *ends, *limits, ())


def _screw(building: Building, number: int, name: str, drive: Drive, screw: BallScrew) -> Reference:
    """Make a ball screw, with the inertia of a rotor that the motor has no place for."""
    bare = isinstance(drive.motor, IdealMotor | LaggingMotor)
    rotor = drive.motor.rotor_inertia if bare else 0.0
    values = (f"screw {name}", float(screw.lead), float(screw.efficiency))
    made = building.add(("gear", number), "SCREW_TRANSMISSION", *values)
    unusual = screw.back_efficiency != usual_back_efficiency(screw.efficiency)
    if rotor or screw.screw_inertia or unusual:
        losses = map(float, (screw.back_efficiency, screw.screw_inertia, rotor))
        building.add(("gear", number, "losses"), "SCREW_LOSSES", made, *losses)
    return made


def _gear(building: Building, number: int, name: str, drive: Drive, gear: Gear | Elastic) -> Reference:
    elastic: tuple[Value, Value] = (UNSET, UNSET)
    if isinstance(gear, Elastic):
        elastic = float(gear.stiffness), float(gear.damping)
    bare = isinstance(drive.motor, IdealMotor | LaggingMotor)
    at_input = float(drive.motor.rotor_inertia) if bare else 0.0
    play = float(gear.backlash) if isinstance(gear, BacklashGear) else 0.0
    values = (f"gear {name}", float(gear.ratio), 1.0, play, *elastic, at_input)
    return building.add(("gear", number), "GEAR_TRANSMISSION", *values)


def _motor(building: Building, number: int, name: str, drive: Drive) -> tuple[Reference, Value]:
    """Return the motor of a drive, and the amplifier where it says more than its voltage and current."""
    key, motor, amplifier = ("motor", number), drive.motor, drive.amplifier
    if isinstance(motor, Hydraulic):
        return write_hydraulic(building, number, name, motor, drive.supply)
    if isinstance(motor, ThermalDcMotor) and isinstance(amplifier, GuardedAmplifier):
        made = _dc_motor(building, number, name, motor, (amplifier.max_voltage, amplifier.max_current))
        bodies = (motor.winding_thermal_resistance, motor.housing_thermal_resistance)
        times = (motor.winding_time_constant, motor.housing_time_constant)
        drifts = (motor.resistance_drift, 0.0 - motor.torque_drift, motor.start_rise)
        numbers = tuple(map(float, (*bodies, *times, *drifts)))
        building.add((*key, "heat"), "MOTOR_HEAT", made, *numbers, bounded(amplifier.max_rise))
        return made, UNSET
    if isinstance(motor, DcMotor) and isinstance(amplifier, VoltageAmplifier | CurrentLimitedAmplifier):
        most = amplifier.max_voltage, amplifier.max_current
        made = _dc_motor(building, number, name, motor, most)
        if not isinstance(amplifier, CurrentLimitedAmplifier):
            return made, UNSET
        label = f"amplifier {name}"
        return made, building.add(("amplifier", number), "ELECTRIC_AMPLIFIER", label, TRUE)
    effort = amplifier.max_effort if isinstance(amplifier, EffortAmplifier) else inf
    if isinstance(motor, CurrentLoopMotor):
        own = motor.torque_constant * motor.max_current
        made = _dc_motor(building, number, name, motor, (motor.max_voltage, motor.max_current))
        told = UNSET if effort == own else bounded(effort)
        building.add((*key, "loop"), "CURRENT_CONTROLLER", made, float(motor.bandwidth), told)
        return made, UNSET
    lag = float(motor.bandwidth) if isinstance(motor, LaggingMotor) else UNSET
    return building.add(key, "IDEAL_EFFORT_SOURCE", f"motor {name}", bounded(effort), lag), UNSET


def _dc_motor(
    building: Building,
    number: int,
    name: str,
    motor: DcMotor | ThermalDcMotor | CurrentLoopMotor,
    most: tuple[float, float],
) -> Reference:
    """Make a DC motor with its largest voltage and current."""
    constants = (motor.torque_constant, motor.back_emf_constant, motor.resistance, motor.inductance)
    numbers = map(float, (*constants, motor.rotor_inertia, *most))
    heat = (UNSET, UNSET, UNSET)
    return building.add(("motor", number), "DC_SERVO_MOTOR", f"motor {name}", *numbers, *heat)
