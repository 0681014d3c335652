"""Drives and limits of motion as instances."""

from collections.abc import Iterator
from math import inf

from ropsim.core import Diagnostic
from ropsim.model import (
    CurrentLimitedAmplifier,
    DcMotor,
    Drive,
    EffortAmplifier,
    ElasticGear,
    Friction,
    HydraulicMotor,
    IdealMotor,
    Joint,
    RobotModel,
    ValveAmplifier,
    VoltageAmplifier,
)
from ropsim.nirox.building import UNSET, Building, bounded
from ropsim.nirox.diagnostics import LOST
from ropsim.part21 import TRUE, Enumeration, Reference, Value

_JOINED = (
    "take a DC motor at a voltage amplifier, or a hydraulic one whose valve gets its rated current at most"
)
MOTOR_SIDE = Enumeration("MOTOR_SIDE")


def write_drives(building: Building, robot: RobotModel) -> None:
    """Make the drives of the axes and the limits of all joints."""
    drives = dict(zip(robot.axes, robot.drives, strict=False)) if not _impossible(robot) else {}
    for number, joint in enumerate(robot.joints):
        drive = drives.get(number)
        if drive is not None:
            _drive_train(building, number, joint, drive)
            _friction(building, number, drive.friction)
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
        case ValveAmplifier(most), HydraulicMotor(rated_input=rated):
            return most == rated
        case ValveAmplifier(), _:
            return False
        case _, HydraulicMotor():
            return False
    return isinstance(drive.amplifier, EffortAmplifier) is isinstance(drive.motor, IdealMotor)


def _drive_train(building: Building, number: int, joint: Joint, drive: Drive) -> None:
    motor, amplifier = _motor(building, number, joint.name, drive)
    gear = drive.transmission
    elastic: tuple[Value, Value] = (UNSET, UNSET)
    if isinstance(gear, ElasticGear):
        elastic = float(gear.stiffness), float(gear.damping)
    at_input = 0.0 if isinstance(drive.motor, DcMotor | HydraulicMotor) else float(drive.motor.rotor_inertia)
    values = (f"gear {joint.name}", float(gear.ratio), 1.0, 0.0, *elastic, at_input)
    through = building.add(("gear", number), "GEAR_TRANSMISSION", *values)
    limits = map(bounded, (joint.max_speed, joint.max_acceleration, joint.max_jerk))
    ends = building.at(("pair", number)), motor, through, amplifier
    building.add(("drive", number), "DRIVE_TRAIN", f"drive {joint.name}", *ends, *limits, ())


def _motor(building: Building, number: int, name: str, drive: Drive) -> tuple[Reference, Value]:
    """Return the motor of a drive, and the amplifier where it says more than its voltage and current."""
    key, motor, amplifier = ("motor", number), drive.motor, drive.amplifier
    if isinstance(motor, HydraulicMotor):
        return _hydraulic(building, number, name, motor)
    if isinstance(motor, DcMotor) and isinstance(amplifier, VoltageAmplifier | CurrentLimitedAmplifier):
        constants = (motor.torque_constant, motor.back_emf_constant, motor.resistance, motor.inductance)
        most = (motor.rotor_inertia, amplifier.max_voltage, amplifier.max_current)
        numbers = map(float, (*constants, *most))
        made = building.add(key, "DC_SERVO_MOTOR", f"motor {name}", *numbers, UNSET, UNSET, UNSET)
        if not isinstance(amplifier, CurrentLimitedAmplifier):
            return made, UNSET
        label = f"amplifier {name}"
        return made, building.add(("amplifier", number), "ELECTRIC_AMPLIFIER", label, TRUE)
    effort = amplifier.max_effort if isinstance(amplifier, EffortAmplifier) else inf
    return building.add(key, "IDEAL_EFFORT_SOURCE", f"motor {name}", bounded(effort), UNSET), UNSET


def _hydraulic(building: Building, number: int, name: str, motor: HydraulicMotor) -> tuple[Reference, Value]:
    """Return a hydraulic motor and its valve, with the supply of that."""
    pressures = (motor.supply_pressure, motor.return_pressure, motor.bulk_modulus, motor.oil_density)
    key = ("amplifier", number)
    supply = building.add((*key, "supply"), "HYDRAULIC_SUPPLY", f"supply {name}", *map(float, pressures))
    flow = (motor.rated_flow, motor.rated_pressure_drop, motor.rated_input)
    spool = (motor.natural_frequency, motor.damping_ratio, 0.0, 0.0)
    valve = building.add(key, "SERVO_VALVE", f"valve {name}", supply, *map(float, (*flow, *spool)), UNSET)
    sizes = (motor.displacement, motor.chamber_volume, motor.leakage, motor.rotor_inertia)
    made = building.add(("motor", number), "HYDRAULIC_ROTARY_MOTOR", f"motor {name}", *map(float, sizes))
    return made, valve


def _friction(building: Building, number: int, friction: Friction) -> None:
    if friction == Friction():
        return
    positive, negative = float(friction.coulomb_positive), -float(friction.coulomb_negative)
    second: Value = UNSET if negative == positive else negative
    pair, key = building.at(("pair", number)), ("friction", number)
    values = (pair, MOTOR_SIDE, float(friction.viscous), positive, second)
    made = building.add(key, "COULOMB_VISCOUS_FRICTION", *values)
    if friction.smoothing_speed != Friction().smoothing_speed:
        speed = float(friction.smoothing_speed)
        building.add((*key, "smoothing"), "FRICTION_SMOOTHING", made, speed)
