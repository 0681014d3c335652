"""Controllers of single axes side by side: P, PI, PID, and the cascade of P and PI.

K. J. Åström, T. Hägglund: Advanced PID Control, ISA 2006; W. Leonhard: Control of Electrical Drives, 3rd ed.,
Springer 2001, for the cascade.
"""

import numpy as np

from ropsim.blockdiagram import blocks as b
from ropsim.blockdiagram.diagram import Diagram, Link, OutputKind
from ropsim.blockdiagram.kinds.drawing import Axes, Drawing, Given
from ropsim.blockdiagram.signals import Role, Signal
from ropsim.core import frozen_dataclass
from ropsim.spatial import Array


@frozen_dataclass
class Limits:
    """How a PID block is limited.

    Attributes:
        largest: greatest magnitude of the output, that of the amplifiers; None for none.
        anti_windup: of the integral; without limits there is none.
        tracking_time: of `back_calculation` [s].
    """

    largest: float | tuple[float, ...] | None = None
    anti_windup: b.AntiWindup = b.AntiWindup.CLAMPING
    tracking_time: float = 0.1


NO_LIMITS = Limits()


def p_controller(axes: Axes, kp: Given) -> Diagram:
    """Return u = kp·(q_ref - q) for each axis; a constant load leaves the error load/kp."""
    to = Drawing("p", axes)
    error = to.difference("error", Role.REFERENCE_COORDINATE, Role.COORDINATE)
    to.add(b.Gain("p", (error,), _output(to), to.each("kp", kp)))
    return to.done()


def pi_controller(axes: Axes, kp: Given, ki: Given, limits: Limits = NO_LIMITS) -> Diagram:
    """Return u = kp·e + ki·∫e dt with e = q_ref - q for each axis: no error is left under a constant load."""
    return _pid("pi", axes, (kp, ki, 0.0), limits)


def pid_controller(
    axes: Axes,
    gains: tuple[Given, Given, Given],
    limits: Limits = NO_LIMITS,
    *,
    filter_time: Given = 0.0,
    setpoint_weight: Given = 1.0,
    derivative_weight: Given = 1.0,
) -> Diagram:
    """Return a PID controller for each axis; see `Pid` for its equation.

    Args:
        axes: that it is for.
        gains: kp, ki, kd.
        limits: of the output.
        filter_time: of the derivative [s].
        setpoint_weight: share of the reference in the proportional part.
        derivative_weight: share of the reference in the derivative.
    """
    return _pid("pid", axes, gains, limits, (filter_time, setpoint_weight, derivative_weight))


def _pid(
    name: str,
    axes: Axes,
    gains: tuple[Given, Given, Given],
    limits: Limits,
    further: tuple[Given, Given, Given] = (0.0, 1.0, 1.0),
) -> Diagram:
    to = Drawing(name, axes)
    inputs = to.signal(Role.REFERENCE_COORDINATE), to.signal(Role.COORDINATE)
    to.add(pid_block(to, name, inputs, _output(to), gains, limits, further))
    return to.done(holding=name if np.any(np.asarray(gains[1], float) != 0.0) else "")


def pid_block(
    to: Drawing,
    name: str,
    inputs: tuple[str, ...],
    output: str,
    gains: tuple[Given, Given, Given],
    limits: Limits = NO_LIMITS,
    further: tuple[Given, Given, Given] = (0.0, 1.0, 1.0),
) -> b.Pid:
    """Return a PID block with a number for each axis."""
    kp, ki, kd = (to.each(one, value) for one, value in zip(("kp", "ki", "kd"), gains, strict=True))
    words = ("filter_time", "setpoint_weight", "derivative_weight")
    lag, weight, slope = (to.each(one, value) for one, value in zip(words, further, strict=True))
    largest = () if limits.largest is None else to.each("largest", limits.largest)
    remedy = limits.anti_windup if largest else b.AntiWindup.NONE
    tracking = (limits.tracking_time,) if remedy is b.AntiWindup.BACK_CALCULATION else ()
    return b.Pid(
        *(name, inputs, output, kp, ki, kd, lag, weight, slope),
        *(tuple(-one for one in largest), largest, remedy, tracking, to.axes.period),
    )


