"""A servo valve with four edges: flow into two chambers, and motion of its spool.

H. E. Merritt: Hydraulic Control Systems, Wiley 1967, chapter 5.
"""

from collections.abc import Callable
from math import copysign
from math import sqrt as root
from typing import NamedTuple, TypeVar

import numpy as np

from ropsim.codegen import Scalar, sqrt
from ropsim.dynamics.drives.block import Column, Numbers, Recorded
from ropsim.model import Hydraulic
from ropsim.spatial import Array

_Number = TypeVar("_Number", float, Array, Scalar)
_Plain = TypeVar("_Plain", float, Array)
_Ratio = TypeVar("_Ratio", float, Scalar)

LAMINAR = 1e5
"""Below this fall of pressure [Pa] the flow through an edge goes over from its root to a straight line."""
VACUUM = -1.01325e5
"""Gauge pressure of a vacuum [Pa]; real oil cavitates before."""


class Valve(NamedTuple):
    """The numbers of a valve and its supply in these formulas, called as the attributes of `AtValve`.

    They stand behind the numbers of the motor or cylinder that is at the valve.
    """

    return_pressure: Scalar
    supply_pressure: Scalar
    rated_flow: Scalar
    rated_pressure_drop: Scalar
    null_flow: Scalar
    overlap: Scalar
    rated_input: Scalar
    natural_frequency: Scalar
    damping_ratio: Scalar


VALVE_NUMBERS = Valve._fields
VALVE_POSITIVE = (
    "supply_pressure",
    "rated_flow",
    "rated_pressure_drop",
    "rated_input",
    "natural_frequency",
    "damping_ratio",
)
"""Those that are positive; the others may be 0."""
MOST_OPENING = 100.0
"""Openings beyond this are looked for nowhere."""
_HALVINGS = 60
LEAST_CLOSED = 1e-12
"""Added to the openings that an edge is compared with: without null flow they are 0."""
VALVE_STATES = (
    Column("pressure_a", "Pa", "pressure of the chamber that drives the motor forward", VACUUM),
    Column("pressure_b", "Pa", "pressure of the other chamber", VACUUM),
    Column("opening", "1", "opening of the valve, 1 at its rated current"),
    Column("opening_rate", "1/s", "speed of the spool"),
)


def trace_flows(valve: Valve, a: Scalar, b: Scalar, opening: Scalar) -> tuple[Scalar, Scalar]:
    """Return the flow into chamber a and into chamber b [m³/s].

    Positive openings lead the supply to chamber a and chamber b to the return.

    Args:
        valve: its numbers.
        a: pressure of chamber a [Pa].
        b: of chamber b [Pa].
        opening: of the valve.
    """
    back, supply = valve.return_pressure, valve.supply_pressure
    edge = valve.rated_flow * sqrt(2.0 / valve.rated_pressure_drop)
    forward, backward = _trace_edges(valve, opening)
    into_a = edge * (forward * _root(supply - a) - backward * _root(a - back))
    into_b = edge * (backward * _root(supply - b) - forward * _root(b - back))
    return into_a, into_b


def trace_taken(p: Numbers, states: Numbers) -> Scalar:
    """Return the flow out of the supply through both edges [m³/s].

    Args:
        p: numbers of a hydraulic motor or cylinder, those of its valve last.
        states: `VALVE_STATES`.
    """
    valve = Valve(*p[-len(VALVE_NUMBERS) :])
    a, b, opening, _ = states
    supply, edge = valve.supply_pressure, valve.rated_flow * sqrt(2.0 / valve.rated_pressure_drop)
    forward, backward = _trace_edges(valve, opening)
    return edge * (forward * _root(supply - a) + backward * _root(supply - b))


def trace_spool(valve: Valve, current: Scalar, opening: Scalar, rate: Scalar) -> Scalar:
    """Return the acceleration of the spool [1/s²]."""
    natural = valve.natural_frequency
    wanted = current / valve.rated_input - opening
    return natural * (natural * wanted - 2.0 * valve.damping_ratio * rate)


def _trace_edges(valve: Valve, opening: Scalar) -> tuple[Scalar, Scalar]:
    """Return how far the edges that open forward and those that open backward let flow through."""
    least = _least(valve.null_flow / (2.0 * valve.rated_flow), valve.overlap, sqrt)
    return _edge(opening, least, valve.overlap), _edge(-opening, least, valve.overlap)


def _edges(record: Hydraulic, opening: _Plain) -> tuple[_Plain, _Plain]:
    """Return the same of a record, for one opening or an array of them."""
    least = least_opening(record)
    return _edge(opening, least, record.overlap), _edge(-opening, least, record.overlap)


