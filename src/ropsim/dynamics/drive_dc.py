"""DC motor behind a gear: current, torque at the joint, reflected inertia."""

import math

from ropsim.codegen import Scalar
from ropsim.model import Drive
from ropsim.spatial import Array, frozen


def reflected_inertia(drive: Drive) -> float:
    """Return J·G² [kg·m²], what the rotor adds to the inertia seen by the joint."""
    return drive.motor.rotor_inertia * drive.ratio * drive.ratio


def torque_per_ampere(drive: Drive) -> float:
    """Return G·Kt [N·m/A], signed like the ratio."""
    return drive.ratio * drive.motor.torque_constant


def direction(drive: Drive) -> float:
    """Return +1 or -1: the sign of the motor voltage that drives the joint forward."""
    return math.copysign(1.0, drive.ratio)


def torque_constants(drives: tuple[Drive, ...]) -> Array:
    """Return G·Kt of each joint [N·m/A], shape (n,)."""
    return frozen([torque_per_ampere(drive) for drive in drives])


def trace_current_rate(drive: Drive, qd: Scalar, current: Scalar, voltage: Scalar) -> Scalar:
    """Return di/dt [A/s] = (u - R·i - Ke·G·q̇) / L."""
    motor = drive.motor
    inverse = 1.0 / motor.inductance
    back_emf = motor.back_emf_constant * drive.ratio * inverse
    return voltage * inverse - current * (motor.resistance * inverse) - qd * back_emf
