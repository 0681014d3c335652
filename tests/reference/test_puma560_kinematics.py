"""Kinematics of the PUMA 560 against the numbers of Corke's Robotics Toolbox."""

import tomllib
from dataclasses import replace
from math import hypot
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from ropsim import kinematics, robots
from ropsim.kinematics import IkOptions, Limits, posture, solver_of
from ropsim.model import RobotModel
from ropsim.spatial import Array

_TABLES: dict[str, Any] = tomllib.loads(
    (Path(__file__).parent / "data" / "puma560.toml").read_text(encoding="utf-8")
)
_PUMA = robots.load("puma560")
SHOULDER = 0.67183  # height of axis 2 [m]
OFFSET = 0.15005  # of the wrist centre beside axis 1 [m]
SAMPLES = 541  # of each range of 270°: one in half a degree
CELL = 3e-3  # of the quadrature [m]; it gives the volume to 5e-4
_QN = np.array(_TABLES["qn"]["value"])


def check(found: Any, quantity: str) -> None:
    table = _TABLES[quantity]
    np.testing.assert_allclose(found, table["value"], rtol=0.0, atol=table["tolerance"], err_msg=quantity)


def apart_around(angle: Array, other: Array) -> Array:
    """Return the differences of angles in [-π, π) [rad]."""
    return np.asarray((angle - other + np.pi) % (2.0 * np.pi) - np.pi)


def apart(q: Array, other: Array) -> float:
    """Return the largest difference of two configurations, whole turns ignored [rad]."""
    return float(np.abs(apart_around(q, other)).max())


def test_every_table_states_unit_source_and_tolerance() -> None:
    for name, table in _TABLES.items():
        if name != "sources":
            assert set(table) >= {"value", "unit", "source", "tolerance"}, name
            assert table["source"] in _TABLES["sources"], name


def test_forward_kinematics_at_qn() -> None:
    pose = kinematics.forward(_PUMA, _QN)
    check(pose.position, "fkine_position")
    check(pose.rotation(), "fkine_rotation")


def test_compiled_forward_kinematics_at_qn() -> None:
    matrix = kinematics.forward_batch(_PUMA, [_QN])[0]
    check(matrix[:3, 3], "fkine_position")
    check(matrix[:3, :3], "fkine_rotation")


def test_manipulability_at_qn() -> None:
    J = kinematics.jacobian(_PUMA, _QN)
    check(np.sqrt(np.linalg.det(J @ J.T)), "manipulability")
    check(np.sqrt(np.linalg.det(J[:3] @ J[:3].T)), "manipulability_translation")
    check(np.sqrt(np.linalg.det(J[3:] @ J[3:].T)), "manipulability_rotation")


def test_all_eight_branches_at_qn() -> None:
    branches = kinematics.inverse_batch(_PUMA, kinematics.forward_batch(_PUMA, [_QN]))[0]
    table = _TABLES["ik8_qn"]
    for found, published, name in zip(branches, table["value"], table["names"], strict=True):
        assert apart(found, np.array(published)) < table["tolerance"], name


@pytest.mark.parametrize("row", range(8))
def test_published_branches_reach_the_pose_and_have_the_published_names(row: int) -> None:
    table = _TABLES["ik8_qn"]
    q = np.array(table["value"][row])
    pose = kinematics.forward(_PUMA, q)
    rounding = 10.0 * table["tolerance"]  # six angles, each rounded to six digits, act on at most 1 m
    np.testing.assert_allclose(pose.matrix(), kinematics.forward(_PUMA, _QN).matrix(), atol=rounding)
    found = posture(_PUMA, q)
    assert "".join(word[0] for word in found.words) == table["names"][row]
    assert solver_of(_PUMA).postures[row] == found


def test_all_branches_are_solutions_when_limits_are_ignored() -> None:
    result = kinematics.inverse(_PUMA, kinematics.forward(_PUMA, _QN), IkOptions(limits=Limits.IGNORE))
    assert len(result.solutions) == 8
    assert result.postures == solver_of(_PUMA).postures


def test_exactly_three_branches_remain_within_the_limits() -> None:
    result = kinematics.inverse(_PUMA, kinematics.forward(_PUMA, _QN))
    names = ["".join(word[0] for word in one.words) for one in result.postures]
    assert names == _TABLES["ik8_qn"]["within_limits"]


