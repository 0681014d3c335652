"""Paths that the wrist leads while a track and a positioner go along: way, joints, limits, refusals."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from ropsim.flow import MotionKind, MoveInstruction
from ropsim.kinematics import posture
from ropsim.model import OrientationMode, Payload
from ropsim.planning import MotionChain, Refusal, plan_move
from ropsim.planning.testing import PlannedMove, planned_move_of
from ropsim.spatial import Array, Pose
from support.carried import carried_cell, commanded, from_plate, to_plate, to_room, tool_poses
from support.cells import chain_of, with_station
from support.motion import START, planned, planned_stretch
from support.walks import shares

ON_PATH = 1e-6  # [m], what is asked of a commanded path in the frame of the positioner
AS_TOLD = 1e-7  # [rad | m]; the path of the joints goes through samples, to 5e-8 between them
HELD = 1.0 + 1e-9  # of a limit, as for all motions
SEEDS = range(4)
KINDS = MotionKind.LIN, MotionKind.CIRC, MotionKind.SPLINE


@cache
def chain(seed: int, mode: OrientationMode = OrientationMode.WRIST_ANGLES) -> MotionChain:
    cell = carried_cell(seed=seed)
    return chain_of(with_station(cell, controller=replace(cell.first.controller, orientation=mode)))


def ends(seed: int) -> tuple[Array, Array]:
    """Return start and goal: an arm that moves a little while track and plate take a long way."""
    rng = np.random.default_rng(seed)
    start = np.array([*START, *rng.uniform(-0.2, 0.2, 3)])
    return start, start + np.array([*rng.uniform(-0.2, 0.2, 6), *rng.uniform(-0.5, 0.5, 3)])


def on_plate(seed: int, kind: MotionKind, start: Array, goal: Array) -> MoveInstruction:
    """Return the move of a kind to where the torch is on the plate at the goal, through points beside."""
    robot, random = chain(seed).robot, np.random.default_rng(seed)
    counts = {MotionKind.LIN: 0, MotionKind.CIRC: 1, MotionKind.SPLINE: 3}
    along = np.linspace(0.0, 1.0, counts[kind] + 2)[1:-1, None]
    points = start + along * (goal - start)
    points[:, :6] += random.uniform(-0.05, 0.05, (len(points), 6))
    via = tuple(Pose.from_matrix(X) for X in from_plate(robot, points)) if len(points) else ()
    return replace(to_plate(robot, goal, kind), via=via)


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("kind", KINDS)
def test_the_tcp_keeps_its_path_on_the_plate(kind: MotionKind, seed: int) -> None:
    start, goal = ends(seed)
    robot, move = chain(seed).robot, on_plate(seed, kind, start, goal)
    fixed = planned_move_of(chain(seed, OrientationMode.FIXED_AXIS), move, start)
    assert isinstance(fixed, PlannedMove)
    assert fixed.tool is not None
    done = planned(move, start, chain(seed))
    Q = commanded(done)
    X = from_plate(robot, Q)
    assert fixed.tool.distance(X[:, :3, 3]).max() < ON_PATH
    np.testing.assert_allclose(X[-1], from_plate(robot, goal[None])[0], rtol=0, atol=AS_TOLD)
    np.testing.assert_allclose(Q[-1, 6:], goal[6:], rtol=0, atol=1e-12)
    assert posture(robot, Q[-1]).words[:2] == posture(robot, start).words[:2]
    assert max(shares(robot, done, Payload()).values()) <= HELD


@pytest.mark.parametrize("seed", SEEDS)
def test_wrist_and_external_axes_go_evenly_with_the_place_on_a_line(seed: int) -> None:
    start, goal = ends(seed)
    robot = chain(seed).robot
    for move in (to_plate(robot, goal), to_room(robot, goal)):
        leg = planned_move_of(chain(seed), move, start)
        assert isinstance(leg, PlannedMove)
        assert leg.joints is not None
        r = np.linspace(0.0, 1.0, 201)
        q = leg.joints.joints(r * leg.joints.length).q[:, 3:]
        assert np.abs(q - (start[3:] + r[:, None] * (leg.q_end - start)[3:])).max() < 1e-9


@pytest.mark.parametrize("seed", SEEDS)
def test_a_line_in_the_room_is_straight_there_while_the_track_goes_along(seed: int) -> None:
    start, goal = ends(seed)
    robot = chain(seed).robot
    positions = tool_poses(robot, commanded(planned(to_room(robot, goal), start, chain(seed))))[:, :3, 3]
    way = positions[-1] - positions[0]
    along = (positions - positions[0]) @ way / (way @ way)
    assert np.linalg.norm(positions - positions[0] - along[:, None] * way, axis=1).max() < ON_PATH
    assert np.abs(positions[-1] - tool_poses(robot, goal[None])[0, :3, 3]).max() < AS_TOLD


def test_a_line_on_the_plate_passes_the_singularity_of_the_wrist() -> None:
    start, goal = ends(0)
    start[3:6], goal[3:6] = [0.3, -0.4, 0.2], [0.3, 0.4, 0.2]
    robot = chain(0).robot
    Q = commanded(planned(to_plate(robot, goal), start, chain(0)))
    assert np.abs(Q[-1] - goal).max() < AS_TOLD
    assert (np.diff(Q[:, 4]) >= -1e-12).all()
    assert np.abs(Q[:, [3, 5]] - [0.3, 0.2]).max() < AS_TOLD


@pytest.mark.parametrize("seed", SEEDS)
def test_the_tool_path_is_that_of_the_tool_on_the_plate(seed: int) -> None:
    start, goal = ends(seed)
    robot = chain(seed).robot
    leg = planned_move_of(chain(seed), to_plate(robot, goal), start)
    assert isinstance(leg, PlannedMove)
    assert leg.tool is not None
    assert leg.joints is not None
    s = np.linspace(0.0, leg.tool.length, 13)
    points = leg.tool.tool(s)
    np.testing.assert_allclose(
        points.matrices, from_plate(robot, leg.joints.joints(s).q), rtol=0, atol=AS_TOLD
    )
    h = 1e-4 * leg.tool.length
    before, behind = (leg.tool.tool(s[1:-1] + side).matrices[:, :3, :3] for side in (-h, h))
    turned = (behind - before) / (2.0 * h) @ np.swapaxes(points.matrices[1:-1, :3, :3], 1, 2)
    rates = np.stack((turned[:, 2, 1], turned[:, 0, 2], turned[:, 1, 0]), axis=1)
    np.testing.assert_allclose(points.d1[1:-1, 3:], rates, rtol=0, atol=1e-5 * np.abs(rates).max())


def test_a_tool_that_stands_while_the_track_moves_stays_where_it_is() -> None:
    start, goal = ends(2)
    robot = chain(2).robot
    goal[:6] = start[:6]
    move = to_room(robot, start)
    move = replace(move, external=(start[6] + 0.3, *start[7:].tolist()))
    Q = commanded(planned(move, start, chain(2)))
    X = tool_poses(robot, Q)
    assert Q[-1, 6] == pytest.approx(start[6] + 0.3)
    assert np.abs(X[:, :3, 3] - X[0, :3, 3]).max() < ON_PATH
    np.testing.assert_allclose(X[-1], X[0], rtol=0, atol=AS_TOLD)


@pytest.mark.parametrize("seed", SEEDS)
def test_a_zone_between_two_lines_on_the_plate_is_flown(seed: int) -> None:
    start, goal = ends(seed)
    robot = chain(seed).robot
    middle = 0.5 * (start + goal) + np.array([0.05, -0.05, 0.05, 0.1, -0.1, 0.2, 0.0, 0.05, 0.0])
    first = to_plate(robot, middle)
    first = replace(first, modal=replace(first.modal, zone=0.06))
    done = planned_stretch([first, to_plate(robot, goal)], start, chain(seed))
    assert done.moves[0].zone > 0.015
    assert {one.code for one in done.findings} <= {"M562"}  # half of a way may be less than the zone
    assert max(shares(robot, done, Payload()).values()) <= HELD


def test_an_end_that_the_arm_does_not_reach_in_its_posture_is_refused() -> None:
    start, goal = ends(0)
    robot = chain(0).robot
    goal[:6] = [2.07, 0.98, -0.55, -1.06, 1.21, 3.95]
    found = plan_move(
        chain(0), to_room(robot, goal), np.array([0.26, 0.12, -1.81, 0.3, -0.83, 0.2, *start[6:]])
    )
    assert isinstance(found, Refusal)
    assert [one.code for one in found.diagnostics] == ["M586"]
