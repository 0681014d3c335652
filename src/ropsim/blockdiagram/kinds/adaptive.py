"""Model-reference adaptive control of axes whose mass, friction and load are not known."""

import numpy as np

from ropsim.blockdiagram import blocks as b
from ropsim.blockdiagram.diagram import Diagram, Link
from ropsim.blockdiagram.kinds.drawing import Axes, Drawing, Given, rows_of
from ropsim.blockdiagram.signals import Role, Signal, Unit
from ropsim.core import frozen_dataclass

Numbers = float | tuple[float, ...]


@frozen_dataclass
class Adaptation:
    """Numbers of an adaptive controller, one for all axes or one for each.

    Attributes:
        frequency: ω of the reference model q̈_m = ω²·(q_ref - q_m) + 2·ω·(qd_ref - q̇_m) + qdd_ref [rad/s].
        bandwidth: λ of the error that is brought to 0, s = ė + λ·e [1/s].
        feedback: gain of s [N·m·s/rad | N·s/m].
        mass: estimate at the start [kg·m² | kg].
        friction: estimate of the viscous friction at the start [N·m·s/rad | N·s/m].
        load: estimate of a constant load at the start [N·m | N].
        mass_rate: gain of the adaptation of the mass.
        friction_rate: of the friction.
        load_rate: of the load.
    """

    frequency: Numbers
    bandwidth: Numbers
    feedback: Numbers
    mass: Numbers
    friction: Numbers = 0.0
    load: Numbers = 0.0
    mass_rate: Numbers = 1.0
    friction_rate: Numbers = 1.0
    load_rate: Numbers = 1.0


def model_reference_adaptive(axes: Axes, numbers: Adaptation) -> Diagram:
    """Return the controller that follows a reference model and estimates mass, friction and load of axes.

    With e = q - q_m, s = ė + λ·e and v = q̈_m - λ·ė: τ = m̂·v + b̂·q̇ + ĉ - k·s, and m̂' = -γ_m·v·s,
    b̂' = -γ_b·q̇·s, ĉ' = -γ_c·s. The Lyapunov function m·s²/2 + Σ(error of an estimate)²/(2γ) falls by k·s²,
    so that s goes to 0, and with a rich reference the estimates to mass, friction and load of the axis (J.-J.
    E. Slotine, W. Li: Applied Nonlinear Control, Prentice Hall 1991, section 8.1, axis by axis: couplings of
    the axes count as disturbances). Estimates are integrated by the rule of Euler.
    """
    to = Drawing("model_reference_adaptive", axes)
    speeds, accelerations, free = (
        axes.units(Role.SPEED),
        axes.units(Role.REFERENCE_ACCELERATION),
        (Unit.OTHER,),
    )
    q_m, qd_m, qdd_m = _reference_model(to, to.each("frequency", numbers.frequency))
    e = to.sum("e", (to.signal(Role.COORDINATE), q_m), (1, -1), axes.units(Role.COORDINATE))
    ed = to.sum("ed", (to.signal(Role.SPEED), qd_m), (1, -1), speeds)
    s = to.sum("s", (ed, to.gain("bandwidth", numbers.bandwidth, e, speeds)), (1, 1), speeds)
    v = to.sum("v", (qdd_m, to.gain("lead", numbers.bandwidth, ed, accelerations)), (1, -1), accelerations)
    parts = [to.gain("feedback", numbers.feedback, s, axes.efforts)]
    terms = (
        ("mass", v, numbers.mass_rate, numbers.mass),
        ("friction", to.signal(Role.SPEED), numbers.friction_rate, numbers.friction),
    )
    for name, regressor, rate, first in terms:
        slope = to.add(b.Product(f"{name}_slope", (regressor, s), to.inner(f"{name}_slope_out", free)))
        parts.append(_adapted(to, name, (slope, rate, first), regressor))
    falling = tuple(-one for one in to.each("load_rate", numbers.load_rate))
    load = to.inner("load_estimate", axes.efforts)
    to.add(b.Integrator("load", (s,), load, falling, to.each("load", numbers.load), axes.period))
    parts.append(load)
    to.put_out(to.sum("effort", parts, (-1, 1, 1, 1), axes.efforts))
    return to.done()


def _reference_model(to: Drawing, frequency: tuple[float, ...]) -> tuple[str, str, str]:
    """Add the reference model of all axes, which starts at the reference; its accelerations come at once."""
    n, period, one = to.axes.n, to.axes.period, np.eye(to.axes.n)
    stiff, damp = np.diag(np.square(frequency)), np.diag(2.0 * np.array(frequency))
    c = np.hstack((-stiff, -damp))
    d = np.hstack((stiff, damp, one))
    a = np.vstack((np.hstack((one, period * one)), np.hstack((np.zeros((n, n)), one)) + period * c))
    b_ = np.vstack((np.zeros((n, 3 * n)), period * d))
    c, d = np.vstack((np.eye(2 * n), c)), np.vstack((np.zeros((2 * n, 3 * n)), d))
    inputs = (Role.REFERENCE_COORDINATE, Role.REFERENCE_SPEED, Role.REFERENCE_ACCELERATION)
    whole = to.signal_of(Signal("model_out", 3 * n, (Unit.OTHER,)))
    A, B, C, D = map(rows_of, (a, b_, c, d))
    to.add(b.StateSpace("model", tuple(map(to.signal, inputs)), whole, A, B, C, D, (), period))
    roles = (Role.COORDINATE, Role.SPEED, Role.REFERENCE_ACCELERATION)
    names = ("q_model", "qd_model", "qdd_model")
    for number, (name, role) in enumerate(zip(names, roles, strict=True)):
        to.link(Link(whole, number * n, to.inner(name, to.axes.units(role)), 0, n))
    return names


def _adapted(to: Drawing, name: str, adapted: tuple[str, Given, Given], regressor: str) -> str:
    """Add an estimate, and its product with its regressor."""
    slope, rate, first = adapted
    estimate = to.inner(f"{name}_estimate", (Unit.OTHER,))
    falling = tuple(-one for one in to.each(f"{name}_rate", rate))
    to.add(b.Integrator(name, (slope,), estimate, falling, to.each(name, first), to.axes.period))
    output = to.inner(f"{name}_effort", to.axes.efforts)
    return to.add(b.Product(f"{name}_product", (estimate, regressor), output))
