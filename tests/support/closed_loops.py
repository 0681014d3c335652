"""The servo loop of an arm about a rest, linear and tick by tick: true plant, true law, output held."""

from dataclasses import dataclass, replace

import numpy as np
from scipy.linalg import expm

from ropsim.codegen import Engine, load
from ropsim.controller import CompiledLaw, law_of
from ropsim.dynamics import (
    arm_numbers,
    barycentric,
    command_limit,
    gravity,
    mass_matrix,
    steady_drive,
    structure_of,
)
from ropsim.kinematics import configurations
from ropsim.model import ControllerModel, Payload, RobotModel
from ropsim.simulation.servo.plant_code import plant_code
from ropsim.simulation.servo.state import StateLayout
from ropsim.spatial import Array

_SMALL = 1e-6
"""Step of the central differences, in SI units of each state."""


@dataclass(frozen=True, slots=True, eq=False)
class ClosedLoop:
    """z ← A·z + B·q_ref once per control tick; z is the state of the plant, then that of the law.

    Attributes:
        A: shape (s, s).
        B: shape (s, n).
    """

    A: Array
    B: Array

    @property
    def radius(self) -> float:
        """Return the largest magnitude of an eigenvalue: below 1 the loop is stable."""
        return float(np.abs(np.linalg.eigvals(self.A)).max())

    def step(self, axis: int, ticks: int) -> Array:
        """Return how an axis answers a step of 1 of its reference, shape (ticks,)."""
        z, answers = np.zeros(len(self.A)), np.empty(ticks)
        for k in range(ticks):
            z = self.A @ z + self.B[:, axis]
            answers[k] = z[axis]
        return answers

    def overshoots(self, ticks: int) -> Array:
        """Return by which share each axis goes beyond a step of its reference, shape (n,)."""
        n = self.B.shape[1]
        Z, most = np.zeros(self.B.shape), np.zeros(n)
        for _ in range(ticks):
            Z = self.A @ Z + self.B
            most = np.maximum(most, np.diag(Z[:n]))
        return np.asarray(np.maximum(most - 1.0, 0.0))


def closed_loop(
    robot: RobotModel, controller: ControllerModel, q: Array, payload: Payload, late: int = 0
) -> ClosedLoop:
    """Return the loop about a rest, without dry friction, which would damp it.

    Args:
        robot: with drives.
        controller: of the arm.
        q: coordinates of the rest [rad | m], shape (n,).
        payload: in the hand; the law knows it.
        late: ticks by which the output of the law acts later than it does.
    """
    law = law_of(controller, robot)
    robot = slippery(robot)
    law_ = replace(law, parameters=law_of(controller, robot).parameters)
    x, u = _rest(robot, q, payload)
    F, G = _plant(robot, payload, x, u, controller.rates.control_period)
    Kx, Km, Kr, Px, Pm, Pr = _law(law_, robot, x, payload)
    m = len(Pm)
    A = np.block([[F + G @ Kx, G @ Km], [Px, Pm]])
    B = np.vstack((G @ Kr, Pr))
    if late:
        n, s = robot.n, len(F)
        A0 = np.zeros((s + m + late * n,) * 2)
        A0[:s, :s], A0[s : s + m, :s], A0[s : s + m, s : s + m] = F, Px, Pm
        A0[:s, s + m : s + m + n] = G
        for d in range(late - 1):
            A0[s + m + d * n : s + m + (d + 1) * n, s + m + (d + 1) * n : s + m + (d + 2) * n] = np.eye(n)
        A0[-n:, :s], A0[-n:, s : s + m] = Kx, Km
        B0 = np.zeros((len(A0), n))
        B0[s : s + m], B0[-n:] = Pr, Kr
        A, B = A0, B0
    return ClosedLoop(A, B)


def slippery(robot: RobotModel) -> RobotModel:
    """Return an arm without dry friction."""
    drives = (
        replace(one, friction=replace(one.friction, coulomb_positive=0.0, coulomb_negative=0.0))
        for one in robot.drives
    )
    return replace(robot, drives=tuple(drives))


def _layout(robot: RobotModel, law: CompiledLaw) -> StateLayout:
    return StateLayout.of(structure_of(robot).drives, law.traits)


