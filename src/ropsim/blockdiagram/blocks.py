"""The blocks of a diagram: records without behaviour.

Lists of numbers contain one number for all elements of the output, or one for each. T is the period of the
controller, k the control tick, u an input, y the output.
"""

from enum import StrEnum

from ropsim.core import frozen_dataclass

Numbers = tuple[float, ...]
Matrix = tuple[Numbers, ...]


@frozen_dataclass
class Block:
    """A block.

    Attributes:
        name: unique in its diagram.
        inputs: names of signals.
        output: name of the signal that it sets.
    """

    name: str
    inputs: tuple[str, ...]
    output: str


@frozen_dataclass
class Gain(Block):
    """Multiplies each element: y = factor·u."""

    factors: Numbers


@frozen_dataclass
class MatrixGain(Block):
    """Multiplies the vector of all inputs, one behind the other, by a matrix: y = K·u."""

    matrix: Matrix


@frozen_dataclass
class Sum(Block):
    """Adds inputs of equal size, each with a sign: 1 or -1."""

    signs: tuple[int, ...]


@frozen_dataclass
class Product(Block):
    """Multiplies inputs of equal size, element by element."""


@frozen_dataclass
class Constant(Block):
    """Numbers that do not change; it has no input."""

    values: Numbers


@frozen_dataclass
class StateSpace(Block):
    """A linear system in discrete time: x(k+1) = A·x + B·u, y = C·x + D·u.

    Attributes:
        a: matrix A, square.
        b: matrix B; u is the vector of all inputs, one behind the other.
        c: matrix C.
        d: matrix D.
        x0: state at the start; empty for the steady state of the first input, 0 where there is none.
        sample_time: T [s].
    """

    a: Matrix
    b: Matrix
    c: Matrix
    d: Matrix
    x0: Numbers
    sample_time: float


class Method(StrEnum):
    """How a transfer function becomes one in z: it is one, by Tustin's rule, or with its input held."""

    DISCRETE = "discrete"
    TUSTIN = "tustin"
    ZERO_ORDER_HOLD = "zero_order_hold"


@frozen_dataclass
class TransferFunction(Block):
    """The same transfer function for each element, proper; it starts in the steady state of its first input.

    Attributes:
        numerator: coefficients, the highest power first.
        denominator: coefficients, the highest power first.
        method: the polynomials are in s, or in z with `discrete`.
        sample_time: T [s].
    """

    numerator: Numbers
    denominator: Numbers
    method: Method
    sample_time: float


@frozen_dataclass
class Integrator(Block):
    """Adds up: y(k+1) = y(k) + T·factor·u(k).

    Attributes:
        factors: of the input.
        initial: output at the start.
        sample_time: T [s].
    """

    factors: Numbers
    initial: Numbers
    sample_time: float


class AntiWindup(StrEnum):
    """Behaviour of the integral of a PID block while the output is at its limit.

    It goes on, stands still while the error would drive the output further, or is drawn back.
    """

    NONE = "none"
    CLAMPING = "clamping"
    BACK_CALCULATION = "back_calculation"


@frozen_dataclass
class Pid(Block):
    """A PID controller with two inputs, reference r and measurement y, and a third that adds to its output.

    v = kp·(b·r - y) + I + D + f, limited to [lower, upper]; I(k+1) = I + T·ki·(r - y), and with
    `back_calculation` + (T/t)·(limited - v); D is kd·(c·r - y) differentiated and filtered by a lag. f is the
    third input, 0 without it. K. J. Åström, B. Wittenmark: Computer-Controlled Systems, 3rd ed., section 8.5.

    Attributes:
        kp: proportional gains.
        ki: integral gains [1/s of kp].
        kd: derivative gains [s of kp].
        derivative_filter: time constants of the lag [s], 0 for none.
        setpoint_weight: b.
        derivative_weight: c.
        lower: least outputs; empty without.
        upper: greatest outputs; empty without.
        anti_windup: of the integral.
        tracking_time: t of `back_calculation` [s]; empty with the others.
        sample_time: T [s].
    """

    kp: Numbers
    ki: Numbers
    kd: Numbers
    derivative_filter: Numbers
    setpoint_weight: Numbers
    derivative_weight: Numbers
    lower: Numbers
    upper: Numbers
    anti_windup: AntiWindup
    tracking_time: Numbers
    sample_time: float


@frozen_dataclass
class Saturation(Block):
    """Limits each element."""

    lower: Numbers
    upper: Numbers


@frozen_dataclass
class RateLimiter(Block):
    """Limits how fast each element falls and rises [1/s]; `falling` is negative."""

    falling: Numbers
    rising: Numbers
    sample_time: float


@frozen_dataclass
class DeadBand(Block):
    """Is 0 between two bounds, and the distance to the nearer bound outside of them."""

    lower: Numbers
    upper: Numbers


@frozen_dataclass
class Delay(Block):
    """Repeats its input some control ticks later."""

    ticks: int


@frozen_dataclass
class Lookup(Block):
    """A function of one number by points, linear between them and constant outside.

    Attributes:
        points: arguments, rising.
        values: at these.
    """

    points: Numbers
    values: Numbers


@frozen_dataclass
class Notch(Block):
    """Takes out a frequency: (s² + 2·depth·damping·ω·s + ω²)/(s² + 2·damping·ω·s + ω²), by Tustin's rule.

    Attributes:
        frequency: ω [rad/s], kept by prewarping.
        damping: of the poles, wide for a large one.
        depth: gain at the frequency, 0 to 1.
        sample_time: T [s].
    """

    frequency: float
    damping: float
    depth: float
    sample_time: float


@frozen_dataclass
class MovingFilter(Block):
    """The mean of the present input and the inputs of the control ticks before, `ticks` in all."""

    ticks: int


@frozen_dataclass
class Switch(Block):
    """Passes its second input where the first is at least a threshold, and else its third."""

    threshold: float


class ModelKind(StrEnum):
    """Which torques of the model: those against gravity, or of a whole motion."""

    GRAVITY = "gravity"
    COMPUTED_TORQUE = "computed_torque"


@frozen_dataclass
class ModelFeedForward(Block):
    """Efforts of the drives that the model of the arm needs, with tool and part.

    Inputs are the coordinates; with `computed_torque` coordinates, speeds, accelerations, and if there is a
    fourth the speeds at which friction is taken. Friction and rotors of the motors count.
    """

    kind: ModelKind


@frozen_dataclass
class DriveCommand(Block):
    """The inputs of the amplifiers for efforts and speeds of the axes, by the model of the drives."""
