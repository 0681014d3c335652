"""The servo loop of an arm about a rest, linear and tick by tick, from the code of plant and law."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from ropsim.codegen import Engine, load
from ropsim.controller import (
    CompiledLaw,
    LawInput,
    LawTraits,
    PythonLaw,
    compiled_half,
    in_python,
    joint_law,
    law_arrays,
    law_model,
)
from ropsim.dynamics import arm_numbers, barycentric, passive_ratios, structure_of
from ropsim.model import ControllerModel, Friction, Payload, RobotModel
from ropsim.simulation.servo.held_state import SMALL, held_state, remember_chains, without_dead_zones
from ropsim.simulation.servo.plant_code import efforts, plant_code
from ropsim.simulation.servo.plant_steps import plant_steps_of
from ropsim.simulation.servo.sensing import sensing_of
from ropsim.simulation.servo.state import StateLayout
from ropsim.spatial import Array, frozen, record

_LONGEST_REST = 5000
"""Ticks in which what a law remembers comes to rest."""
_REST = 1e-12
"""Change in a tick, over a number, of what has come to rest."""


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

    def given(self) -> Array:
        """Return C of u = C·z, the present inputs of the drives, shape (n, z)."""
        s, m, n = len(self.F), len(self.L), self.n
        C = np.zeros((n, s + m + self.delay * n))
        if self.delay:
            C[:, s + m : s + m + n] = np.eye(n)
        else:
            C[:, : s + m] = self.K[:, : s + m]
        return C

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
    robot: RobotModel,
    controller: ControllerModel,
    q: Array,
    payload: Payload,
    law: CompiledLaw | PythonLaw | None = None,
) -> LinearLoop:
    """Return plant and law about a rest, without dry friction, which would damp the loop.

    Near standstill dry friction is a steep smooth curve in simulations: a loop that only this damps is not
    damped in motion. Amplifiers are away from their limits, gears on their flanks, valves beyond their
    overlap. Sensors of the controller are late by their delay and by half of their period; their steps and
    their noise have no part in it.

    Args:
        robot: with drives.
        controller: of the arm.
        q: coordinates of the rest [rad | m], shape (n,).
        payload: tool and part; the law knows it.
        law: another law than that of the controller model.
    """
    arm = without_dead_zones(_without_dry_friction(robot))
    x, u = held_state(arm, q, payload)
    chosen, rates = law or joint_law(controller, robot), controller.rates
    F, G = _plant(arm, payload, (x, u), rates.control_period, plant_steps_of(robot, rates))
    seen = _Seen.of(robot, controller, chosen, (x, u))
    F, G, x = seen.with_delays(F, G, x[: seen.layout.driven])
    K, L = _law(seen, x, payload)
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


@dataclass(frozen=True, slots=True)
class _Seen:
    """What a law is given of the state of an arm, and of values on their way from sensors.

    Attributes:
        robot: the arm.
        law: its law.
        layout: of its state.
        rest: the integrated state, and outputs of the amplifiers, at rest.
        late: for each row of a frame (see `Servo`) the control ticks by which it is late.
    """

    robot: RobotModel
    law: CompiledLaw | PythonLaw
    layout: StateLayout
    rest: tuple[Array, Array]
    late: tuple[int, ...]

    @classmethod
    def of(
        cls,
        robot: RobotModel,
        controller: ControllerModel,
        law: CompiledLaw | PythonLaw,
        rest: tuple[Array, Array],
    ) -> "_Seen":
        layout, late = (
            StateLayout.of(structure_of(robot), law.traits),
            [0] * (4 + len(law.traits.sensed)),
        )
        for channel in sensing_of(controller, compiled_half(law, np.zeros(robot.n))).channels:
            late[channel.row] = channel.delay + channel.period // 2
        return cls(robot, law, layout, rest, tuple(late))

    def frame(self, x: Array) -> Array:
        """Return true values by rows, shape (r, n)."""
        found = np.zeros((len(self.late), self.robot.n))
        found[0] = x[list(self.layout.measured_coordinates)]
        found[1] = x[list(self.layout.measured_speeds)]
        at_rest, u = self.rest
        efforts(self.robot, np.concatenate((x, at_rest[len(x) :])), u, found[2])
        for row, places in enumerate(self.layout.sensed(self.law.traits.sensed), start=4):
            found[row] = [0.0 if one is None else x[one] for one in places]
        return found

    def with_delays(self, F: Array, G: Array, x: Array) -> tuple[Array, Array, Array]:
        """Return the plant with values on their way from late sensors, and its state at rest."""
        n, s, late = self.robot.n, len(x), sum(self.late)
        if not late:
            return F, G, x
        whole, C = np.zeros((s + late * n, s + late * n)), _differences(lambda y: self.frame(y).ravel(), x)
        whole[:s, :s], first = F, s
        rest, still = [x], self.frame(x)
        for row, ticks in enumerate(self.late):
            for k in range(ticks):
                here = slice(first, first + n)
                if k == 0:
                    whole[here, :s] = C[row * n : (row + 1) * n]
                else:
                    whole[here, first - n : first] = np.eye(n)
                rest.append(still[row])
                first += n
        return whole, np.vstack((G, np.zeros((late * n, n)))), np.concatenate(rest)

    def given(self, x: Array, s: int) -> Array:
        """Return measured values by rows; `x` has s numbers of the plant, and values on their way."""
        found, first, n = self.frame(x[:s]), s, self.robot.n
        for row, ticks in enumerate(self.late):
            first += ticks * n
            if ticks:
                found[row] = x[first - n : first]
        return found


def _law(seen: _Seen, x: Array, payload: Payload) -> tuple[Array, Array]:
    """Return how outputs and next states of a law follow from state, law and reference: two matrices."""
    law, robot, layout = seen.law, seen.robot, seen.layout
    function = _called(law, robot, payload)
    arrays = law_arrays(compiled_half(law, np.zeros(robot.n)), robot.n)
    rests = not isinstance(law, CompiledLaw) or law.model is not None
    n, s, size = robot.n, layout.driven, len(x)
    arrays["load"] = np.array(barycentric(payload.mass, payload.com, payload.inertia))

    def answer(found: Array, memory: Array, q_ref: Array) -> Array:
        out, state = np.zeros(n), memory.reshape(-1, n).copy()
        ref = np.array([q_ref, np.zeros(n), np.zeros(n)])
        given = {"sensed": found[4:].copy(), "state": state, "ref": ref, "meas": found[:3].copy()}
        function({**arrays, **given, "out": out})
        return np.concatenate((out, state.ravel()))

    def answers(values: Array) -> Array:
        return answer(seen.given(values[:size], s), values[size:-n], values[-n:])

    memory = np.zeros((layout.law_rows, n))
    if rests and law.traits.hold_row is not None:
        memory[law.traits.hold_row] = seen.rest[1] * np.array([drive.sense for drive in robot.drives])
    if robot.cuts:
        remember_chains(law.traits, memory, seen.rest[0][list(layout.loops.passive)])
    kept, found = memory.ravel(), seen.given(x, s)
    for _ in range(_LONGEST_REST if rests else 0):
        before, kept = kept, answer(found, kept, x[:n])[n:]
        if (np.abs(kept - before) <= _REST * np.maximum(np.abs(kept), SMALL)).all():
            break
    J = _differences(answers, np.concatenate((x, kept, x[:n])))
    return J[:n], J[n:]


def _called(
    law: CompiledLaw | PythonLaw, robot: RobotModel, payload: Payload
) -> Callable[[Mapping[str, Array]], None]:
    """Return a law as a function of its arrays by name, `out` among them."""
    if isinstance(law, CompiledLaw):
        return in_python(law)
    model = law_model(robot)

    def call(arrays: Mapping[str, Array]) -> None:
        now = LawInput(0.0, arrays["ref"], arrays["meas"], payload, arrays["aux"], arrays["sensed"], model)
        arrays["out"][:] = law.step(now, arrays["state"])

    return call


def _differences(function: Callable[[Array], Array], values: Array) -> Array:
    """Return the Jacobian of a function by central differences."""
    sizes = SMALL * np.maximum(1.0, np.abs(values))
    columns = [
        (function(values + h) - function(values - h)) / (2.0 * size)
        for h, size in zip(np.diag(sizes), sizes.tolist(), strict=True)
    ]
    return np.array(columns).T