def _edge(opening: _Number, least: _Number | float, overlap: _Number | float) -> _Number:
    """Return how far an edge lets flow through, 1 at the rated current.

    With the overlap o it is closed up to y = (x - o)/(1 - o) = 0. Beyond it is x0 + y, below x0²/(x0 - y),
    both over 1 + x0 (B. Eryilmaz, B. H. Wilson: Improved tracking control of hydraulic systems, ASME J. Dyn.
    Sys. Meas. Control 123 (2001), 457-462).

    Args:
        opening: x.
        least: x0, see `least_opening`.
        overlap: o.
    """
    beyond, closed = (opening - overlap) * (1.0 / (1.0 - overlap)), least + LEAST_CLOSED
    size = abs(beyond)
    opened, shut = 0.5 * (size + beyond), 0.5 * (size - beyond)
    return (opened + least * closed / (closed + shut)) * (1.0 / (1.0 + least))


def _least(leak: _Ratio, overlap: _Ratio, root_of: Callable[[_Ratio], _Ratio]) -> _Ratio:
    """Return x0 of `_edge`, such that Q_0/(2·Q_r), the leak, is left of it at the centre."""
    lap = overlap / (1.0 - overlap)
    middle = leak * (1.0 + lap)
    return (middle + root_of(middle * middle + 4.0 * (1.0 - leak) * leak * lap)) / (2.0 * (1.0 - leak))


def opening_for(record: Hydraulic, flow: float, fall: float) -> float:
    """Return the opening of a valve that lets a flow [m³/s] through an edge at a fall of pressure [Pa].

    Its edges do not leak. Where the fall has the other sign, the flow is that of laminar edges.
    """
    through = fall / root(root(fall * fall + LAMINAR * LAMINAR)) if fall > 0.0 else root(LAMINAR)
    beyond = flow / (record.rated_flow * root(2.0 / record.rated_pressure_drop) * through)
    return beyond * (1.0 - record.overlap) + (copysign(record.overlap, beyond) if beyond else 0.0)


def flow_into(record: Hydraulic, pressure: float, opening: float) -> float:
    """Return the flow [m³/s] that a valve lets into a chamber of a pressure [Pa], as `trace_flows` does.

    Args:
        record: with the valve.
        pressure: of the chamber.
        opening: of the edge to the supply; that to the return is open by as much on the other side.
    """
    edge = record.rated_flow * root(2.0 / record.rated_pressure_drop)
    falls = record.supply_pressure - pressure, pressure - record.return_pressure
    into, out = (fall / root(root(fall * fall + LAMINAR * LAMINAR)) for fall in falls)
    to_supply, to_return = _edges(record, opening)
    return edge * (to_supply * into - to_return * out)


def supply_power(record: Hydraulic, columns: Recorded, speed: Array) -> Array:
    """Return the supply pressure times the flow out of the supply through both edges [W].

    Args:
        record: with the valve.
        columns: `VALVE_STATES`, shape (rows,) each, and the pressure of a supply with an accumulator.
        speed: of the shaft; the flow through the edges does not depend on it.
    """
    del speed
    opening = columns["opening"]
    supply = columns.get("supply_pressure", record.supply_pressure)
    falls = [supply - columns[one] for one in ("pressure_a", "pressure_b")]
    roots = [fall / np.sqrt(np.sqrt(fall * fall + LAMINAR * LAMINAR)) for fall in falls]
    edge = record.rated_flow * root(2.0 / record.rated_pressure_drop)
    forward, backward = _edges(record, opening)
    flow = edge * (forward * roots[0] + backward * roots[1])
    return np.asarray(supply * flow)


def least_opening(record: Hydraulic) -> float:
    """Return the opening to which the null flow of a closed edge corresponds."""
    return _least(record.null_flow / (2.0 * record.rated_flow), record.overlap, root)


def crossing(grows: Callable[[float], float], most: float) -> float:
    """Return where a function that grows is 0, by the method of Ridders, which halves at least.

    C. J. F. Ridders: A new algorithm for computing a single root of a real continuous function, IEEE Trans.
    Circuits and Systems 26 (1979), 979-980.

    Args:
        grows: the function.
        most: the place is within ±most.
    """
    low, high = -most, most
    below, above = grows(low), grows(high)
    if below >= 0.0 or above <= 0.0:
        return low if below >= 0.0 else high
    least, place = 2.0 * most * 0.5**_HALVINGS, low
    for _ in range(_HALVINGS):
        half = 0.5 * (high - low)
        middle = low + half
        between = grows(middle)
        before, place = place, middle - half * between / root(between * between - below * above)
        if abs(place - before) <= least or half <= least:
            break
        value = grows(place)
        for one, found in ((middle, between), (place, value)):
            if found < 0.0 and one > low:
                low, below = one, found
            elif found >= 0.0 and one < high:
                high, above = one, found
        if not above:
            return high
    return place


def _root(fall: Scalar) -> Scalar:
    """Return Δp/(Δp² + δ²)^¼: ±√|Δp| away from zero, a straight line near it."""
    return fall / sqrt(sqrt(fall * fall + LAMINAR * LAMINAR))
