"""A rotary vane motor at a servo valve: its chambers grow and shrink with the angle of its shaft.

M. Jelali, A. Kroll: Hydraulic Servo-systems, Springer 2003, chapter 4.
"""

from ropsim.codegen import Scalar, maximum, minimum
from ropsim.dynamics.drives.block import MotorBlock, Movement, Numbers, Torque
from ropsim.dynamics.drives.hydraulics.motor import most_torque, steady_motor
from ropsim.dynamics.drives.hydraulics.servo_valve import (
    VALVE_NUMBERS,
    VALVE_POSITIVE,
    VALVE_STATES,
    Valve,
    supply_power,
    trace_flows,
    trace_spool,
    trace_taken,
)
from ropsim.model import InputKind


def _trace(p: Numbers, states: Numbers, current: Scalar, shaft: Movement) -> Torque:
    """Return D·(p_a - p_b), and the rates of both pressures and of the spool.

    Beyond the stops the chambers keep the volumes that they have there.
    """
    displacement, swing, first, dead, leakage, _, bulk, *rest = p
    valve = Valve(*rest)
    a, b, opening, rate = states
    into_a, into_b = trace_flows(valve, a, b, opening)
    turned = minimum(maximum(shaft.place - first, swing.tracer.constant(0.0)), swing)
    swept = displacement * shaft.speed + leakage * (a - b)
    rate_a = bulk / (dead + displacement * turned) * (into_a - swept)
    rate_b = bulk / (dead + displacement * (swing - turned)) * (into_b + swept)
    spool = trace_spool(valve, current, opening, rate)
    return Torque(displacement * (a - b), (rate_a, rate_b, rate, spool))


HYDRAULIC_VANE = MotorBlock(
    takes=InputKind.CURRENT,
    numbers=(
        "displacement",
        "swing",
        "first_angle",
        "dead_volume",
        "leakage",
        "rotor_inertia",
        "bulk_modulus",
        *VALVE_NUMBERS,
    ),
    positive=("displacement", "swing", "dead_volume", "bulk_modulus", *VALVE_POSITIVE),
    states=VALVE_STATES,
    trace=_trace,
    inertia=lambda p: p[5],
    steady=steady_motor,
    pole=lambda motor: float(motor.natural_frequency),
    power=supply_power,
    taken=trace_taken,
    most=most_torque,
)
