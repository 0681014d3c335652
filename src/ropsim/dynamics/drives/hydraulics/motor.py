"""A hydraulic motor at a servo valve: pressures of both chambers and the spool of the valve are states.

H. E. Merritt: Hydraulic Control Systems, Wiley 1967, chapters 5 and 6.
"""

from math import copysign

from ropsim.codegen import Scalar
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
from ropsim.model import HydraulicMotor, HydraulicVane, InputKind


def _trace(p: Numbers, states: Numbers, current: Scalar, shaft: Movement) -> Torque:
    """Return D·(p_a - p_b), and the rates of both pressures and of the spool."""
    displacement, volume, leakage, _, bulk, *rest = p
    valve = Valve(*rest)
    a, b, opening, rate = states
    into_a, into_b = trace_flows(valve, a, b, opening)
    swept = displacement * shaft.speed + leakage * (a - b)
    stiff = bulk / volume
    spool = trace_spool(valve, current, opening, rate)
    return Torque(displacement * (a - b), (stiff * (into_a - swept), stiff * (into_b + swept), rate, spool))


def steady_motor(motor: HydraulicMotor | HydraulicVane, torque: float, speed: float) -> Steady:
    """Return equal falls of pressure at both edges; beyond stall the flow is that of laminar edges."""
    load = torque / motor.displacement
    flow = motor.displacement * speed + motor.leakage * load
    middle = 0.5 * (motor.supply_pressure + motor.return_pressure)
    fall = 0.5 * (motor.supply_pressure - motor.return_pressure - copysign(load, flow * load))
    a, b = middle + 0.5 * load, middle - 0.5 * load
    opening = opening_for(motor, flow, fall)
    if motor.null_flow and motor.return_pressure < a < motor.supply_pressure:
        opening = crossing(lambda x: flow_into(motor, a, x) - flow, MOST_OPENING)
    return Steady((a, b, opening, 0.0), opening * motor.rated_input)


def most_torque(motor: HydraulicMotor | HydraulicVane) -> float:
    """Return D·(p_s - p_r) [N·m | N]."""
    return float(motor.displacement * (motor.supply_pressure - motor.return_pressure))


HYDRAULIC_MOTOR = MotorBlock(
    takes=InputKind.CURRENT,
    numbers=("displacement", "chamber_volume", "leakage", "rotor_inertia", "bulk_modulus", *VALVE_NUMBERS),
    positive=("displacement", "chamber_volume", "bulk_modulus", *VALVE_POSITIVE),
    states=VALVE_STATES,
    trace=_trace,
    inertia=lambda p: p[3],
    steady=steady_motor,
    pole=lambda motor: float(motor.natural_frequency),
    power=supply_power,
    taken=trace_taken,
    most=most_torque,
)
