"""Controllers of single axes side by side: P, PI, PID, and the cascade of P and PI.

K. J. Åström, T. Hägglund: Advanced PID Control, ISA 2006; W. Leonhard: Control of Electrical Drives, 3rd ed.,
Springer 2001, for the cascade.
"""

import numpy as np

from ropsim.blockdiagram import blocks as b
from ropsim.blockdiagram.diagram import Diagram, OutputKind
from ropsim.blockdiagram.kinds.drawing import Axes, Drawing, Given
from ropsim.blockdiagram.signals import Role, Signal, Unit
from ropsim.core import frozen_dataclass
from ropsim.model import JointType


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
    return _cascade(to, error, to.signal(Role.SPEED), gains, limits, np.ones(axes.n))


def motor_cascade(
    axes: Axes,
    gains: CascadeGains,
    ratios: Given,
    limits: Limits = NO_LIMITS,
    coordinate: str = "motor_coordinate",
) -> Diagram:
    """Return the cascade on the side of the motors: their angles and speeds are controlled, not the joints.

    References go over the ratios G of the gears. Behind an elastic gear the joint swings on its own, and
    this loop does not see it.

    Args:
        axes: that it is for; all have a motor coordinate that can be sensed, or `coordinate` is empty and
            the coordinate of the joint over the gear stands for it, which is the same behind a rigid gear.
        gains: on the side of the motor.
        ratios: G of the gears.
        limits: of the output.
        coordinate: name of the state of the drives.
    """
    to, G = Drawing("motor_p_pi", axes), np.asarray(ratios, np.float64) * np.ones(axes.n)
    turning = (Unit.RADIAN,) if all(one is JointType.REVOLUTE for one in axes.measures) else (Unit.OTHER,)
    reference = to.gain("reference", G, to.signal(Role.REFERENCE_COORDINATE), turning)
    if coordinate:
        motor = to.signal(Role.DRIVE_STATE, coordinate, turning)
    else:
        motor = to.gain("motor", G, to.signal(Role.COORDINATE), turning)
    error = to.sum("error", (reference, motor), (1, -1), turning)
    speed = to.gain("motor_speed", G, to.signal(Role.SPEED), (Unit.OTHER,))
    return _cascade(to, error, speed, gains, limits, G)


def _cascade(
    to: Drawing,
    error: str,
    speed: str,
    gains: CascadeGains,
    limits: Limits,
    G: "np.ndarray[tuple[int], np.dtype[np.float64]]",
) -> Diagram:
    share, ke, ka = (
        np.asarray(one, np.float64) * G
        for one in (gains.speed_share, gains.per_speed, gains.per_acceleration)
    )
    units = to.axes.units(Role.SPEED) if bool((G == 1.0).all()) else (Unit.OTHER,)
    output = _output(to)
    asked = to.gain("position", gains.kp, error, units)
    forward = to.gain("speed_forward", share, to.signal(Role.REFERENCE_SPEED), units)
    wanted = to.sum("speed_reference", (asked, forward), (1, 1), units)
    out_units = to.axes.efforts if to.axes.output_kind is OutputKind.EFFORT else to.axes.units(Role.OUTPUT)
    parts = [to.gain("back_emf", ke, to.signal(Role.REFERENCE_SPEED), out_units)]
    parts.append(to.gain("inertia", ka, to.signal(Role.REFERENCE_ACCELERATION), out_units))
    forward_output = to.sum("feed_forward", parts, (1, 1), out_units)
    inputs = wanted, speed, forward_output
    to.add(pid_block(to, "speed", inputs, output, (gains.kv, gains.ki, 0.0), limits))
    return to.done(holding="speed" if np.any(np.asarray(gains.ki, float) != 0.0) else "")
