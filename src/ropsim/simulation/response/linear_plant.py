"""Arm and drives from control tick to control tick, linear, from their own code."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from ropsim.codegen import Engine, GivenCode, load
from ropsim.controller import LawTraits
from ropsim.dynamics import arm_numbers, passive_ratios, structure_of
from ropsim.model import Friction, Payload, Rates, RobotModel
from ropsim.simulation.servo.held_state import SMALL, with_steady_screws, without_dead_zones
from ropsim.simulation.servo.plant_code import ClosedPlantCode, LongPlantCode, plant_code
from ropsim.simulation.servo.plant_steps import plant_steps_of
from ropsim.simulation.servo.state import StateLayout
from ropsim.spatial import Array


@dataclass(frozen=True, slots=True)
class LinearPlant:
    """An arm whose drives have no dry friction, play and overlap, and whose screws are linear, as functions.

    Attributes:
        arm: that arm.
        layout: of its state.
        code: its equations.
        derivative: rates of its state.
        efforts: efforts of its drives.
        period: control period [s].
        steps: integration steps in it.
        senses: of the transmissions, shape (n,).
    """

    arm: RobotModel
    layout: StateLayout
    code: GivenCode | LongPlantCode | ClosedPlantCode
    derivative: Callable[..., None]
    efforts: Callable[..., None]
    period: float
    steps: int
    senses: Array

    @classmethod
    def of(cls, robot: RobotModel, rates: Rates) -> "LinearPlant":
        """Return the plant of an arm with drives."""
        arm = without_dead_zones(_without_dry_friction(robot))
        arm = with_steady_screws(arm, robot.home, np.zeros(robot.n), Payload())
        structure = structure_of(arm)
        code = plant_code(structure)
        efforts = tuple(one for one in code.functions if one.name == "efforts")
        return cls(
            arm,
            StateLayout.of(structure, LawTraits()),
            code,
            load("derivative", code.functions, Engine.PYTHON),
            load("efforts", efforts, Engine.PYTHON),
            rates.control_period,
            plant_steps_of(robot, rates),
            np.array([drive.sense for drive in arm.drives]),
        )

    def constants(self, q: Array, qd: Array, payload: Payload) -> Array:
        """Return the numbers of the arm with a load in a steady motion.

        Args:
            q: joint coordinates [rad | m], shape (n,).
            qd: joint speeds [rad/s | m/s], shape (n,); screws pass on what they do at them.
            payload: tool and part.
        """
        return self.code.constants(arm_numbers(with_steady_screws(self.arm, q, qd, payload), payload))

    def matrices(self, constants: Array, point: tuple[Array, Array]) -> tuple[Array, Array]:
        """Return how the state after a tick follows from that before it and from the command of the law.

        Coordinates of closed chains move as the axes let them. Steps of the classical Runge-Kutta method
        multiply by the first five terms of the exponential series.

        Args:
            constants: of the arm with its load.
            point: the integrated state, and outputs of the amplifiers, about which it is linear.
        """
        (x0, u0), s, n = point, self.layout.driven, self.layout.n
        K = passive_ratios(self.arm, x0[np.newaxis, :n])[0] if self.arm.cuts else None
        loops = self.layout.loops

        def rates(values: Array) -> Array:
            x, dx = np.concatenate((values[:s], x0[s:])), np.empty(len(x0))
            if K is not None:
                x[list(loops.passive)] += K @ (values[:n] - x0[:n])
                x[list(loops.passive_speeds)] = K @ values[n : 2 * n]
            self.derivative(x, values[s:].copy(), constants, dx)
            return dx[:s]

        whole = np.zeros((s + n, s + n))
        whole[:s] = differences(rates, np.concatenate((x0[:s], u0)))
        step = term = np.eye(s + n)
        for order in range(1, 5):
            term = term @ whole * (self.period / self.steps / order)
            step = step + term
        after = np.linalg.matrix_power(step, self.steps)
        return after[:s, :s], after[:s, s:] * self.senses


def _without_dry_friction(robot: RobotModel) -> RobotModel:
    drives = (
        replace(one, friction=Friction(one.friction.viscous, smoothing_speed=one.friction.smoothing_speed))
        for one in robot.drives
    )
    return replace(robot, drives=tuple(drives))


def differences(function: Callable[[Array], Array], values: Array) -> Array:
    """Return the Jacobian of a function by central differences."""
    sizes = SMALL * np.maximum(1.0, np.abs(values))
    columns = [
        (function(values + h) - function(values - h)) / (2.0 * size)
        for h, size in zip(np.diag(sizes), sizes.tolist(), strict=True)
    ]
    return np.array(columns).T
