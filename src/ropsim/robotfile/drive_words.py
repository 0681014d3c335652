"""Drives as TOML text."""

from typing import assert_never

from ropsim.core import frozen_dataclass
from ropsim.model import (
    COPPER,
    WRITTEN,
    BacklashGear,
    BallScrew,
    CurrentLimitedAmplifier,
    CurrentLoopMotor,
    DcMotor,
    Drive,
    EffortAmplifier,
    Elastic,
    Friction,
    FrictionLaw,
    GuardedAmplifier,
    Hydraulic,
    HydraulicCylinder,
    HydraulicMotor,
    HydraulicVane,
    IdealMotor,
    LaggingMotor,
    Linkage,
    LoadFriction,
    LugreFriction,
    StribeckFriction,
    ThermalDcMotor,
    ValveAmplifier,
    VoltageAmplifier,
    lead_per_turn,
    pin_at,
    usual_back_efficiency,
)
from ropsim.robotfile.toml_words import number, row, text, unless
from ropsim.spatial import Pose


@frozen_dataclass
class PinFrames:
    """Where the frames stand in which the model has the pins of a cylinder.

    Attributes:
        carrier: frame of the link at coordinate 0 in that of the table before the joint.
        link: frame of the link in that of its row.
    """

    carrier: Pose
    link: Pose


def drive_keys(drive: Drive, frames: PinFrames) -> dict[str, str] | None:
    """Return the keys of a drive; None where it is made of other blocks than a robot file supports."""
    match drive.amplifier, drive.motor:
        case VoltageAmplifier() | CurrentLimitedAmplifier(), DcMotor():
            most = drive.amplifier.max_voltage, drive.amplifier.max_current
            limits = "true" if isinstance(drive.amplifier, CurrentLimitedAmplifier) else ""
            keys = _dc(drive.motor, most) | {"limits_current": limits}
        case GuardedAmplifier(voltage, current, rise), ThermalDcMotor():
            keys = _dc(drive.motor, (voltage, current)) | _heat(drive.motor, rise)
        case EffortAmplifier(most_torque), CurrentLoopMotor(max_voltage=voltage, max_current=current):
            own = {
                "current_bandwidth": number(drive.motor.bandwidth),
                "max_torque": unless(most_torque, drive.motor.torque_constant * current),
            }
            keys = _dc(drive.motor, (voltage, current)) | own
        case EffortAmplifier(most), IdealMotor() | LaggingMotor():
            lag = drive.motor.bandwidth if isinstance(drive.motor, LaggingMotor) else 0.0
            keys = {
                "kind": text("servo"),
                "max_torque": unless(most, 0.0),
                "current_bandwidth": unless(lag, 0.0),
                "rotor_inertia": unless(drive.motor.rotor_inertia, 0.0),
            }
        case ValveAmplifier(most), HydraulicMotor():
            keys = _hydraulic(most, drive.motor)
        case ValveAmplifier(most), HydraulicVane():
            keys = _vane(most, drive.motor)
        case ValveAmplifier(most), HydraulicCylinder():
            if not isinstance(drive.transmission, Linkage):
                return None
            keys = _cylinder(most, drive.motor)
            keys |= _linkage(drive.transmission, frames)
            return keys | _friction(drive.friction) | _supply(drive) | _link(drive)
        case _:
            return None
    return keys | _gear(drive) | _friction(drive.friction) | _supply(drive) | _link(drive)


def _supply(drive: Drive) -> dict[str, str]:
    return {"supply": text(drive.supply.name)} if drive.supply else {}


def _dc(motor: DcMotor | ThermalDcMotor | CurrentLoopMotor, most: tuple[float, float]) -> dict[str, str]:
    return {
        "kind": text("dc"),
        "torque_constant": number(motor.torque_constant),
        "back_emf_constant": unless(motor.back_emf_constant, motor.torque_constant),
        "resistance": number(motor.resistance),
        "inductance": number(motor.inductance),
        "rotor_inertia": number(motor.rotor_inertia),
        "max_voltage": number(most[0]),
        "max_current": number(most[1]),
    }


def _heat(motor: ThermalDcMotor, rise: float) -> dict[str, str]:
    return {
        "winding_thermal_resistance": number(motor.winding_thermal_resistance),
        "housing_thermal_resistance": number(motor.housing_thermal_resistance),
        "winding_time_constant": number(motor.winding_time_constant),
        "housing_time_constant": number(motor.housing_time_constant),
        "resistance_drift": unless(motor.resistance_drift, COPPER),
        "torque_drift": unless(-motor.torque_drift, 0.0),
        "start_rise": unless(motor.start_rise, 0.0),
        "max_rise": unless(rise, 0.0),
    }


