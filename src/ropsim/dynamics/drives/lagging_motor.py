"""A source of torque or force that follows its command with a lag: its torque is a state."""

from ropsim.codegen import Scalar
from ropsim.dynamics.drives.block import Column, MotorBlock, Movement, Numbers, Steady, Torque
from ropsim.model import InputKind, LaggingMotor


def _trace(p: Numbers, states: Numbers, effort: Scalar, shaft: Movement) -> Torque:
    """Return τ and dτ/dt = ω_c·(command - τ)."""
    del shaft
    (torque,) = states
    return Torque(torque, (p[1] * (effort - torque),))


def _steady(motor: LaggingMotor, torque: float, speed: float) -> Steady:
    del motor, speed
    return Steady((torque,), torque)


LAGGING_MOTOR = MotorBlock(
    takes=InputKind.EFFORT,
    numbers=("rotor_inertia", "bandwidth"),
    positive=("bandwidth",),
    states=(Column("motor_torque", "{tau}", "torque or force that the motor gives"),),
    trace=_trace,
    inertia=lambda p: p[0],
    steady=_steady,
    pole=lambda motor: float(motor.bandwidth),
)
