"""Amplifiers: they clip what the joint controller puts out."""

from ropsim.codegen import Scalar, maximum, minimum
from ropsim.dynamics.drives.block import AmplifierBlock, Column, Limit, LimitSort, Numbers
from ropsim.model import InputKind


def _clipped(p: Numbers, command: Scalar) -> Scalar:
    (limit,) = p
    return minimum(maximum(command, -limit), limit)


VOLTAGE = AmplifierBlock(
    InputKind.VOLTAGE,
    ("max_voltage",),
    ("max_voltage", "max_current"),
    Column("voltage", "V", "motor voltage"),
    _clipped,
    (
        Limit("current", LimitSort.PEAK, "max_current"),
        Limit("voltage", LimitSort.LASTING, "max_voltage"),
    ),
)
EFFORT = AmplifierBlock(
    InputKind.EFFORT,
    ("max_effort",),
    ("max_effort",),
    Column("command", "{tau}", "torque or force that the motor is commanded to give"),
    _clipped,
    (Limit("command", LimitSort.LASTING, "max_effort"),),
)
