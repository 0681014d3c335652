"""Motions, controllers and laws for tests of the servo simulation."""

from dataclasses import replace

import numpy as np

from ropsim import robots
from ropsim.controller import LawInput, LawTraits
from ropsim.flow import JointReference
from ropsim.model import (
    CascadedGains,
    ControllerKind,
    ControllerModel,
    PathDefaults,
    Rates,
    RobotModel,
)
from ropsim.spatial import Array
from support.dc_drives import voltage_amplifier
from support.gains import cascaded

START = np.array([0.0, -1.2, -0.3, 0.1, 0.9, 0.2])
GOAL = np.array([0.3, -1.0, -0.1, -0.2, 0.7, 0.5])


def puma() -> tuple[RobotModel, ControllerModel]:
    """Return the PUMA under loops of fixed gains, joint by joint."""
    robot = robots.load("puma560")
    return robot, robots.cascaded_controller(robot, Rates())


def quintic(start: Array, goal: Array, ticks: int, period: float = 1e-3) -> JointReference:
    """Return a rest-to-rest motion that ends at its last row; row 0 is one period after the start."""
    u = ((np.arange(ticks) + 1.0) / ticks)[:, None]
    way = goal - start
    return JointReference(
        start + way * (10.0 * u**3 - 15.0 * u**4 + 6.0 * u**5),
        way * (30.0 * u**2 - 60.0 * u**3 + 30.0 * u**4) / (ticks * period),
        way * (60.0 * u - 180.0 * u**2 + 120.0 * u**3) / (ticks * period) ** 2,
    )


def part(reference: JointReference, first: int, last: int) -> JointReference:
    """Return the rows of a reference from `first` on, without `last`."""
    rows = slice(first, last)
    return JointReference(reference.q[rows], reference.qd[rows], reference.qdd[rows])


def standing(q: Array, ticks: int) -> JointReference:
    """Return the reference that stands still."""
    rest = np.zeros((ticks, len(q)))
    return JointReference(np.tile(q, (ticks, 1)), rest, rest)


def controller(n: int, rates: Rates | None = None, kv: float = 30.0) -> ControllerModel:
    """Return a cascaded P-PI controller with the same gains for all joints."""
    none = np.zeros(n)
    gains = CascadedGains(np.full(n, 20.0), np.full(n, kv), np.full(n, 12.0 * kv), np.ones(n), none, none)
    return ControllerModel(
        ControllerKind.CASCADED_P_PI, rates or Rates(), gains, PathDefaults(), np.full(n, 1e-3)
    )


class CascadeInPython:
    """The built-in law once more, as a Python object; operations in the same order as the compiled one."""

    traits = LawTraits(state_names=("integral",), hold_row=0)

    def __init__(self, model: ControllerModel, robot: RobotModel) -> None:
        self.gains = cascaded(model)
        self.period = model.rates.control_period
        self.limits = np.array([voltage_amplifier(one).max_voltage for one in robot.drives])
        self.times: list[float] = []

    def step(self, now: LawInput, state: Array, /) -> Array:
        self.times.append(now.time)
        gains, ref, meas = self.gains, now.ref, now.meas
        error = gains.kp * (ref[0] - meas[0]) + gains.kf * ref[1] - meas[1]
        wanted = gains.kv * error + state[0] + gains.ke * ref[1] + gains.ka * ref[2]
        u = np.clip(wanted, -self.limits, self.limits)
        state[0] = np.where(u == wanted, state[0] + gains.ki * error * self.period, state[0])
        return np.asarray(u)


def with_rates(model: ControllerModel, rates: Rates) -> ControllerModel:
    """Return the controller with other rates."""
    return replace(model, rates=rates)
