"""A servo valve with four edges: flow into two chambers, and motion of its spool.

H. E. Merritt: Hydraulic Control Systems, Wiley 1967, chapter 5.
"""

from math import sqrt as root

from ropsim.codegen import Scalar, maximum, sqrt
from ropsim.dynamics.drives.block import Column, Numbers
from ropsim.model import Hydraulic

LAMINAR = 1e5
"""Below this fall of pressure [Pa] the flow through an edge goes over from its root to a straight line."""
VACUUM = -1.01325e5
"""Gauge pressure of a vacuum [Pa]; real oil cavitates before."""

VALVE_NUMBERS = (
    "return_pressure",
    "supply_pressure",
    "rated_flow",
    "rated_pressure_drop",
    "rated_input",
    "natural_frequency",
    "damping_ratio",
)
"""Attributes of a hydraulic motor or cylinder in these formulas; all except the first are positive."""
VALVE_STATES = (
    Column("pressure_a", "Pa", "pressure of the chamber that drives the motor forward", VACUUM),
    Column("pressure_b", "Pa", "pressure of the other chamber", VACUUM),
    Column("opening", "1", "opening of the valve, 1 at its rated current"),
    Column("opening_rate", "1/s", "speed of the spool"),
)


def trace_flows(valve: Numbers, a: Scalar, b: Scalar, opening: Scalar) -> tuple[Scalar, Scalar]:
    """Return the flow into chamber a and into chamber b [m³/s].

    Positive openings lead the supply to chamber a and chamber b to the return.

    Args:
        valve: its numbers.
        a: pressure of chamber a [Pa].
        b: of chamber b [Pa].
        opening: of the valve.
    """
    back, supply, flow, drop, *_ = valve
    zero = opening.tracer.constant(0.0)
    edge = flow * sqrt(2.0 / drop)
    forward, backward = maximum(opening, zero), maximum(-opening, zero)
    into_a = edge * (forward * _root(supply - a) - backward * _root(a - back))
    into_b = edge * (backward * _root(supply - b) - forward * _root(b - back))
    return into_a, into_b


def trace_spool(valve: Numbers, current: Scalar, opening: Scalar, rate: Scalar) -> Scalar:
    """Return the acceleration of the spool [1/s²]."""
    *_, rated, natural, damping = valve
    wanted = current / rated - opening
    return natural * (natural * wanted - 2.0 * damping * rate)


def opening_for(record: Hydraulic, flow: float, fall: float) -> float:
    """Return how far an edge is open that lets a flow [m³/s] through at a fall of pressure [Pa].

    Where the fall has the other sign, the flow is that of laminar edges.
    """
    through = fall / root(root(fall * fall + LAMINAR * LAMINAR)) if fall > 0.0 else root(LAMINAR)
    return flow / (record.rated_flow * root(2.0 / record.rated_pressure_drop) * through)


def _root(fall: Scalar) -> Scalar:
    """Return Δp/(Δp² + δ²)^¼: ±√|Δp| away from zero, a straight line near it."""
    return fall / sqrt(sqrt(fall * fall + LAMINAR * LAMINAR))
