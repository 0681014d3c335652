"""A hydraulic motor at a servo valve: pressures of both chambers and the spool of the valve are states.

H. E. Merritt: Hydraulic Control Systems, Wiley 1967, chapters 5 and 6.
"""

from math import copysign
from math import sqrt as root

from ropsim.codegen import Scalar, maximum, sqrt
from ropsim.dynamics.drives.block import Column, MotorBlock, Numbers, Steady, Torque
from ropsim.model import HydraulicMotor, InputKind

LAMINAR = 1e5
"""Below this fall of pressure [Pa] the flow through an edge goes over from its root to a straight line."""


def _trace(p: Numbers, states: Numbers, current: Scalar, speed: Scalar) -> Torque:
    """Return D·(p_a - p_b), and the rates of both pressures and of the spool.

    Positive openings lead the supply to chamber a and chamber b to the return.
    """
    displacement, volume, leakage, _, supply, back, bulk, flow, drop, rated, natural, damping = p
    a, b, opening, rate = states
    zero = opening.tracer.constant(0.0)
    edge = flow * sqrt(2.0 / drop)
    forward, backward = maximum(opening, zero), maximum(-opening, zero)
    into_a = edge * (forward * _root(supply - a) - backward * _root(a - back))
    into_b = edge * (backward * _root(supply - b) - forward * _root(b - back))
    swept = displacement * speed + leakage * (a - b)
    stiff = bulk / volume
    wanted = current / rated - opening
    spool = natural * (natural * wanted - 2.0 * damping * rate)
    return Torque(displacement * (a - b), (stiff * (into_a - swept), stiff * (into_b + swept), rate, spool))


def _root(fall: Scalar) -> Scalar:
    """Return Δp/(Δp² + δ²)^¼: ±√|Δp| away from zero, a straight line near it."""
    return fall / sqrt(sqrt(fall * fall + LAMINAR * LAMINAR))


def _steady(motor: HydraulicMotor, torque: float, speed: float) -> Steady:
    """Return equal falls of pressure at both edges; beyond stall the flow is that of laminar edges."""
    load = torque / motor.displacement
    flow = motor.displacement * speed + motor.leakage * load
    middle = 0.5 * (motor.supply_pressure + motor.return_pressure)
    fall = 0.5 * (motor.supply_pressure - motor.return_pressure - copysign(load, flow * load))
    through = fall / root(root(fall * fall + LAMINAR * LAMINAR)) if fall > 0.0 else root(LAMINAR)
    opening = flow / (motor.rated_flow * root(2.0 / motor.rated_pressure_drop) * through)
    states = (middle + 0.5 * load, middle - 0.5 * load, opening, 0.0)
    return Steady(states, opening * motor.rated_input)


HYDRAULIC_MOTOR = MotorBlock(
    takes=InputKind.CURRENT,
    numbers=(
        "displacement",
        "chamber_volume",
        "leakage",
        "rotor_inertia",
        "supply_pressure",
        "return_pressure",
        "bulk_modulus",
        "rated_flow",
        "rated_pressure_drop",
        "rated_input",
        "natural_frequency",
        "damping_ratio",
    ),
    positive=(
        "displacement",
        "chamber_volume",
        "supply_pressure",
        "bulk_modulus",
        "rated_flow",
        "rated_pressure_drop",
        "rated_input",
        "natural_frequency",
        "damping_ratio",
    ),
    states=(
        Column("pressure_a", "Pa", "pressure of the chamber that drives the motor forward"),
        Column("pressure_b", "Pa", "pressure of the other chamber"),
        Column("opening", "1", "opening of the valve, 1 at its rated current"),
        Column("opening_rate", "1/s", "speed of the spool"),
    ),
    trace=_trace,
    inertia=lambda p: p[3],
    steady=_steady,
    pole=lambda motor: float(motor.natural_frequency),
    most=lambda motor: float(motor.displacement * (motor.supply_pressure - motor.return_pressure)),
)
