"""Amplifiers: they clip the output of the joint controller; one of them also reads its motor."""

from collections.abc import Callable

from ropsim.codegen import Scalar, maximum, minimum
from ropsim.dynamics.drives.block import AmplifierBlock, Column, Limit, LimitSort, Numbers
from ropsim.model import InputKind


def _clipped(p: Numbers, command: Scalar) -> Scalar:
    limit = p[0]
    return minimum(maximum(command, -limit), limit)


def _within(p: Numbers, output: Scalar, keeping: Callable[[Scalar], Scalar]) -> Scalar:
    """Return the voltage u' of a current loop: u between Ke·ω - R·i_max and Ke·ω + R·i_max.

    L·di/dt = u' - R·i - Ke·ω <= R·(i_max - i): the distance from the limit shrinks by its own rate R/L at the
    fastest, so that a current within ±i_max stays there, however the motor is turned. The classical
    Runge-Kutta method also keeps to that with steps h of which h·R/L <= 1.29: there 1 - z + z²/2 - z³/4, the
    least of the weights of the amounts by which u' stays below its bound, is not negative. Where the back-EMF
    is so high that the largest voltage does not reach the band, that voltage is all.
    """
    voltage, current = p
    held = minimum(maximum(output, keeping(-current)), keeping(current))
    return minimum(maximum(held, -voltage), voltage)


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
CURRENT_LIMITED = AmplifierBlock(
    InputKind.VOLTAGE,
    ("max_voltage", "max_current"),
    ("max_voltage", "max_current"),
    Column("voltage", "V", "motor voltage"),
    _clipped,
    (
        Limit("current", LimitSort.LASTING, "max_current", near=0.99),
        Limit("voltage", LimitSort.LASTING, "max_voltage"),
    ),
    _within,
)
GUARDED = AmplifierBlock(
    InputKind.VOLTAGE,
    ("max_voltage",),
    ("max_voltage", "max_current", "max_rise"),
    Column("voltage", "V", "motor voltage"),
    _clipped,
    (
        Limit("current", LimitSort.PEAK, "max_current"),
        Limit("winding_rise", LimitSort.PEAK, "max_rise"),
        Limit("voltage", LimitSort.LASTING, "max_voltage"),
    ),
)
VALVE = AmplifierBlock(
    InputKind.CURRENT,
    ("max_input",),
    ("max_input",),
    Column("valve_current", "A", "current of the servo valve"),
    _clipped,
    (Limit("valve_current", LimitSort.LASTING, "max_input"),),
)
EFFORT = AmplifierBlock(
    InputKind.EFFORT,
    ("max_effort",),
    ("max_effort",),
    Column("command", "{tau}", "torque or force that the motor is commanded to give"),
    _clipped,
    (Limit("command", LimitSort.LASTING, "max_effort"),),
)