def _output(to: Drawing) -> str:
    if to.axes.output_kind is not OutputKind.EFFORT:
        return to.output()
    return to.signal_of(Signal("u", to.axes.n, to.axes.efforts, Role.OUTPUT))


@frozen_dataclass
class CascadeGains:
    """Gains of a cascade, a number for all axes or one for each.

    Attributes:
        kp: of the position loop [1/s].
        kv: of the speed loop.
        ki: of the integral of the speed loop.
        speed_share: share of the reference speed that is fed forward into the speed loop.
        per_speed: output fed forward for the reference speed.
        per_acceleration: output fed forward for the reference acceleration.
    """

    kp: float | tuple[float, ...]
    kv: float | tuple[float, ...]
    ki: float | tuple[float, ...]
    speed_share: float | tuple[float, ...] = 1.0
    per_speed: float | tuple[float, ...] = 0.0
    per_acceleration: float | tuple[float, ...] = 0.0


def cascade(axes: Axes, gains: CascadeGains, limits: Limits = NO_LIMITS) -> Diagram:
    """Return a position loop P over a speed loop PI for each axis, with feed-forward.

    Coordinates are those of the joints; the speeds are measured at the motors, over the ratios of the gears.
    """
    to = Drawing("p_pi", axes)
    error = to.difference("error", Role.REFERENCE_COORDINATE, Role.COORDINATE)
    return _cascade(to, error, gains, limits, np.ones(axes.n))


def motor_cascade(
    axes: Axes,
    gains: CascadeGains,
    ratios: Given,
    elastic: tuple[bool, ...],
    limits: Limits = NO_LIMITS,
) -> Diagram:
    """Return the cascade on the side of the motors: their angles and speeds are controlled, not the joints.

    Behind an elastic gear the joint swings on its own, and this loop does not measure that.

    Args:
        axes: that it is for.
        gains: on the side of the motor: errors and references are multiplied by the ratios of the gears.
        ratios: of the gears; their signs do not count, since a positive output drives a joint forward.
        elastic: axes whose motor coordinate is sensed; behind a rigid gear it follows from the joint.
        limits: of the output.
    """
    to, G = Drawing("motor_p_pi", axes), np.abs(np.asarray(ratios, np.float64)) * np.ones(axes.n)
    units = axes.units(Role.COORDINATE)
    motor = to.inner("motor", units)
    sides = {True: to.signal(Role.DRIVE_STATE, "motor_coordinate", units), False: to.signal(Role.COORDINATE)}
    for axis, is_elastic in enumerate(elastic):
        to.link(Link(sides[is_elastic], axis, motor, axis, 1))
    error = to.sum("error", (to.signal(Role.REFERENCE_COORDINATE), motor), (1, -1), units)
    return _cascade(to, error, gains, limits, G)


def _cascade(to: Drawing, error: str, gains: CascadeGains, limits: Limits, ratios: Array) -> Diagram:
    """Return a cascade whose gains of the speed loop are those at the axes over the ratios."""
    kv, ki, ke, ka = (
        np.asarray(one, np.float64) * ratios
        for one in (gains.kv, gains.ki, gains.per_speed, gains.per_acceleration)
    )
    units, output = to.axes.units(Role.SPEED), _output(to)
    asked = to.gain("position", gains.kp, error, units)
    forward = to.gain("speed_forward", gains.speed_share, to.signal(Role.REFERENCE_SPEED), units)
    wanted = to.sum("speed_reference", (asked, forward), (1, 1), units)
    out_units = to.axes.efforts if to.axes.output_kind is OutputKind.EFFORT else to.axes.units(Role.OUTPUT)
    parts = [to.gain("back_emf", ke, to.signal(Role.REFERENCE_SPEED), out_units)]
    parts.append(to.gain("inertia", ka, to.signal(Role.REFERENCE_ACCELERATION), out_units))
    inputs = wanted, to.signal(Role.SPEED), to.sum("feed_forward", parts, (1, 1), out_units)
    to.add(pid_block(to, "speed", inputs, output, (kv, ki, 0.0), limits))
    return to.done(holding="speed" if np.any(ki != 0.0) else "")