def _hydraulic(most: float, motor: HydraulicMotor) -> dict[str, str]:
    return {
        "kind": text("hydraulic"),
        "displacement": number(motor.displacement),
        "chamber_volume": number(motor.chamber_volume),
        "rotor_inertia": unless(motor.rotor_inertia, 0.0),
        **_valve(most, motor),
    }


def _vane(most: float, motor: HydraulicVane) -> dict[str, str]:
    return {
        "kind": text("vane"),
        "displacement": number(motor.displacement),
        "swing": number(motor.swing),
        "first_angle": number(motor.first_angle),
        "dead_volume": number(motor.dead_volume),
        "rotor_inertia": unless(motor.rotor_inertia, 0.0),
        **_valve(most, motor),
    }


def _cylinder(most: float, motor: HydraulicCylinder) -> dict[str, str]:
    return {
        "kind": text("cylinder"),
        "area_a": number(motor.area_a),
        "area_b": number(motor.area_b),
        "stroke": number(motor.stroke),
        "dead_volume_a": number(motor.dead_volume_a),
        "dead_volume_b": number(motor.dead_volume_b),
        "moving_mass": unless(motor.moving_mass, 0.0),
        **_valve(most, motor),
    }


def _linkage(gear: Linkage, frames: PinFrames) -> dict[str, str]:
    return {
        "retracted_length": number(gear.retracted_length),
        "carrier_pin": row(map(number, pin_at(frames.carrier, gear.carrier_pin, WRITTEN))),
        "link_pin": row(map(number, pin_at(frames.link, gear.link_pin, WRITTEN))),
    }


def _valve(most: float, motor: Hydraulic) -> dict[str, str]:
    return {
        "leakage": unless(motor.leakage, 0.0),
        "supply_pressure": number(motor.supply_pressure),
        "return_pressure": unless(motor.return_pressure, 0.0),
        "bulk_modulus": number(motor.bulk_modulus),
        "rated_flow": number(motor.rated_flow),
        "rated_pressure_drop": number(motor.rated_pressure_drop),
        "rated_input": number(motor.rated_input),
        "max_input": unless(most, motor.rated_input),
        "natural_frequency": number(motor.natural_frequency),
        "damping_ratio": unless(motor.damping_ratio, 0.7),
        "null_flow": unless(motor.null_flow, 0.0),
        "overlap": unless(motor.overlap, 0.0),
        "oil_density": unless(motor.oil_density, 870.0),
    }


def _gear(drive: Drive) -> dict[str, str]:
    gear = drive.transmission
    if isinstance(gear, Linkage):
        return {}
    if isinstance(gear, BallScrew):
        return {
            "lead": number(lead_per_turn(gear.lead)),
            "efficiency": unless(gear.efficiency, 1.0),
            "back_efficiency": unless(gear.back_efficiency, usual_back_efficiency(gear.efficiency)),
            "screw_inertia": unless(gear.screw_inertia, 0.0),
        }
    keys = {"ratio": number(gear.ratio)}
    if isinstance(gear, Elastic):
        keys["stiffness"] = number(gear.stiffness)
        keys["damping"] = unless(gear.damping, 0.0)
    if isinstance(gear, BacklashGear):
        keys["backlash"] = number(gear.backlash)
    return keys


def _link(drive: Drive) -> dict[str, str]:
    """Return the keys of the elasticity of the link that a drive moves; none for a rigid one."""
    link = drive.link
    if link is None:
        return {}
    return {
        "link_stiffness": number(link.stiffness),
        "link_damping": unless(link.damping, 0.0),
        "hub_inertia": unless(link.hub_inertia, 0.0),
    }


def _friction(law: FrictionLaw) -> dict[str, str]:
    positive, negative = law.coulomb_positive, -law.coulomb_negative
    both = unless(positive, 0.0) if positive == negative else row(map(number, (positive, negative)))
    return {
        "viscous": unless(law.viscous, 0.0),
        "coulomb": both,
        **_own(law),
        "smoothing_speed": unless(law.smoothing_speed, Friction().smoothing_speed),
    }


def _own(law: FrictionLaw) -> dict[str, str]:
    """Return the keys that a law of friction has to itself."""
    match law:
        case StribeckFriction():
            low = {"breakaway": number(law.breakaway), "stribeck_speed": number(law.stribeck_speed)}
            return low | {"stribeck_exponent": unless(law.exponent, 2.0)}
        case LoadFriction():
            return {"load_share": number(law.load_share)}
        case LugreFriction():
            low = {"breakaway": number(law.breakaway), "stribeck_speed": number(law.stribeck_speed)}
            return low | {
                "bristle_stiffness": number(law.bristle_stiffness),
                "bristle_damping": unless(law.bristle_damping, 0.0),
            }
        case Friction():
            return {}
        case _:
            assert_never(law)
