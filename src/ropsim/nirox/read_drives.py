"""The drives of a file: all axes have one that the model holds, or the robot has none."""

from math import inf

from ropsim.model import (
    Amplifier,
    CurrentLimitedAmplifier,
    DcMotor,
    Drive,
    EffortAmplifier,
    ElasticGear,
    Friction,
    Gear,
    HydraulicMotor,
    IdealMotor,
    Motor,
    Transmission,
    ValveAmplifier,
    VoltageAmplifier,
)
from ropsim.nirox.attributes import LARGEST
from ropsim.nirox.diagnostics import LOST
from ropsim.nirox.seen import Seen

_SIMPLE = "coulomb_viscous_friction"


def read_drives(seen: Seen, pairs: list[int], numbers: list[int]) -> tuple[Drive, ...]:
    """Return the drives of the axes; none where one of them has none, or one that the model does not hold.

    Args:
        seen: the file.
        pairs: of the axes.
        numbers: of their joints.
    """
    trains = [seen.user(pair, "drive_train", "pair") for pair in pairs]
    if not all(train is not None for train in trains):
        if any(train is not None for train in trains):
            seen.note(
                LOST, next(one for one in trains if one is not None), "other axes have no drive: none has one"
            )
        return ()
    held = [train for train in trains if train is not None and _is_held(seen, train)]
    if len(held) < len(pairs):
        return ()
    return tuple(_drive(seen, *one) for one in zip(held, pairs, numbers, strict=True))


def _is_held(seen: Seen, train: int) -> bool:
    motor, through = seen.ref(train, "motor"), seen.ref(train, "through")
    for number, allowed in (
        (motor, ("dc_servo_motor", "ideal_effort_source", "hydraulic_rotary_motor")),
        (through, ("gear_transmission", "screw_transmission")),
    ):
        if not any(seen.is_a(number, one) for one in allowed):
            words = f"the model has no such block: the robot has no drives (drive {seen.called(train)})"
            seen.note(LOST, number, words, f"allowed are {' and '.join(allowed)}")
            return False
    return not _needs_a_valve(seen, train)


def _needs_a_valve(seen: Seen, train: int) -> bool:
    """Return whether a hydraulic motor has no valve, which is told."""
    motor = seen.ref(train, "motor")
    if not seen.is_a(motor, "hydraulic_rotary_motor"):
        return False
    if seen.has(train, "driven_by") and seen.is_a(seen.ref(train, "driven_by"), "servo_valve"):
        return False
    words = f"no servo valve drives it: the robot has no drives (drive {seen.called(train)})"
    seen.note(LOST, motor, words, "name a SERVO_VALVE as `driven_by` of its drive")
    return True


def _drive(seen: Seen, train: int, pair: int, number: int) -> Drive:
    seen.take(train, "drive", number)
    transmission, at_input = _transmission(seen, seen.ref(train, "through"), pair, number)
    amplifier, motor = _motor(seen, train, at_input, number)
    return Drive(amplifier, motor, transmission, _friction(seen, pair, transmission.ratio, number))


def _motor(seen: Seen, train: int, at_input: float, number: int) -> tuple[Amplifier, Motor]:
    motor = seen.ref(train, "motor")
    seen.take(motor, "motor", number)
    if seen.is_a(motor, "ideal_effort_source"):
        if seen.has(motor, "bandwidth"):
            seen.note(LOST, motor, "`bandwidth` has no effect: the torque acts at once")
        return EffortAmplifier(seen.real(motor, "max_effort", inf)), IdealMotor(at_input)
    if seen.is_a(motor, "hydraulic_rotary_motor"):
        return _hydraulic(seen, motor, seen.ref(train, "driven_by"), at_input, number)
    limits = False
    if seen.has(train, "driven_by"):
        amplifier = seen.ref(train, "driven_by")
        seen.take(amplifier, "amplifier", number)
        limits = seen.flag(amplifier, "limits_current")
    if any(
        seen.has(motor, one) for one in ("thermal_resistance", "thermal_time_constant", "continuous_current")
    ):
        seen.note(LOST, motor, "what it says of heat has no effect")
    rotor = seen.real(motor, "rotor_inertia")
    made = DcMotor(
        seen.real(motor, "torque_constant"),
        seen.real(motor, "back_emf_constant"),
        seen.real(motor, "armature_resistance"),
        seen.real(motor, "armature_inductance"),
        rotor + at_input if at_input else rotor,
    )
    most = seen.real(motor, "max_voltage"), seen.real(motor, "max_current")
    return (CurrentLimitedAmplifier(*most) if limits else VoltageAmplifier(*most)), made


