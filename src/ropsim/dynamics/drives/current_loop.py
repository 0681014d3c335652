"""A motor in a current loop: its current and the integral of the loop are states.

L. Harnefors, H.-P. Nee: Model-based current control of AC machines using the internal model control method,
IEEE Trans. Industry Applications 34 (1998), 133-141.
"""

from ropsim.codegen import Scalar, maximum, minimum
from ropsim.dynamics.drives.block import Column, MotorBlock, Movement, Numbers, Steady, Torque
from ropsim.dynamics.drives.dc_motor import electric_power
from ropsim.model import CurrentLoopMotor, InputKind


def _trace(p: Numbers, states: Numbers, effort: Scalar, shaft: Movement) -> Torque:
    """Return Kt·i, and the rates of i and of the integral v.

    What the voltage lacks is taken off the error that v integrates, so that v does not wind up.
    """
    constant, back_emf, resistance, inductance, _, voltage, most, bandwidth = p
    current, integral = states
    wanted = minimum(maximum(effort / constant, -most), most)
    error, gain = wanted - current, bandwidth * inductance
    induced = back_emf * shaft.speed
    asked = gain * error + integral + induced
    given = minimum(maximum(asked, -voltage), voltage)
    rate = (given - resistance * current - induced) / inductance
    return Torque(constant * current, (rate, (bandwidth * resistance) * (error + (given - asked) / gain)))


def _steady(motor: CurrentLoopMotor, torque: float, speed: float) -> Steady:
    """Return τ/Kt, and R·τ/Kt of the integral; the back-EMF is fed forward."""
    del speed
    current = torque / motor.torque_constant
    return Steady((current, motor.resistance * current), torque)


def _most(motor: CurrentLoopMotor) -> float:
    return float(motor.torque_constant * min(motor.max_current, motor.max_voltage / motor.resistance))


CURRENT_LOOP = MotorBlock(
    takes=InputKind.EFFORT,
    numbers=(
        "torque_constant",
        "back_emf_constant",
        "resistance",
        "inductance",
        "rotor_inertia",
        "max_voltage",
        "max_current",
        "bandwidth",
    ),
    positive=("torque_constant", "resistance", "inductance", "max_voltage", "max_current", "bandwidth"),
    states=(
        Column("current", "A", "motor current"),
        Column("loop_voltage", "V", "voltage that the integral of the current loop puts out"),
    ),
    trace=_trace,
    inertia=lambda p: p[4],
    steady=_steady,
    pole=lambda motor: float(motor.bandwidth),
    power=electric_power,
    most=_most,
)
