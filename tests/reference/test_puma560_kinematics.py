"""Kinematics of the PUMA 560 against the numbers of Corke's Robotics Toolbox."""

import tomllib
from math import hypot
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from ropsim import kinematics, robots
from ropsim.kinematics import IkOptions, Limits, posture
from ropsim.spatial import Array

_TABLES: dict[str, Any] = tomllib.loads(
    (Path(__file__).parent / "data" / "puma560.toml").read_text(encoding="utf-8")
)
_PUMA = robots.load("puma560")
_QN = np.array(_TABLES["qn"]["value"])


def check(found: Any, quantity: str) -> None:
    table = _TABLES[quantity]
    np.testing.assert_allclose(found, table["value"], rtol=0.0, atol=table["tolerance"], err_msg=quantity)


def apart(q: Array, other: Array) -> float:
    """Return the largest difference of two configurations, whole turns ignored [rad]."""
    return float(np.abs((q - other + np.pi) % (2.0 * np.pi) - np.pi).max())


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
    assert found.shoulder.value[0] + found.elbow.value[0] + found.wrist.value[0] == table["names"][row]
    assert found.index == row


def test_all_branches_are_solutions_when_limits_are_ignored() -> None:
    result = kinematics.inverse(_PUMA, kinematics.forward(_PUMA, _QN), IkOptions(limits=Limits.IGNORE))
    assert len(result.solutions) == 8
    assert [posture.index for posture in result.postures] == list(range(8))


def test_exactly_two_branches_remain_within_the_limits() -> None:
    result = kinematics.inverse(_PUMA, kinematics.forward(_PUMA, _QN))
    names = [f"{p.shoulder.value[0]}{p.elbow.value[0]}{p.wrist.value[0]}" for p in result.postures]
    assert names == _TABLES["ik8_qn"]["within_limits"]


def test_reach_of_the_wrist_centre() -> None:
    table = _TABLES["reach_from_shoulder"]
    stretched = [0.0, 0.0, -np.arctan2(0.4318, 0.0203), 0.0, 0.3, 0.0]  # DH lengths of the forearm
    wrist = kinematics.joint_frames(_PUMA, stretched)[4, :3, 3]
    radius = hypot(wrist[0], wrist[2] - 0.67183)
    assert radius == pytest.approx(table["value"], abs=table["tolerance"])