def _rest(robot: RobotModel, q: Array, payload: Payload) -> tuple[Array, Array]:
    from ropsim.controller import LawTraits

    layout = StateLayout.of(structure_of(robot).drives, LawTraits())
    x, u = np.zeros(layout.integrated), np.zeros(robot.n)
    x[: robot.n] = q
    for k, (drive, tau) in enumerate(zip(robot.drives, gravity(robot, q, payload).tolist(), strict=True)):
        held = steady_drive(drive, float(q[k]), 0.0, tau)
        x[list(layout.drive(k))] = held.states
        u[k] = held.output
    return x, u


def _plant(robot: RobotModel, payload: Payload, x: Array, u: Array, period: float) -> tuple[Array, Array]:
    code = plant_code(structure_of(robot))
    constants = code.constants(arm_numbers(robot, payload))
    s, n = len(x), len(u)
    derivative = (
        load("derivative", code.functions, Engine.PYTHON) if code.functions[-1].name == "derivative" else None
    )
    assert derivative is not None

    def rate(v: Array) -> Array:
        dx = np.empty(s)
        derivative(v[:s].copy(), v[s:].copy(), constants, dx)
        return dx

    J = _differences(rate, np.concatenate((x, u)))
    whole = np.zeros((s + n, s + n))
    whole[:s] = J
    E = expm(period * whole)
    sense = np.array([drive.sense for drive in robot.drives])
    return E[:s, :s], E[:s, s:] * sense


def _law(law: CompiledLaw, robot: RobotModel, x: Array, payload: Payload) -> tuple[Array, ...]:
    from typing import Any
    import math

    scope: dict[str, Any] = {"math": math, "np": np}
    exec(law.source, scope)
    n, layout = robot.n, _layout(robot, law)
    speeds = list(layout.measured_speeds)
    rows = layout.law_rows
    numbers = np.array(barycentric(payload.mass, payload.com, payload.inertia))
    s = len(x)
    q0 = x[:n].copy()

    def f(v: Array) -> Array:
        ref, meas = np.zeros((3, n)), np.zeros((3, n))
        ref[0], meas[0], meas[1] = v[s + rows * n :], v[:n], v[speeds]
        state, out = v[s : s + rows * n].reshape(rows, n).copy(), np.zeros(n)
        scope["law"](law.parameters, state, ref, meas, numbers, np.zeros(0), out)
        return np.concatenate((out, state.ravel()))

    # about the rest the integral holds: put it where the output is that of the rest
    v0 = np.concatenate((x, np.zeros(rows * n), q0))
    J = _differences(f, v0)
    r = rows * n
    return J[:n, :s], J[:n, s : s + r], J[:n, s + r :], J[n:, :s], J[n:, s : s + r], J[n:, s + r :]


def _differences(f, v: Array) -> Array:
    columns = []
    for k in range(len(v)):
        step = np.zeros(len(v))
        step[k] = _SMALL
        columns.append((f(v + step) - f(v - step)) / (2.0 * _SMALL))
    return np.array(columns).T


def postures(robot: RobotModel, payload: Payload, count: int = 256) -> Array:
    """Return three postures that the drives can hold: axis 1 moves least, a middle inertia, and most.

    Args:
        robot: with drives.
        payload: in the hand.
        count: how many postures are looked at.

    Returns:
        Shape (3, n) [rad | m].
    """
    Q = np.array([q for q in configurations(robot, count) if _is_held(robot, q, payload)])
    inertia = np.array([mass_matrix(robot, q, payload)[0, 0] for q in Q])
    order = np.argsort(inertia, kind="stable")
    middle = np.sqrt(inertia.min() * inertia.max())
    return np.asarray(Q[[order[0], int(np.abs(np.log(inertia / middle)).argmin()), order[-1]]])


def _is_held(robot: RobotModel, q: Array, payload: Payload) -> bool:
    loads = zip(robot.drives, q.tolist(), gravity(robot, q, payload).tolist(), strict=True)
    return all(
        abs(steady_drive(drive, place, 0.0, tau).command) < command_limit(drive)
        for drive, place, tau in loads
    )
