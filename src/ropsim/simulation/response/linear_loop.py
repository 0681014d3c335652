"""The servo loop of an arm about a rest, linear and tick by tick, from the code of plant and law."""

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from ropsim.codegen import Engine, load
from ropsim.controller import CompiledLaw, LawTraits, law_of
from ropsim.dynamics import arm_numbers, barycentric, passive_ratios, structure_of
from ropsim.model import ControllerModel, Friction, Payload, RobotModel
from ropsim.simulation.servo.held_state import SMALL, held_state, without_dead_zones
from ropsim.simulation.servo.plant_code import plant_code
from ropsim.simulation.servo.plant_steps import plant_steps_of
from ropsim.simulation.servo.state import StateLayout
from ropsim.spatial import Array, frozen, record

_NO_SIGNALS = np.zeros(0)


@record
class LinearLoop:
    """Plant and law about a rest: x⁺ = F·x + G·u, u = K·(x, m, q_ref), m⁺ = L·(x, m, q_ref), m of the law.

    Attributes:
        F: how the state of the plant follows from that a tick before, shape (s, s).
        G: and from the output of the law, shape (s, n).
        K: how that follows from state of the plant, state of the law, and reference, shape (n, s + m + n).
        L: how the state of the law follows from these, shape (m, s + m + n).
        period: control period [s].
        delay: control ticks between an output of the law and the moment when it acts.
    """

    F: Array
    G: Array
    K: Array
    L: Array
    period: float
    delay: int

    @property
    def n(self) -> int:
        """Return the number of axes."""
        return int(self.G.shape[1])

    def closed(self, late: int = 0) -> tuple[Array, Array]:
        """Return A and B of z⁺ = A·z + B·q_ref; z holds the plant, the law, and outputs on their way.

        Args:
            late: control ticks by which outputs act later than they do.

        Returns:
            Shapes (z, z) and (z, n); the coordinates of the joints are the first n numbers of z.
        """
        return self._joined(np.ones(self.n), self.delay + late)

    def broken(self, axis: int) -> tuple[Array, Array, Array]:
        """Return A, b, c of the loop that is open between the law and the drive of one axis: z⁺ = A·z + b·v.

        v goes into that drive at once, c·z is what the law puts out for it; all other axes are controlled.

        Args:
            axis: its number, from 0.
        """
        through = np.ones(self.n)
        through[axis] = 0.0
        A, _ = self._joined(through, self.delay)
        s, m = len(self.F), len(self.L)
        b, c = np.zeros(len(A)), np.zeros(len(A))
        b[:s], c[: s + m] = self.G[:, axis], self.K[axis, : s + m]
        return A, b, c

    def _joined(self, through: Array, late: int) -> tuple[Array, Array]:
        """Return the loop with outputs of the law that pass by shares, some ticks late."""
        s, m, n = len(self.F), len(self.L), self.n
        first, size = s + m, s + m + late * n
        A, B = np.zeros((size, size)), np.zeros((size, n))
        A[:s, :s], A[s:first, :first], B[s:first] = self.F, self.L[:, :first], self.L[:, first:]
        gain, now, reference = self.G * through, self.K[:, :first], self.K[:, first:]
        if late:
            A[:s, first : first + n] = gain
            A[first:-n, first + n :] = np.eye((late - 1) * n)
            A[-n:, :first], B[-n:] = now, reference
        else:
            A[:s, :first] += gain @ now
            B[:s] = gain @ reference
        return A, B


def linear_loop(
    robot: RobotModel, controller: ControllerModel, q: Array, payload: Payload, law: CompiledLaw | None = None
) -> LinearLoop:
    """Return plant and law about a rest, without dry friction, which would damp the loop.

    Near standstill dry friction is a steep smooth curve in simulations: a loop that only this damps is not
    damped in motion. Amplifiers are away from their limits, gears on their flanks, valves beyond their
    overlap.

    Args:
        robot: with drives.
        controller: of the arm.
        q: coordinates of the rest [rad | m], shape (n,).
        payload: tool and part; the law knows it.
        law: another law than that of the controller model.
    """
    arm = without_dead_zones(_without_dry_friction(robot))
    x, u = held_state(arm, q, payload)
    chosen, rates = law or law_of(controller, robot), controller.rates
    F, G = _plant(arm, payload, (x, u), rates.control_period, plant_steps_of(robot, rates))
    K, L = _law(chosen, robot, x, payload)
    return LinearLoop(frozen(F), frozen(G), frozen(K), frozen(L), rates.control_period, chosen.traits.delay)


