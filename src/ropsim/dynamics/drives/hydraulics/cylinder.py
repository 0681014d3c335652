"""A cylinder with one rod at a servo valve: its chambers grow and shrink with the way of the rod.

H. E. Merritt: Hydraulic Control Systems, Wiley 1967, chapters 5 and 6; M. Jelali, A. Kroll: Hydraulic
Servo-systems, Springer 2003, chapter 4.
"""

from ropsim.codegen import Scalar, maximum, minimum
from ropsim.dynamics.drives.block import MotorBlock, Movement, Numbers, Steady, Torque
from ropsim.dynamics.drives.hydraulics.servo_valve import (
    MOST_OPENING,
    VALVE_NUMBERS,
    VALVE_POSITIVE,
    VALVE_STATES,
    Valve,
    crossing,
    flow_into,
    opening_for,
    supply_power,
    trace_flows,
    trace_spool,
    trace_taken,
)
from ropsim.model import HydraulicCylinder, InputKind

_ROUNDS = 60
"""Enough for leaks that are small compared with the flow of the piston."""


def _trace(p: Numbers, states: Numbers, current: Scalar, rod: Movement) -> Torque:
    """Return A_a·p_a - A_b·p_b, and the rates of both pressures and of the spool.

    Beyond the ends of the stroke the chambers keep the volumes that they have there.
    """
    area_a, area_b, stroke, dead_a, dead_b, leakage, _, bulk, *rest = p
    valve = Valve(*rest)
    a, b, opening, rate = states
    into_a, into_b = trace_flows(valve, a, b, opening)
    out = minimum(maximum(rod.place, stroke.tracer.constant(0.0)), stroke)
    leak = leakage * (a - b)
    rate_a = bulk / (dead_a + area_a * out) * (into_a - area_a * rod.speed - leak)
    rate_b = bulk / (dead_b + area_b * (stroke - out)) * (into_b + area_b * rod.speed + leak)
    spool = trace_spool(valve, current, opening, rate)
    return Torque(area_a * a - area_b * b, (rate_a, rate_b, rate, spool))


def _steady(cylinder: HydraulicCylinder, force: float, speed: float) -> Steady:
    """Return the pressures at which as much flows through each edge as its chamber takes.

    Falls of pressure at the edges are as the squares of the flows. At standstill both are the leak; the same
    is taken where leak and motion nearly cancel in one chamber. Beyond stall the flow is that of laminar
    edges.
    """
    if cylinder.null_flow:
        return _leaking(cylinder, force, speed)
    ends = (cylinder.supply_pressure, cylinder.return_pressure)
    a, b = _pressures(cylinder, force, 1.0, ends)
    for _ in range(_ROUNDS):
        leak = cylinder.leakage * (a - b)
        into_a, out_of_b = cylinder.area_a * speed + leak, cylinder.area_b * speed + leak
        share = (into_a / out_of_b) ** 2 if into_a * out_of_b > 0.0 else 1.0
        a, b = _pressures(cylinder, force, share, ends if into_a >= 0.0 else ends[::-1])
    flow = cylinder.area_a * speed + cylinder.leakage * (a - b)
    fall = cylinder.supply_pressure - a if flow >= 0.0 else a - cylinder.return_pressure
    opening = opening_for(cylinder, flow, fall)
    return Steady((a, b, opening, 0.0), opening * cylinder.rated_input)


def _leaking(cylinder: HydraulicCylinder, force: float, speed: float) -> Steady:
    """Return the steady state with a valve whose edges leak.

    What flows into one chamber, times the area of the other, falls with their pressures, which the force ties
    to each other: for an opening they are where the leak between the chambers alone is left of the sum. And
    the rod goes the faster, the more the valve is open.
    """
    area_a, area_b = cylinder.area_a, cylinder.area_b
    most = 2.0 * (cylinder.supply_pressure + abs(force) / area_b)

    def leak(b: float) -> float:
        return cylinder.leakage * ((force + area_b * b) / area_a - b)

    def pressures(opening: float) -> tuple[float, float]:
        def short(b: float) -> float:
            a = (force + area_b * b) / area_a
            into = area_b * flow_into(cylinder, a, opening) + area_a * flow_into(cylinder, b, -opening)
            return (area_b - area_a) * leak(b) - into

        b = crossing(short, most)
        return (force + area_b * b) / area_a, b

    def faster(opening: float) -> float:
        a, b = pressures(opening)
        return flow_into(cylinder, a, opening) - leak(b) - area_a * speed

    opening = crossing(faster, MOST_OPENING)
    return Steady((*pressures(opening), opening, 0.0), opening * cylinder.rated_input)


def _pressures(
    cylinder: HydraulicCylinder, force: float, share: float, ends: tuple[float, float]
) -> tuple[float, float]:
    """Return the pressures of both chambers [Pa] that produce a force [N].

    Args:
        cylinder: the cylinder.
        force: that drives its rod out.
        share: fall of pressure at the edge of chamber a over that at the edge of chamber b.
        ends: pressures behind these edges.
    """
    b = (ends[0] + share * ends[1] - force / cylinder.area_a) / (share + cylinder.area_b / cylinder.area_a)
    return (force + cylinder.area_b * b) / cylinder.area_a, b


def _most(cylinder: HydraulicCylinder) -> float:
    """Return the force [N] with which it pushes and pulls, the smaller of the two."""
    supply, back = cylinder.supply_pressure, cylinder.return_pressure
    push = cylinder.area_a * supply - cylinder.area_b * back
    return float(min(push, cylinder.area_b * supply - cylinder.area_a * back))


HYDRAULIC_CYLINDER = MotorBlock(
    takes=InputKind.CURRENT,
    numbers=(
        "area_a",
        "area_b",
        "stroke",
        "dead_volume_a",
        "dead_volume_b",
        "leakage",
        "moving_mass",
        "bulk_modulus",
        *VALVE_NUMBERS,
    ),
    positive=(
        "area_a",
        "area_b",
        "stroke",
        "dead_volume_a",
        "dead_volume_b",
        "bulk_modulus",
        *VALVE_POSITIVE,
    ),
    states=VALVE_STATES,
    trace=_trace,
    inertia=lambda p: p[6],
    steady=_steady,
    pole=lambda cylinder: float(cylinder.natural_frequency),
    power=supply_power,
    taken=trace_taken,
    most=_most,
)
