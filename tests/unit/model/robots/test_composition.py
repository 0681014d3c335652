"""Arms with external axes: one mechanism, the axes of the arm first."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.dynamics import gravity, inverse_dynamics
from ropsim.kinematics import forward, frames_batch, jacobian
from ropsim.model import Payload, RobotModel, audit, beside, held_arm, on_track
from ropsim.spatial import Pose, frozen
from support.arms import random_arm
from support.mujoco_tree import MujocoTree
from support.trees import random_tree

PUMA = robots.load("puma560")
TRACK = robots.linear_track(4.0)
TABLE = robots.turntable(0.8)
SEAT = Pose(np.array([0.1, 0.0, 0.02]), np.array([0.9, 0.0, 0.0, 0.3]))
X_BP = Pose(np.array([1.5, 0.4, 0.0]))
STATION = beside(on_track(PUMA, TRACK, SEAT), TABLE, X_BP)
Q = np.array([0.1, 1.2, -2.8, 0.2, 0.5, 0.3, 0.7, -0.4])
ROUNDING = 1e-12


def test_the_axes_are_those_of_the_arm_and_then_the_external_ones() -> None:
    assert [joint.name for joint in STATION.axis_joints] == ["1", "2", "3", "4", "5", "6", "E1", "E2"]
    assert STATION.external == (6, 7)
    assert STATION.drives == (*PUMA.drives, *TRACK.drives, *TABLE.drives)
    assert STATION.home.tolist() == [*PUMA.home.tolist(), 0.0, 0.0]
    assert not [finding for finding in audit(STATION) if finding.is_error]


def test_the_track_carries_the_arm_and_not_the_table() -> None:
    on_rail = Pose(np.array([0.7, 0.0, 0.35])) @ SEAT
    expected = on_rail @ forward(PUMA, Q[:6])
    np.testing.assert_allclose(forward(STATION, Q).matrix(), expected.matrix(), rtol=0, atol=ROUNDING)
    table = frames_batch(STATION, Q[np.newaxis])[0, len(STATION.joints) - 1]
    turned = X_BP @ Pose(np.array([0.0, 0.0, 0.7]), np.array([np.cos(0.2), 0.0, 0.0, -np.sin(0.2)]))
    np.testing.assert_allclose(table, turned.matrix(), rtol=0, atol=ROUNDING)
    assert jacobian(STATION, Q)[:, 7].tolist() == [0.0] * 6
    np.testing.assert_allclose(jacobian(STATION, Q)[:, 6], [1, 0, 0, 0, 0, 0], rtol=0, atol=ROUNDING)


def test_an_accelerated_track_pushes_all_that_it_carries() -> None:
    """Newton: force = (carriage + arm + load + rotor)·a, while the arm keeps its posture."""
    rest, along = np.zeros(8), np.eye(8)[6]
    load = Payload(2.0)
    tau = inverse_dynamics(STATION, Q, rest, along, payload=load)
    standing = inverse_dynamics(STATION, Q, rest, rest, payload=load)
    drive = TRACK.drives[0]
    carried = (
        250.0
        + sum(link.mass for link in PUMA.links)
        + 2.0
        + drive.motor.rotor_inertia * drive.ratio_at(0.0) ** 2
    )
    assert (tau - standing)[6] == pytest.approx(carried, rel=1e-12)


def test_the_arm_feels_its_own_weight_only() -> None:
    upright = on_track(PUMA, TRACK)
    np.testing.assert_allclose(gravity(upright, Q[:7])[:6], gravity(PUMA, Q[:6]), rtol=0, atol=1e-9)


def test_a_station_moves_as_its_tree_in_another_engine() -> None:
    arm = random_arm(4, "RRPRRR")
    station = beside(on_track(arm, TRACK, SEAT), TABLE, X_BP)
    oracle = MujocoTree(station)
    frames = frames_batch(station, Q[np.newaxis])[0, :-1]
    in_order = np.array([Q[6], *Q[:6], Q[7]])  # the coordinates joint by joint: track, arm, table
    np.testing.assert_allclose(frames, oracle.frames(in_order), rtol=0, atol=ROUNDING)


def test_couplings_keep_their_joints_in_company() -> None:
    palletizer = robots.load("palletizer")
    station = beside(on_track(palletizer, TRACK), random_tree(3, 5).robot, X_BP)
    q = np.concatenate([palletizer.home + 0.1, [0.5], np.full(station.n - 5, 0.3)])
    expected = Pose(np.array([0.5, 0.0, 0.35])) @ forward(palletizer, q[:4])
    np.testing.assert_allclose(forward(station, q).matrix(), expected.matrix(), rtol=0, atol=ROUNDING)


def test_the_feet_of_the_arm_ride_on_the_carriage() -> None:
    carriage = STATION.links[TRACK.interface_link].shapes
    assert len(carriage) == len(TRACK.links[-1].shapes) + len(PUMA.base_shapes)
    assert len(STATION.base_shapes) == len(TRACK.base_shapes) + len(TABLE.base_shapes)


def test_the_arm_is_found_again_in_its_station() -> None:
    held = held_arm(STATION)
    assert (held.axes, held.carrier) == ((0, 1, 2, 3, 4, 5), TRACK.interface_link)
    at_seat = held.arm.joints[0].placement
    assert replace(held.arm.joints[0], placement=PUMA.joints[0].placement) == PUMA.joints[0]
    expected = SEAT @ PUMA.joints[0].placement
    np.testing.assert_allclose(at_seat.matrix(), expected.matrix(), rtol=0, atol=ROUNDING)
    assert (held.arm.joints[1:], held.arm.links) == (PUMA.joints[1:], PUMA.links)


def test_an_arm_beside_a_table_is_its_own_arm() -> None:
    held = held_arm(beside(PUMA, TABLE, X_BP))
    assert (held.arm, held.carrier) == (
        replace(PUMA, origins=held.arm.origins, base_shapes=held.arm.base_shapes),
        -1,
    )


def test_a_station_without_drives_of_one_part_has_none() -> None:
    bare: RobotModel = replace(PUMA, drives=())
    assert on_track(bare, TRACK).drives == ()
    assert on_track(bare, TRACK).home.tolist() == frozen([*PUMA.home, 0.0]).tolist()