def _without_dry_friction(robot: RobotModel) -> RobotModel:
    drives = (
        replace(one, friction=Friction(one.friction.viscous, smoothing_speed=one.friction.smoothing_speed))
        for one in robot.drives
    )
    return replace(robot, drives=tuple(drives))


def _plant(
    robot: RobotModel, payload: Payload, rest: tuple[Array, Array], period: float, steps: int
) -> tuple[Array, Array]:
    """Return how the state after a tick follows from that before it and from the command of the law.

    Coordinates of closed chains move as the axes let them. Steps of the classical Runge-Kutta method
    multiply by the first five terms of the exponential series.
    """
    structure = structure_of(robot)
    code, layout = plant_code(structure), StateLayout.of(structure, LawTraits())
    constants = code.constants(arm_numbers(robot, payload))
    derivative, s, n = load("derivative", code.functions, Engine.PYTHON), layout.driven, len(rest[1])
    K = passive_ratios(robot, rest[0][np.newaxis, :n])[0] if robot.cuts else None

    def rates(values: Array) -> Array:
        x, dx = np.concatenate((values[:s], rest[0][s:])), np.empty(len(rest[0]))
        if K is not None:
            x[list(layout.loops.passive)] += K @ (values[:n] - rest[0][:n])
            x[list(layout.loops.passive_speeds)] = K @ values[n : 2 * n]
        derivative(x, values[s:].copy(), constants, dx)
        return dx[:s]

    whole = np.zeros((s + n, s + n))
    whole[:s] = _differences(rates, np.concatenate((rest[0][:s], rest[1])))
    step = term = np.eye(s + n)
    for order in range(1, 5):
        term = term @ whole * (period / steps / order)
        step = step + term
    after = np.linalg.matrix_power(step, steps)
    return after[:s, :s], after[:s, s:] * np.array([drive.sense for drive in robot.drives])


def _law(law: CompiledLaw, robot: RobotModel, x: Array, payload: Payload) -> tuple[Array, Array]:
    """Return how outputs and next states of a law follow from state, law and reference: two matrices."""
    scope: dict[str, Any] = {"math": math, "np": np}
    for one in law.functions:
        exec(one.text, scope)
    exec(law.source, scope)
    layout = StateLayout.of(structure_of(robot), law.traits)
    n, s, speeds = robot.n, layout.driven, list(layout.measured_speeds)
    numbers = np.array(barycentric(payload.mass, payload.com, payload.inertia))
    signals = np.zeros(len(law.traits.aux)) if law.traits.aux else _NO_SIGNALS

    def answers(values: Array) -> Array:
        ref, meas, out = np.zeros((3, n)), np.zeros((3, n)), np.zeros(n)
        ref[0], meas[0], meas[1] = values[-n:], values[:n], values[speeds]
        state = values[s:-n].reshape(-1, n).copy()
        scope["law"](law.parameters, state, ref, meas, numbers, signals, out)
        return np.concatenate((out, state.ravel()))

    rest = np.concatenate((x[:s], np.zeros(layout.law_rows * n), x[:n]))
    J = _differences(answers, rest)
    return J[:n], J[n:]


def _differences(function: Callable[[Array], Array], values: Array) -> Array:
    """Return the Jacobian of a function by central differences."""
    sizes = SMALL * np.maximum(1.0, np.abs(values))
    columns = [
        (function(values + h) - function(values - h)) / (2.0 * size)
        for h, size in zip(np.diag(sizes), sizes.tolist(), strict=True)
    ]
    return np.array(columns).T
