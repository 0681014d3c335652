"""The drives of a file: all axes have drives that the model supports, or the robot has no drives."""

from collections.abc import Sequence
from math import inf

from ropsim.model import (
    Amplifier,
    BacklashGear,
    BallScrew,
    CurrentLimitedAmplifier,
    CurrentLoopMotor,
    DcMotor,
    Drive,
    EffortAmplifier,
    Elastic,
    ElasticGear,
    Gear,
    GuardedAmplifier,
    Hydraulic,
    IdealMotor,
    Joint,
    LaggingMotor,
    Linkage,
    LinkElasticity,
    Motor,
    ThermalDcMotor,
    Transmission,
    VoltageAmplifier,
    usual_back_efficiency,
)
from ropsim.nirox.diagnostics import LOST
from ropsim.nirox.readers.attributes import LARGEST
from ropsim.nirox.readers.frictions import read_friction
from ropsim.nirox.readers.hydraulics import HYDRAULIC, Linkages, read_hydraulic, read_supply
from ropsim.nirox.readers.mechanism import Mechanism
from ropsim.nirox.readers.seen import Seen


def read_drives(
    seen: Seen, mechanism: Mechanism, joints: Sequence[Joint], numbers: list[int]
) -> tuple[Drive, ...]:
    """Return the drives of the axes; empty if one of them lacks a drive, or has an unsupported one.

    Args:
        seen: the file.
        mechanism: its links and joints.
        joints: of the robot.
        numbers: numbers of the axes.
    """
    pairs = [mechanism.moved[number].pair for number in numbers]
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
    linkages = Linkages(seen, mechanism, joints)
    found = [_drive(seen, linkages, *one) for one in zip(held, pairs, numbers, strict=True)]
    return tuple(one for one in found if one is not None) if None not in found else ()


def _is_held(seen: Seen, train: int) -> bool:
    motor, through = seen.ref(train, "motor"), seen.ref(train, "through")
    for number, allowed in (
        (motor, ("dc_servo_motor", "ideal_effort_source", "hydraulic_rotary_motor", "hydraulic_cylinder")),
        (through, ("gear_transmission", "screw_transmission", "linkage_transmission")),
    ):
        if not any(seen.is_a(number, one) for one in allowed):
            words = f"the model has no such block: the robot has no drives (drive {seen.called(train)})"
            seen.note(LOST, number, words, f"allowed are {' and '.join(allowed)}")
            return False
    if seen.is_a(motor, "hydraulic_cylinder") is not seen.is_a(through, "linkage_transmission"):
        words = "a cylinder moves a joint by a linkage, others by a gear: the robot has no drives"
        seen.note(LOST, through, words, "take HYDRAULIC_CYLINDER and LINKAGE_TRANSMISSION together")
        return False
    return not _needs_a_valve(seen, train)


def _needs_a_valve(seen: Seen, train: int) -> bool:
    """Return whether a hydraulic motor or cylinder has no valve, which is reported."""
    motor = seen.ref(train, "motor")
    if not any(seen.is_a(motor, one) for one in HYDRAULIC):
        return False
    if seen.has(train, "driven_by") and seen.is_a(seen.ref(train, "driven_by"), "servo_valve"):
        return False
    words = f"no servo valve drives it: the robot has no drives (drive {seen.called(train)})"
    seen.note(LOST, motor, words, "name a SERVO_VALVE as `driven_by` of its drive")
    return True


def _drive(seen: Seen, linkages: Linkages, train: int, pair: int, number: int) -> Drive | None:
    through = seen.ref(train, "through")
    transmission: Transmission | None
    if seen.is_a(through, "linkage_transmission"):
        transmission, at_input, ratio = linkages.read(through, number), 0.0, 1.0
    else:
        gear, at_input = _transmission(seen, through, pair, number)
        transmission, ratio = gear, gear.ratio
    if transmission is None:
        return None
    seen.take(train, "drive", number)
    amplifier, motor = _motor(seen, train, at_input, number)
    if isinstance(transmission, Linkage) and seen.user(pair, "joint_elasticity", "pair") is not None:
        seen.note(LOST, through, "what the joint says of elasticity has no effect: oil is what gives way")
    is_hydraulic = isinstance(motor, Hydraulic)
    supply = read_supply(seen, seen.ref(train, "driven_by")) if is_hydraulic else None
    friction = read_friction(seen, pair, ratio, number)
    drive = Drive(amplifier, motor, transmission, friction, supply, _link(seen, pair, number))
    if drive.has_idle_hub:
        words = "`hub_inertia` is 0; before an elastic link the hub, or a rotor on a rigid gear, has one"
        raise seen.impossible(train, words)
    return drive if linkages.can_be(through, drive, number) else None


def _motor(seen: Seen, train: int, at_input: float, number: int) -> tuple[Amplifier, Motor]:
    motor = seen.ref(train, "motor")
    seen.take(motor, "motor", number)
    if seen.is_a(motor, "ideal_effort_source"):
        amplifying = EffortAmplifier(seen.real(motor, "max_effort", inf))
        if seen.has(motor, "bandwidth"):
            return amplifying, LaggingMotor(seen.real(motor, "bandwidth"), at_input)
        return amplifying, IdealMotor(at_input)
    if any(seen.is_a(motor, one) for one in HYDRAULIC):
        return read_hydraulic(seen, motor, seen.ref(train, "driven_by"), at_input, number)
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
    loop = seen.user(motor, "current_controller", "motor")
    if loop is not None:
        seen.take(loop, "motor", number, "loop")
        constants = (made.torque_constant, made.back_emf_constant, made.resistance, made.inductance)
        looped = CurrentLoopMotor(*constants, made.rotor_inertia, *most, seen.real(loop, "bandwidth"))
        told = seen.real(loop, "max_effort", made.torque_constant * most[1])
        return EffortAmplifier(told), looped
    heat = seen.user(motor, "motor_heat", "motor")
    if heat is not None:
        return _warm(seen, heat, made, most, number)
    return (CurrentLimitedAmplifier(*most) if limits else VoltageAmplifier(*most)), made


