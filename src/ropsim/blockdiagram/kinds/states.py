"""Controllers by matrices: state feedback, and multivariable controllers in discrete time."""

import numpy as np
import numpy.typing as npt

from ropsim.blockdiagram import blocks as b
from ropsim.blockdiagram.diagram import Diagram, OutputKind
from ropsim.blockdiagram.kinds.drawing import Axes, Drawing, Given, rows_of
from ropsim.blockdiagram.signals import Role, Signal


def state_feedback(axes: Axes, position: Given, speed: Given, integral: Given = 0.0) -> Diagram:
    """Return u = K_q·(q_ref - q) + K_v·(qd_ref - qd) + K_i·∫(q_ref - q) dt with matrices of gains.

    Matrices make each output depend on all axes; a number, or one for each axis, is a diagonal one. Where the
    poles are placed, and how, is chosen outside: by Ackermann's formula, or as a linear-quadratic regulator.

    Args:
        axes: that it is for.
        position: K_q.
        speed: K_v.
        integral: K_i; 0 for none.
    """
    to = Drawing("state_feedback", axes)
    units = axes.efforts if axes.output_kind is OutputKind.EFFORT else axes.units(Role.OUTPUT)
    output = to.signal_of(Signal("u", axes.n, units, Role.OUTPUT))
    error = to.difference("error", Role.REFERENCE_COORDINATE, Role.COORDINATE)
    late = to.difference("speed_error", Role.REFERENCE_SPEED, Role.SPEED)
    parts, columns = [error, late], [_square(to, "position", position), _square(to, "speed", speed)]
    K_i = _square(to, "integral", integral)
    if K_i.any():
        units = axes.units(Role.COORDINATE)
        kept = to.inner("integral_out", units)
        parts.append(to.add(b.Integrator("integral", (error,), kept, (1.0,), (0.0,), axes.period)))
        columns.append(K_i)
    to.add(b.MatrixGain("gains", tuple(parts), output, rows_of(np.hstack(columns))))
    return to.done(holding="integral" if K_i.any() and _is_diagonal(K_i) else "")


def _square(to: Drawing, name: str, values: Given) -> "npt.NDArray[np.float64]":
    if np.ndim(values) < 2:
        return np.diag(to.each(name, values))
    return np.array(to.matrix(name, values))


def _is_diagonal(matrix: "npt.NDArray[np.float64]") -> bool:
    return bool((matrix == np.diag(np.diagonal(matrix))).all())


def multivariable(
    axes: Axes, a: npt.ArrayLike, b_: npt.ArrayLike, c: npt.ArrayLike, d: npt.ArrayLike
) -> Diagram:
    """Return the linear controller x(k+1) = A·x + B·y, u = C·x + D·y in discrete time.

    y holds q_ref - q and then qd_ref - qd of all axes: B and D have 2n columns, C and D n rows. Any
    linear regulator of these errors has this form, such as one with an observer.

    Args:
        axes: that it is for.
        a: A, shape (m, m).
        b_: B, shape (m, 2n).
        c: C, shape (n, m).
        d: D, shape (n, 2n).
    """
    to = Drawing("multivariable", axes)
    units = axes.efforts if axes.output_kind is OutputKind.EFFORT else axes.units(Role.OUTPUT)
    output = to.signal_of(Signal("u", axes.n, units, Role.OUTPUT))
    error = to.difference("error", Role.REFERENCE_COORDINATE, Role.COORDINATE)
    late = to.difference("speed_error", Role.REFERENCE_SPEED, Role.SPEED)
    A, B, C, D = map(rows_of, (a, b_, c, d))
    zeros = (0.0,) * len(A)
    to.add(b.StateSpace("regulator", (error, late), output, A, B, C, D, zeros, axes.period))
    return to.done()
