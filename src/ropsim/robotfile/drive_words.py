"""Drives as TOML text."""

from ropsim.model import (
    CurrentLimitedAmplifier,
    DcMotor,
    Drive,
    EffortAmplifier,
    ElasticGear,
    Friction,
    HydraulicMotor,
    IdealMotor,
    ValveAmplifier,
    VoltageAmplifier,
)
from ropsim.robotfile.toml_words import number, row, text, unless


def drive_keys(drive: Drive) -> dict[str, str] | None:
    """Return the keys of a drive; None where it is made of other blocks than a robot file knows."""
    match drive.amplifier, drive.motor:
        case VoltageAmplifier() | CurrentLimitedAmplifier(), DcMotor():
            keys = _dc(drive.amplifier, drive.motor)
        case EffortAmplifier(most), IdealMotor(inertia):
            keys = {
                "kind": text("servo"),
                "max_torque": unless(most, 0.0),
                "rotor_inertia": unless(inertia, 0.0),
            }
        case ValveAmplifier(most), HydraulicMotor():
            keys = _hydraulic(most, drive.motor)
        case _:
            return None
    return keys | _gear(drive) | _friction(drive.friction)


def _dc(amplifier: VoltageAmplifier | CurrentLimitedAmplifier, motor: DcMotor) -> dict[str, str]:
    return {
        "kind": text("dc"),
        "torque_constant": number(motor.torque_constant),
        "back_emf_constant": unless(motor.back_emf_constant, motor.torque_constant),
        "resistance": number(motor.resistance),
        "inductance": number(motor.inductance),
        "rotor_inertia": number(motor.rotor_inertia),
        "max_voltage": number(amplifier.max_voltage),
        "max_current": number(amplifier.max_current),
        "limits_current": "true" if isinstance(amplifier, CurrentLimitedAmplifier) else "",
    }


def _hydraulic(most: float, motor: HydraulicMotor) -> dict[str, str]:
    return {
        "kind": text("hydraulic"),
        "displacement": number(motor.displacement),
        "chamber_volume": number(motor.chamber_volume),
        "leakage": unless(motor.leakage, 0.0),
        "rotor_inertia": unless(motor.rotor_inertia, 0.0),
        "supply_pressure": number(motor.supply_pressure),
        "return_pressure": unless(motor.return_pressure, 0.0),
        "bulk_modulus": number(motor.bulk_modulus),
        "rated_flow": number(motor.rated_flow),
        "rated_pressure_drop": number(motor.rated_pressure_drop),
        "rated_input": number(motor.rated_input),
        "max_input": unless(most, motor.rated_input),
        "natural_frequency": number(motor.natural_frequency),
        "damping_ratio": unless(motor.damping_ratio, 0.7),
        "oil_density": unless(motor.oil_density, 870.0),
    }


def _gear(drive: Drive) -> dict[str, str]:
    keys = {"ratio": number(drive.ratio)}
    if isinstance(drive.transmission, ElasticGear):
        keys["stiffness"] = number(drive.transmission.stiffness)
        keys["damping"] = unless(drive.transmission.damping, 0.0)
    return keys


def _friction(friction: Friction) -> dict[str, str]:
    positive, negative = friction.coulomb_positive, -friction.coulomb_negative
    both = unless(positive, 0.0) if positive == negative else row(map(number, (positive, negative)))
    return {
        "viscous": unless(friction.viscous, 0.0),
        "coulomb": both,
        "smoothing_speed": unless(friction.smoothing_speed, Friction().smoothing_speed),
    }