def _hydraulic(seen: Seen, motor: int, valve: int, at_input: float, number: int) -> tuple[Amplifier, Motor]:
    """Return a hydraulic motor with the numbers of its valve and of the supply of that."""
    supply = seen.ref(valve, "supply")
    seen.take(valve, "amplifier", number)
    seen.take(supply, "amplifier", number, "supply")
    if seen.real(valve, "overlap") or seen.real(valve, "hysteresis") or seen.has(valve, "max_slew"):
        seen.note(LOST, valve, "overlap, hysteresis and `max_slew` have no effect")
    most, rotor = seen.real(valve, "max_input"), seen.real(motor, "rotor_inertia")
    made = HydraulicMotor(
        displacement=seen.real(motor, "displacement"),
        chamber_volume=seen.real(motor, "chamber_volume"),
        leakage=seen.real(motor, "internal_leakage"),
        rotor_inertia=rotor + at_input if at_input else rotor,
        supply_pressure=seen.real(supply, "supply_pressure"),
        return_pressure=seen.real(supply, "return_pressure"),
        bulk_modulus=seen.real(supply, "effective_bulk_modulus"),
        rated_flow=seen.real(valve, "rated_flow"),
        rated_pressure_drop=seen.real(valve, "rated_pressure_drop"),
        rated_input=most,
        natural_frequency=seen.real(valve, "natural_frequency"),
        damping_ratio=seen.real(valve, "damping_ratio"),
        oil_density=seen.real(supply, "oil_density"),
    )
    return ValveAmplifier(most), made


def _transmission(seen: Seen, through: int, pair: int, number: int) -> tuple[Transmission, float]:
    """Return the gear of a drive and the inertia at its input [kg·m² | kg]."""
    seen.take(through, "gear", number)
    if seen.real(through, "efficiency") < 1.0 or seen.real(through, "backlash", 0.0):
        seen.note(LOST, through, "efficiency and backlash have no effect")
    if seen.is_a(through, "screw_transmission"):
        return _elastic(seen, pair, 1.0 / _usable(seen, through, "lead"), number), 0.0
    ratio, at_input = _usable(seen, through, "ratio"), seen.real(through, "input_inertia")
    if seen.has(through, "stiffness"):
        return ElasticGear(
            ratio, seen.real(through, "stiffness"), seen.real(through, "damping", 0.0)
        ), at_input
    return _elastic(seen, pair, ratio, number), at_input


def _usable(seen: Seen, number: int, name: str) -> float:
    """Return a ratio whose square and whose inverse are numbers of a robot."""
    value = seen.real(number, name)
    if abs(value) < 1.0 / LARGEST:
        raise seen.impossible(number, f"`{name}` is {value:g}, allowed is {1.0 / LARGEST:g} or more")
    return value


def _elastic(seen: Seen, pair: int, ratio: float, number: int) -> Transmission:
    """Return a gear that twists where the file says so of the joint, else a rigid one."""
    told = seen.user(pair, "joint_elasticity", "pair")
    if told is None:
        return Gear(ratio)
    seen.take(told, "elasticity", number)
    return ElasticGear(ratio, seen.real(told, "stiffness"), seen.real(told, "damping"))


def _friction(seen: Seen, pair: int, ratio: float, number: int) -> Friction:
    """Return viscous and Coulomb friction at the motor; other models are taken without the rest of theirs."""
    told = seen.users(pair, "joint_friction", "pair")
    if not told:
        return Friction()
    one = told[0]
    seen.take(one, "friction", number)
    for other in told[1:]:
        seen.note(LOST, other, "the joint has friction on both sides: this one has no effect")
    if not seen.is_a(one, _SIMPLE):
        seen.note(LOST, one, "only its viscous and its Coulomb part have an effect", f"use {_SIMPLE.upper()}")
    viscous, positive = seen.real(one, "viscous"), seen.real(one, "coulomb")
    negative = seen.real(one, "coulomb_negative", positive)
    if seen.text(one, "side") == "joint_side":
        viscous, positive, negative = viscous / ratio**2, positive / abs(ratio), negative / abs(ratio)
    smoothing = Friction().smoothing_speed
    companion = seen.user(one, "friction_smoothing", "friction")
    if companion is not None:
        seen.take(companion, "friction", number, "smoothing")
        smoothing = seen.real(companion, "speed")
    return Friction(viscous, positive, -negative, smoothing)