def _warm(
    seen: Seen, heat: int, motor: DcMotor, most: tuple[float, float], number: int
) -> tuple[GuardedAmplifier, ThermalDcMotor]:
    """Return a motor that grows warm, and the amplifier that watches it.

    Args:
        seen: the file.
        heat: the entity that says so.
        motor: by itself.
        most: largest voltage and current [V, A].
        number: of the joint.
    """
    seen.take(heat, "motor", number, "heat")
    fade, start = seen.real(heat, "torque_drift"), seen.real(heat, "start_rise")
    if fade > 1e-2 or fade * start >= 1.0:
        raise seen.impossible(heat, f"`torque_drift` is {fade:g}, allowed is up to 0.01, and to leave torque")
    made = ThermalDcMotor(
        motor.torque_constant,
        motor.back_emf_constant,
        motor.resistance,
        motor.inductance,
        motor.rotor_inertia,
        seen.real(heat, "winding_resistance"),
        seen.real(heat, "housing_resistance"),
        seen.real(heat, "winding_time_constant"),
        seen.real(heat, "housing_time_constant"),
        seen.real(heat, "resistance_drift"),
        0.0 - fade,
        start,
    )
    return GuardedAmplifier(*most, seen.real(heat, "max_rise", inf)), made


def _transmission(
    seen: Seen, through: int, pair: int, number: int
) -> tuple[Gear | BallScrew | Elastic, float]:
    """Return the gear of a drive and the inertia at its input [kg·m² | kg]."""
    seen.take(through, "gear", number)
    is_rigid = seen.user(pair, "joint_elasticity", "pair") is None
    if seen.is_a(through, "screw_transmission") and is_rigid:
        return _screw(seen, through, number)
    if seen.real(through, "efficiency") < 1.0:
        seen.note(LOST, through, "efficiency has no effect", "load_dependent_friction has")
    if seen.is_a(through, "screw_transmission"):
        return _elastic(seen, pair, 1.0 / _usable(seen, through, "lead"), number), 0.0
    ratio, at_input = _usable(seen, through, "ratio"), seen.real(through, "input_inertia")
    gear: Gear | Elastic
    if seen.has(through, "stiffness"):
        gear = ElasticGear(ratio, seen.real(through, "stiffness"), seen.real(through, "damping", 0.0))
    else:
        gear = _elastic(seen, pair, ratio, number)
    backlash = seen.real(through, "backlash")
    if not backlash:
        return gear, at_input
    if isinstance(gear, ElasticGear):
        return BacklashGear(ratio, gear.stiffness, gear.damping, backlash), at_input
    seen.note(LOST, through, "backlash of a rigid gear has no effect", "give its stiffness")
    return gear, at_input


def _screw(seen: Seen, through: int, number: int) -> tuple[BallScrew, float]:
    """Return a ball screw with its losses, and the inertia at its input [kg·m²]."""
    lead, efficiency = _usable(seen, through, "lead"), seen.real(through, "efficiency")
    entry = seen.user(through, "screw_losses", "screw")
    if entry is None:
        back = usual_back_efficiency(efficiency)
        if not back:
            words = f"`efficiency` is {efficiency:g}; a screw of 0.5 or less locks itself"
            raise seen.impossible(through, f"{words}: say what its nut drives in SCREW_LOSSES")
        return BallScrew(lead, efficiency, back), 0.0
    seen.take(entry, "gear", number, "losses")
    back, screw = (seen.real(entry, one) for one in ("back_efficiency", "screw_inertia"))
    return BallScrew(lead, efficiency, back, screw), seen.real(entry, "input_inertia")


def _link(seen: Seen, pair: int, number: int) -> LinkElasticity | None:
    """Return the elasticity of the link that a drive moves; None for a rigid one."""
    entry = seen.user(pair, "link_elasticity", "pair")
    if entry is None:
        return None
    seen.take(entry, "link elasticity", number)
    return LinkElasticity(*(seen.real(entry, one) for one in ("stiffness", "damping", "hub_inertia")))


def _usable(seen: Seen, number: int, name: str) -> float:
    """Return a ratio whose square and whose inverse are numbers of a robot."""
    value = seen.real(number, name)
    if abs(value) < 1.0 / LARGEST:
        raise seen.impossible(number, f"`{name}` is {value:g}, allowed is {1.0 / LARGEST:g} or more")
    return value


def _elastic(seen: Seen, pair: int, ratio: float, number: int) -> Gear | ElasticGear:
    """Return a gear that twists where the file says so of the joint, else a rigid one."""
    entry = seen.user(pair, "joint_elasticity", "pair")
    if entry is None:
        return Gear(ratio)
    seen.take(entry, "elasticity", number)
    return ElasticGear(ratio, seen.real(entry, "stiffness"), seen.real(entry, "damping"))
