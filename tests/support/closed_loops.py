"""The servo loop of an arm about a rest, linear and tick by tick: true plant, true law, output held."""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from scipy.linalg import expm

from ropsim.codegen import Engine, load
from ropsim.controller import CompiledLaw, LawTraits, law_of
from ropsim.dynamics import (
    arm_numbers,
    axis_inertias,
    barycentric,
    effort_limits,
    gravity,
    gravity_loads,
    steady_drive,
    structure_of,
)
from ropsim.kinematics import configurations
from ropsim.model import ControllerModel, Friction, Payload, RobotModel, cube_of_water, with_payload
from ropsim.simulation.testing import StateLayout, plant_code
from ropsim.spatial import Array

_SMALL = 1e-6
"""Step of the central differences, in SI units of each number."""
_HELD = 0.95
"""Most of the torque limits that gravity takes where an arm is to be controlled."""
POSTURES = 256
"""Postures of which three are chosen."""


@dataclass(frozen=True, slots=True, eq=False)
class ClosedLoop:
    """z ← A·z + B·q_ref once per control tick; z holds the plant, the law, and outputs on their way.

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

    def overshoots(self, ticks: int) -> Array:
        """Return by which share each axis goes beyond a step of its reference, shape (n,)."""
        Z, most = np.zeros(self.B.shape), np.zeros(self.B.shape[1])
        for _ in range(ticks):
            Z = self.A @ Z + self.B
            most = np.maximum(most, np.diag(Z))
        return np.asarray(np.maximum(most - 1.0, 0.0))


@dataclass(frozen=True, slots=True, eq=False)
class OpenLoop:
    """Plant and law of an arm about a rest.

    Attributes:
        F: how the state of the plant follows from that a tick before, shape (s, s).
        G: and from the output of the law, shape (s, n).
        K: how that follows from state of the plant, state of the law, and reference, shape (n, s + m + n).
        L: how the state of the law follows from these, shape (m, s + m + n).
    """

    F: Array
    G: Array
    K: Array
    L: Array

    def closed(self, late: int = 0) -> ClosedLoop:
        """Return the closed loop; the output of the law acts by some ticks later than it does."""
        (s, n), m = self.G.shape, len(self.L)
        first, size = s + m, s + m + late * n
        A, B = np.zeros((size, size)), np.zeros((size, n))
        A[:s, :s], A[s:first, :first], B[s:first] = self.F, self.L[:, :first], self.L[:, first:]
        now, reference = self.K[:, :first], self.K[:, first:]
        if late:
            A[:s, first : first + n] = self.G
            A[first:-n, first + n :] = np.eye((late - 1) * n)
            A[-n:, :first], B[-n:] = now, reference
        else:
            A[:s, :first] += self.G @ now
            B[:s] = self.G @ reference
        return ClosedLoop(A, B)


def open_loop(robot: RobotModel, controller: ControllerModel, q: Array, payload: Payload) -> OpenLoop:
    """Return plant and law about a rest, without dry friction, which would damp the loop.

    Args:
        robot: with drives.
        controller: of the arm.
        q: coordinates of the rest [rad | m], shape (n,).
        payload: in the hand; the law knows it.
    """
    arm = _without_dry_friction(robot)
    x, u = _rest(arm, q, payload)
    F, G = _plant(arm, payload, (x, u), controller.rates.control_period)
    K, L = _law(law_of(controller, robot), arm, x, payload)
    return OpenLoop(F, G, K, L)


def rated_load(mass: float) -> Payload:
    """Return a cube of water on the interface, or nothing for a mass of 0 [kg]."""
    return cube_of_water(mass) if mass else Payload()


def postures(robot: RobotModel, mass: float) -> Array:
    """Return three postures that the drives can hold: axis 1 moves least, a middle inertia, and most.

    Args:
        robot: with drives.
        mass: of the load in the hand [kg].

    Returns:
        Shape (3, n) [rad | m].
    """
    loaded, Q = with_payload(robot, mass), configurations(robot, POSTURES)
    Q = Q[(np.abs(gravity_loads(loaded, Q)) < _HELD * effort_limits(robot)).all(axis=1)]
    inertia = axis_inertias(loaded, Q)[:, 0]
    middle = np.sqrt(inertia.min() * inertia.max())
    return np.asarray(Q[[inertia.argmin(), np.abs(np.log(inertia / middle)).argmin(), inertia.argmax()]])


def _without_dry_friction(robot: RobotModel) -> RobotModel:
    drives = (
        replace(one, friction=Friction(one.friction.viscous, smoothing_speed=one.friction.smoothing_speed))
        for one in robot.drives
    )
    return replace(robot, drives=tuple(drives))


def _rest(robot: RobotModel, q: Array, payload: Payload) -> tuple[Array, Array]:
    """Return the integrated state of an arm at rest, and the outputs of its amplifiers."""
    layout = StateLayout.of(structure_of(robot).drives, LawTraits())
    x, u = np.zeros(layout.integrated), np.zeros(robot.n)
    x[: robot.n] = q
    for k, (drive, tau) in enumerate(zip(robot.drives, gravity(robot, q, payload).tolist(), strict=True)):
        held = steady_drive(drive, float(q[k]), 0.0, tau)
        x[list(layout.drive(k))] = held.states
        u[k] = held.output
    return x, u


def _plant(
    robot: RobotModel, payload: Payload, rest: tuple[Array, Array], period: float
) -> tuple[Array, Array]:
    """Return how the state after a tick follows from that before it and from the command of the law."""
    code = plant_code(structure_of(robot))
    constants = code.constants(arm_numbers(robot, payload))
    derivative, s, n = load("derivative", code.functions, Engine.PYTHON), len(rest[0]), len(rest[1])

    def rates(values: Array) -> Array:
        dx = np.empty(s)
        derivative(values[:s].copy(), values[s:].copy(), constants, dx)
        return dx

    whole = np.zeros((s + n, s + n))
    whole[:s] = _differences(rates, np.concatenate(rest))
    after = expm(period * whole)
    return after[:s, :s], after[:s, s:] * np.array([drive.sense for drive in robot.drives])


def _law(law: CompiledLaw, robot: RobotModel, x: Array, payload: Payload) -> tuple[Array, Array]:
    """Return how outputs and next states of a law follow from state, law and reference: two matrices."""
    scope: dict[str, Any] = {"math": math, "np": np}
    for one in law.functions:
        exec(one.text, scope)
    exec(law.source, scope)
    layout = StateLayout.of(structure_of(robot).drives, law.traits)
    n, s, speeds = robot.n, layout.integrated, list(layout.measured_speeds)
    numbers = np.array(barycentric(payload.mass, payload.com, payload.inertia))

    def answers(values: Array) -> Array:
        ref, meas, out = np.zeros((3, n)), np.zeros((3, n)), np.zeros(n)
        ref[0], meas[0], meas[1] = values[-n:], values[:n], values[speeds]
        state = values[s:-n].reshape(-1, n).copy()
        scope["law"](law.parameters, state, ref, meas, numbers, np.zeros(0), out)
        return np.concatenate((out, state.ravel()))

    rest = np.concatenate((x, np.zeros(layout.law_rows * n), x[:n]))
    J = _differences(answers, rest)
    return J[:n], J[n:]


def _differences(function: Callable[[Array], Array], values: Array) -> Array:
    """Return the Jacobian of a function by central differences."""
    steps = _SMALL * np.eye(len(values))
    return np.array([(function(values + h) - function(values - h)) / (2.0 * _SMALL) for h in steps]).T