def test_the_nominal_configuration_is_among_the_branches_of_its_own_pose() -> None:
    """Its joint 3 at 180° is the same angle as -180°, which lies within the limits."""
    solutions = kinematics.inverse(_PUMA, kinematics.forward(_PUMA, _QN)).solutions
    nearest = min(solutions, key=lambda q: apart(q, _QN))
    assert apart(nearest, _QN) < 1e-9
    assert nearest[2] == pytest.approx(-np.pi)


def test_reach_of_the_wrist_centre() -> None:
    table = _TABLES["reach_from_shoulder"]
    stretched = [0.0, 0.0, -np.arctan2(0.4318, 0.0203), 0.0, 0.3, 0.0]  # DH lengths of the forearm
    wrist = kinematics.joint_frames(_PUMA, stretched)[4, :3, 3]
    radius = hypot(wrist[0], wrist[2] - 0.67183)
    assert radius == pytest.approx(table["value"], abs=table["tolerance"])


def test_heights_and_radius_that_the_wrist_centre_reaches_within_the_limits() -> None:
    q2, q3 = np.meshgrid(*(np.linspace(joint.lower, joint.upper, SAMPLES) for joint in _PUMA.joints[1:3]))
    Q = np.zeros((q2.size, 6))
    Q[:, 1], Q[:, 2] = q2.ravel(), q3.ravel()
    wrist = kinematics.forward_batch(_PUMA, Q)[:, :3, 3]  # the interface lies in the wrist centre
    check([wrist[:, 2].min() - SHOULDER, wrist[:, 2].max() - SHOULDER], "workspace_heights")
    check(np.hypot(wrist[:, 0], wrist[:, 1]).max(), "workspace_radius")


def test_volume_that_the_wrist_centre_reaches_within_the_limits() -> None:
    check(workspace_volume(_PUMA), "workspace_volume")


def test_volume_without_limits_is_that_of_a_ball_of_the_reach() -> None:
    """The wrist centre is ahead of axis 1 and beside it; the offset beside it does not change the volume."""
    free = [replace(joint, lower=-np.pi, upper=np.pi) for joint in _PUMA.joints]
    reach = _TABLES["reach_from_shoulder"]["value"]
    volume = workspace_volume(replace(_PUMA, joints=tuple(free)))
    assert volume == pytest.approx(4.0 / 3.0 * np.pi * reach**3, rel=5e-4)


def workspace_volume(robot: RobotModel) -> float:
    """Return the volume of the points that the wrist centre reaches [m³].

    Midpoint rule over height and distance ahead of axis 1; each point counts with the azimuths to which
    joint 1 turns it with one shoulder or the other.
    """
    columns, rows = np.arange(CELL / 2.0, 0.88, CELL), np.arange(-0.88, 0.88, CELL)
    ahead, z = (grid.ravel() for grid in np.meshgrid(columns, rows))
    T = np.tile(np.eye(4), (len(z), 1, 1))
    T[:, 0, 3], T[:, 2, 3] = np.hypot(ahead, OFFSET), z + SHOULDER
    arms = kinematics.inverse_batch(robot, T)[:, ::2, :3].reshape(-1, 2, 2, 3)  # two wrists share an arm
    q23, (lower, upper) = arms[..., 1:], (robot.lower_limits[1:3], robot.upper_limits[1:3])
    turned = q23 - 2.0 * np.pi * np.floor((q23 - lower) / (2.0 * np.pi))
    reaches = np.all(turned <= upper, axis=3).any(axis=2)  # by shoulder; absent branches are NaN
    missed = 2.0 * np.pi - (robot.upper_limits[0] - robot.lower_limits[0])
    turn = np.abs(apart_around(arms[:, 0, :, 0].max(axis=1), arms[:, 1, :, 0].max(axis=1)))
    azimuths = np.where(reaches.any(axis=1), 2.0 * np.pi - missed, 0.0)
    azimuths += np.where(reaches.all(axis=1), missed - np.clip(missed - turn, 0.0, None), 0.0)
    return float((azimuths * ahead).sum()) * CELL**2
