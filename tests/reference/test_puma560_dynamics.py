"""Published dynamics of the PUMA 560 and of two small cases, to the printed digits."""

import tomllib
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from ropsim import dynamics, kinematics, robots
from ropsim.model import Friction, RobotModel
from support.arms import drive, random_arm

NUMBERS: dict[str, Any] = tomllib.loads(
    (Path(__file__).parent / "data" / "puma560.toml").read_text(encoding="utf-8")
)
QN = NUMBERS["qn"]["value"]
DIFFERENCE = 1e-6  # central difference of torques that are quadratic in the speeds: exact but for rounding


@pytest.fixture(scope="module")
def puma() -> RobotModel:
    return robots.load("puma560")


def _agree(attained: object, table: dict[str, Any]) -> None:
    np.testing.assert_allclose(np.asarray(attained), table["value"], rtol=0, atol=table["tolerance"])


def test_gravity_torques(puma: RobotModel) -> None:
    _agree(dynamics.gravity(puma, QN), NUMBERS["gravload"])


@pytest.mark.parametrize("name", ["rne_qdd", "rne_qd_qdd", "rne_qd"])
def test_inverse_dynamics(puma: RobotModel, name: str) -> None:
    table = NUMBERS[name]
    _agree(dynamics.inverse_dynamics(puma, QN, table["qd"], table["qdd"]), table)


def test_inverse_dynamics_without_gravity(puma: RobotModel) -> None:
    table = NUMBERS["rne_weightless"]
    weightless = replace(puma, gravity=np.zeros(3))
    _agree(dynamics.inverse_dynamics(weightless, QN, table["qd"], table["qdd"]), table)


def test_inverse_dynamics_with_a_wrench_at_the_tool(puma: RobotModel) -> None:
    table = NUMBERS["rne_wrench"]
    _agree(dynamics.inverse_dynamics(puma, QN, table["qd"], table["qdd"], table["wrench"]), table)


def test_joint_space_inertia(puma: RobotModel) -> None:
    table = NUMBERS["inertia"]
    M = dynamics.mass_matrix(puma, QN)
    _agree(np.diag(M), table)
    for row, column, value in table["off_diagonal"]:
        assert M[row, column] == pytest.approx(value, abs=table["tolerance"])


def test_task_space_inertia(puma: RobotModel) -> None:
    J_inverse = np.linalg.inv(kinematics.jacobian(puma, QN))
    M_x = J_inverse.T @ dynamics.mass_matrix(puma, QN) @ J_inverse
    _agree(np.diag(M_x), NUMBERS["inertia_x"])
    eigenvalues = np.linalg.eigvalsh(M_x)
    _agree(eigenvalues[0] / eigenvalues[-1], NUMBERS["asada"])


def test_accelerations(puma: RobotModel) -> None:
    table = NUMBERS["accel"]
    _agree(dynamics.forward_dynamics(puma, QN, table["qd"], table["tau"]), table)


def test_torques_of_inertia(puma: RobotModel) -> None:
    table = NUMBERS["itorque"]
    _agree(dynamics.mass_matrix(puma, QN) @ np.array(table["qdd"]), table)


def test_first_velocity_torque(puma: RobotModel) -> None:
    """Only the product C·q̇ is free of convention."""
    table = NUMBERS["coriolis_row_1"]
    qd = np.array(table["qd"])
    velocity_torque = dynamics.bias(puma, QN, qd) - dynamics.gravity(puma, QN)
    printed = float(np.array(table["value"]) @ qd)
    assert velocity_torque[0] == pytest.approx(printed, abs=table["tolerance"] * float(np.abs(qd).sum()))


def test_friction_that_a_drive_exerts() -> None:
    table = NUMBERS["friction"]
    model = Friction(table["viscous"], table["coulomb_positive"], table["coulomb_negative"])
    robot = random_arm(0, "RRRR", (drive(ratio=table["ratio"], friction=model),) * 4)
    _agree(dynamics.friction(robot, np.zeros(4), table["qd"]), table)


@pytest.mark.parametrize("case", [0, 1])
def test_two_link_statics(case: int) -> None:
    table = NUMBERS["two_link"]
    torques = dynamics.gravity(robots.load("two_link"), table["q"][case]) / NUMBERS["gravity"]["value"]
    np.testing.assert_allclose(torques, table["value"][case], rtol=0, atol=table["tolerance"])


def test_two_link_tip_force() -> None:
    table = NUMBERS["two_link_wrench"]
    robot = replace(robots.load("two_link"), gravity=np.zeros(3))
    rest = np.zeros(2)
    _agree(dynamics.inverse_dynamics(robot, table["q"], rest, rest, table["wrench"]), table)
