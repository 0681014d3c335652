"""Paths of the tool with external axes: straight in the frame that they move, evenly with the place."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from ropsim.flow import MotionKind, MoveInstruction, Side, Trigger
from ropsim.kinematics import Method, solver_of
from ropsim.model import RobotModel
from ropsim.planning import MotionChain, MotionPlan, Refusal, plan_move
from ropsim.planning.testing import PlannedMove, planned_move_of
from ropsim.spatial import Array, Pose
from support.carried import (
    NEST,
    X_LN,
    carried_cell,
    commanded,
    from_plate,
    to_plate,
    to_room,
    tool_poses,
)
from support.cells import chain_of
from support.motion import PUMA, START, planned, planned_stretch

ON_PATH = 1e-6  # [m], what is asked of a commanded path in the frame of the positioner
EVENLY = 1e-9  # [rad | m]; the path of the joints is a spline through samples, whose differences round
EXACT = 1e-12  # [rad | m]
HELD = 1.0 + 1e-9  # of a limit, as for all motions
SEEDS = range(4)


@cache
def chain(seed: int) -> MotionChain:
    return chain_of(carried_cell(seed=seed))


def ends(seed: int) -> tuple[Array, Array]:
    """Return start and goal: an arm that moves a little while track and plate take a long way."""
    rng = np.random.default_rng(seed)
    start = np.array([*START, *rng.uniform(-0.2, 0.2, 3)])
    goal = start + np.array([*rng.uniform(-0.2, 0.2, 6), *rng.uniform(-0.5, 0.5, 3)])
    return start, goal


def robot_of(seed: int) -> RobotModel:
    return chain(seed).robot


def line_error(points: Array, first: Array, last: Array) -> float:
    """Return the largest distance of points (k, 3) from the segment between two [m]."""
    way = last - first
    shares = np.clip((points - first) @ way / (way @ way), 0.0, 1.0)
    return float(np.linalg.norm(points - first - shares[:, None] * way, axis=1).max())


def turned_by(X: Array, first: Array) -> Array:
    """Return by which angle orientations (k, 4, 4) are turned from the first one [rad], shape (k,)."""
    R = np.swapaxes(first[:3, :3], 0, 1) @ X[:, :3, :3]
    vectors = np.stack((R[:, 2, 1] - R[:, 1, 2], R[:, 0, 2] - R[:, 2, 0], R[:, 1, 0] - R[:, 0, 1]), axis=1)
    return np.asarray(np.arctan2(np.linalg.norm(vectors, axis=1), np.trace(R, axis1=1, axis2=2) - 1.0))


def shares_of(points: Array) -> Array:
    """Return which share of the way from the first to the last point lies behind each (k, 3), shape (k,)."""
    way = points[-1] - points[0]
    return np.asarray((points - points[0]) @ way / (way @ way))


def plan_of(seed: int, move: MoveInstruction, start: Array) -> MotionPlan:
    return planned(move, start, chain(seed))


@pytest.mark.parametrize("seed", SEEDS)
def test_a_line_in_a_frame_on_the_plate_is_straight_there(seed: int) -> None:
    start, goal = ends(seed)
    robot = robot_of(seed)
    Q = commanded(plan_of(seed, to_plate(robot, goal), start))
    X = from_plate(robot, Q)
    whole = from_plate(robot, np.stack((start, goal)))
    assert line_error(X[:, :3, 3], whole[0, :3, 3], whole[1, :3, 3]) < ON_PATH
    in_base = tool_poses(robot, Q)[:, :3, 3]
    assert line_error(in_base, in_base[0], in_base[-1]) > 1e3 * ON_PATH
    np.testing.assert_allclose(X[-1], whole[1], rtol=0, atol=1e-9)
    np.testing.assert_allclose(Q[-1, 6:], goal[6:], rtol=0, atol=EXACT)


@pytest.mark.parametrize("seed", SEEDS)
def test_an_arm_without_closed_form_follows_the_plate_as_well(seed: int) -> None:
    """Its last two axes stand askew; the path is looked at between the samples, too."""
    askew = Pose(np.array([0.02, 0.03, 0.0]), np.array([1.0, 0.05, 0.03, -0.02]))
    bent = (replace(joint, placement=joint.placement @ askew) for joint in PUMA.joints[4:])
    cell = carried_cell(replace(PUMA, name="bent", joints=(*PUMA.joints[:4], *bent)), seed)
    robot = cell.first.robot
    assert solver_of(robot).method is Method.ALGEBRAIC
    start, goal = ends(seed)
    leg = planned_move_of(chain_of(cell), to_plate(robot, goal), start)
    assert isinstance(leg, PlannedMove)
    assert leg.joints is not None
    Q = leg.joints.joints(np.linspace(0.0, leg.joints.length, 501)).q
    X, whole = from_plate(robot, Q), from_plate(robot, np.stack((start, goal)))
    assert line_error(X[:, :3, 3], whole[0, :3, 3], whole[1, :3, 3]) < ON_PATH
    np.testing.assert_allclose(X[-1], whole[1], rtol=0, atol=1e-8)


@pytest.mark.parametrize("seed", SEEDS)
def test_axes_and_tool_go_evenly_with_the_place(seed: int) -> None:
    """Track, both axes of the positioner, way and turn of the tool have the same share behind them."""
    start, goal = ends(seed)
    robot = robot_of(seed)
    Q = commanded(plan_of(seed, to_plate(robot, goal), start))
    X = from_plate(robot, Q)
    shares = shares_of(X[:, :3, 3])
    assert np.abs(start[6:] + shares[:, None] * (goal - start)[6:] - Q[:, 6:]).max() < 1e-7
    turned = turned_by(X, X[0])
    assert np.abs(turned - shares * turned[-1]).max() < 1e-7


@pytest.mark.parametrize("seed", SEEDS)
def test_a_line_in_the_room_is_straight_there_while_the_track_goes_along(seed: int) -> None:
    start, goal = ends(seed)
    robot = robot_of(seed)
    Q = commanded(plan_of(seed, to_room(robot, goal), start))
    positions = tool_poses(robot, Q)[:, :3, 3]
    target = tool_poses(robot, goal[None])[0, :3, 3]
    assert line_error(positions, positions[0], target) < ON_PATH
    shares = shares_of(positions)
    assert np.abs(start[6:] + shares[:, None] * (goal - start)[6:] - Q[:, 6:]).max() < 1e-7


@pytest.mark.parametrize("seed", SEEDS)
def test_all_limits_hold_on_the_way_those_of_the_external_axes_too(seed: int) -> None:
    start, goal = ends(seed)
    robot = robot_of(seed)
    goal[7:] = start[7:] + 3.0 * (goal - start)[7:]
    result = plan_move(chain(seed), to_plate(robot, goal), start)
    if isinstance(result, Refusal):
        assert {one.code for one in result.diagnostics} <= {"M501", "M503", "M505"}
        return
    assert (np.abs(result.reference.qd) <= HELD * robot.max_speeds).all()
    assert (np.abs(result.reference.qdd) <= HELD * robot.max_accelerations).all()


def test_the_fastest_axis_sets_the_time_where_the_tool_has_next_to_no_way() -> None:
    """A turn of the plate by 0.4 rad with 2 mm of way lasts as long as the axis by itself."""
    start, _ = ends(0)
    robot = robot_of(0)
    goal = start.copy()
    goal[8] += 0.4
    target = Pose.from_matrix(from_plate(robot, start[None])[0])
    moved = replace(target, position=target.position + np.array([0.002, 0.0, 0.0]))
    move = replace(to_plate(robot, goal), target=moved)
    alone = replace(
        to_plate(robot, goal), target=(*start[:6].tolist(), *goal[6:].tolist()), kind=MotionKind.PTP
    )
    both, one = plan_of(0, move, start), plan_of(0, alone, start)
    assert np.abs(both.reference.qd[:, 8]).max() > 0.5 * np.abs(one.reference.qd[:, 8]).max()
    assert one.duration <= both.duration < 2.0 * one.duration


def test_a_tool_that_stands_on_the_plate_goes_with_it() -> None:
    start, _ = ends(1)
    robot = robot_of(1)
    goal = start.copy()
    goal[6:] += [0.2, 0.1, -0.6]
    here = Pose.from_matrix(from_plate(robot, start[None])[0])
    Q = commanded(plan_of(1, replace(to_plate(robot, goal), target=here), start))
    X = from_plate(robot, Q)
    assert np.abs(X - X[0]).max() < ON_PATH
    np.testing.assert_allclose(Q[-1, 6:], goal[6:], rtol=0, atol=EXACT)


def test_a_tool_that_stands_in_the_room_lets_the_carriage_go_below() -> None:
    start, _ = ends(1)
    robot = robot_of(1)
    goal = start.copy()
    goal[6] += 0.3
    here = Pose.from_matrix(tool_poses(robot, start[None])[0])
    Q = commanded(plan_of(1, replace(to_room(robot, goal), target=here), start))
    X = tool_poses(robot, Q)
    assert np.abs(X - X[0]).max() < ON_PATH
    assert Q[-1, 6] == pytest.approx(goal[6], abs=EXACT)


@pytest.mark.parametrize("seed", SEEDS)
def test_an_arc_on_the_turning_plate_is_one_there(seed: int) -> None:
    """Radius and plane are those of the circle through the three points on the plate."""
    start, _ = ends(seed)
    robot = robot_of(seed)
    goal = start + np.array([*6 * [0.0], 0.1, 0.05, 0.2])
    first = Pose.from_matrix(from_plate(robot, start[None])[0])
    via, last = (
        replace(first, position=first.position + np.array(step))
        for step in ((0.05, 0.04, 0.01), (0.1, 0.0, 0.0))
    )
    move = replace(to_plate(robot, goal, MotionKind.CIRC), via=(via,), target=last)
    points = from_plate(robot, commanded(plan_of(seed, move, start)))[:, :3, 3]
    a, b, c = (one.position for one in (first, via, last))
    normal = np.cross(b - a, c - a)
    normal /= np.linalg.norm(normal)
    rows = np.stack((b - a, c - a, normal))
    centre = np.linalg.solve(rows, [(b @ b - a @ a) / 2.0, (c @ c - a @ a) / 2.0, normal @ a])
    assert np.abs(np.linalg.norm(points - centre, axis=1) - np.linalg.norm(a - centre)).max() < ON_PATH
    assert np.abs((points - a) @ normal).max() < ON_PATH


def test_a_curve_on_the_turning_plate_passes_its_points_there() -> None:
    start, goal = ends(2)
    robot = robot_of(2)
    first = Pose.from_matrix(from_plate(robot, start[None])[0])
    steps = ((0.03, 0.03, 0.0), (0.06, -0.01, 0.02), (0.1, 0.0, 0.0))
    one, two, last = (replace(first, position=first.position + np.array(step)) for step in steps)
    move = replace(to_plate(robot, goal, MotionKind.SPLINE), via=(one, two), target=last)
    points = from_plate(robot, commanded(plan_of(2, move, start)))[:, :3, 3]
    for through in (one, two):
        assert line_error(through.position[None], *_beside(points, through.position)) < 1e-6


def _beside(points: Array, place: Array) -> tuple[Array, Array]:
    """Return the two points (3,) of a way (k, 3) between which a place is passed."""
    row = int(np.argmin(np.linalg.norm(points - place, axis=1)))
    near = min(max(row, 1), len(points) - 2)
    after = np.linalg.norm(points[near + 1] - place) < np.linalg.norm(points[near - 1] - place)
    return (points[near], points[near + 1]) if after else (points[near - 1], points[near])


def with_zone(move: MoveInstruction, zone: float) -> MoveInstruction:
    return replace(move, modal=replace(move.modal, zone=zone))


def smooth(Q: Array, period: float, limits: Array) -> None:
    """Assert that speeds from tick to tick change by no more than the accelerations allow (k, n)."""
    speeds = np.diff(Q, axis=0) / period
    assert (np.abs(np.diff(speeds, axis=0)) <= 1.01 * limits * period + 1e-9).all()


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("frames", ["one", "two", "first stands", "second stands"])
def test_a_corner_between_coordinated_lines_is_rounded_in_the_frame(seed: int, frames: str) -> None:
    """On both lines outside the zone, within the zone beside the corner; all axes go on."""
    start, middle = ends(seed)
    robot = robot_of(seed)
    goal = middle + np.array([0.1, 0.2, -0.2, 0.0, 0.1, 0.0, -0.1, 0.2, 0.2])
    if frames == "first stands":
        middle[6:] = start[6:]
    if frames == "second stands":
        goal[6:] = middle[6:]
    zone = 0.03
    last = to_plate(robot, goal)
    if frames == "two":
        last = replace(last, modal=NEST, target=Pose.from_matrix(from_plate(robot, goal[None], X_LN)[0]))
    plan = planned_stretch([with_zone(to_plate(robot, middle), zone), last], start, chain(seed))
    first = plan.moves[0]
    assert first.zone == pytest.approx(zone, rel=1e-6)
    Q = commanded(plan)
    points = from_plate(robot, Q)[:, :3, 3]
    a, b, c = from_plate(robot, np.stack((start, middle, goal)))[:, :3, 3]
    outside = np.linalg.norm(points - b, axis=1) > zone
    ticks = np.arange(len(points))
    assert line_error(points[outside & (ticks < first.last)], a, b) < ON_PATH
    assert line_error(points[outside & (ticks > first.last)], b, c) < ON_PATH
    assert np.linalg.norm(points - b, axis=1).min() > 1e-3 * zone
    speeds = np.linalg.norm(np.diff(points, axis=0), axis=1)
    assert speeds[first.last] > 0.02 * speeds.max()
    smooth(Q, plan.period, robot.max_accelerations)
    np.testing.assert_allclose(Q[-1, 6:], goal[6:], rtol=0, atol=EXACT)


@pytest.mark.parametrize("seed", SEEDS)
def test_lines_in_the_room_are_joined_while_the_track_goes_on(seed: int) -> None:
    start, middle = ends(seed)
    robot = robot_of(seed)
    goal = middle + np.array([0.15, -0.1, 0.1, 0.0, 0.1, 0.0, 0.2, 0.0, 0.0])
    plan = planned_stretch(
        [with_zone(to_room(robot, middle), 0.05), to_room(robot, goal)], start, chain(seed)
    )
    assert plan.moves[0].zone == pytest.approx(0.05, rel=1e-6)
    Q = commanded(plan)
    points = tool_poses(robot, Q)[:, :3, 3]
    a, b, c = tool_poses(robot, np.stack((start, middle, goal)))[:, :3, 3]
    outside, ticks = np.linalg.norm(points - b, axis=1) > 0.05, np.arange(len(points))
    assert line_error(points[outside & (ticks < plan.moves[0].last)], a, b) < ON_PATH
    assert line_error(points[outside & (ticks > plan.moves[0].last)], b, c) < ON_PATH
    smooth(Q, plan.period, robot.max_accelerations)


@pytest.mark.parametrize("seed", SEEDS)
def test_motions_without_a_common_frame_overlap(seed: int) -> None:
    """From the room, with the track, to the plate, which turns."""
    start, middle = ends(seed)
    robot = robot_of(seed)
    middle[7:] = start[7:]
    goal = middle + np.array([0.15, -0.1, 0.1, 0.0, 0.1, 0.0, 0.2, 0.1, 0.3])
    plan = planned_stretch(
        [with_zone(to_room(robot, middle), 0.02), to_plate(robot, goal)], start, chain(seed)
    )
    Q = commanded(plan)
    assert 0.0 < plan.moves[0].zone <= 0.02 * (1.0 + 1e-6)
    smooth(Q, plan.period, 2.0 * robot.max_accelerations)
    np.testing.assert_allclose(Q[-1, 6:], goal[6:], rtol=0, atol=EXACT)


@pytest.mark.parametrize("seed", SEEDS)
def test_all_axes_of_joint_moves_are_synchronous_and_overlap_with_the_next_one(seed: int) -> None:
    """Outside the zone every axis has the same share of its way behind it; none stands at the corner."""
    start, middle = ends(seed)
    robot = robot_of(seed)
    goal = middle + np.array([0.3, -0.2, 0.2, 0.2, 0.3, 0.4, 0.4, 0.3, 0.6])
    first, last = (to_room(robot, one, MotionKind.PTP) for one in (middle, goal))
    plan = planned_stretch([with_zone(first, 0.03), last], start, chain(seed))
    Q = commanded(plan)
    points = tool_poses(robot, Q)[:, :3, 3]
    corner = tool_poses(robot, middle[None])[0, :3, 3]
    outside, ticks = np.linalg.norm(points - corner, axis=1) > 0.03, np.arange(len(Q))
    for begin, end, part in (
        (start, plan.moves[0].q_end, outside & (ticks < plan.moves[0].last)),
        (plan.moves[0].q_end, plan.q_end, outside & (ticks > plan.moves[0].last)),
    ):
        shares = (Q[part] - begin) / (end - begin)
        assert part.sum() > 10
        assert np.abs(shares - shares[:, 6:7]).max() < EVENLY
    at_corner = np.abs(plan.reference.qd[plan.moves[0].last])
    assert (at_corner[6:] > 1e-3).any()


def test_a_distance_on_the_way_counts_on_the_plate() -> None:
    start, goal = ends(3)
    robot = robot_of(3)
    trigger = Trigger("glue", 1.0, Side.AFTER_START, distance=0.03)
    plan = plan_of(3, replace(to_plate(robot, goal), triggers=(trigger,)), start)
    points = from_plate(robot, commanded(plan))[:, :3, 3]
    way = np.linalg.norm(points - points[0], axis=1)
    (set_,) = plan.moves[0].triggers
    assert way[set_.tick - 1] < 0.03 <= way[set_.tick] + 1e-9


def test_a_line_that_leaves_the_reach_tells_where_the_axes_are_there() -> None:
    """The plate takes the tool once round its axis, and the arm does not get behind it."""
    start, _ = ends(2)
    robot = robot_of(2)
    goal = start.copy()
    goal[8] += 0.05 - 2.0 * np.pi
    here = Pose.from_matrix(from_plate(robot, start[None])[0])
    beside = replace(here, position=here.position + np.array([0.01, 0.0, 0.0]))
    result = plan_move(chain(2), replace(to_plate(robot, goal), target=beside), start)
    assert isinstance(result, Refusal)
    (found,) = result.diagnostics
    assert found.code == "M501"
    share = found.data["share"]
    assert isinstance(share, float)
    there = np.degrees(start[8] + share * (goal - start)[8])
    assert found.notes[-1].endswith(f"E3 = {there:.6g}°")


def test_an_axis_that_does_not_move_the_frame_leaves_the_path_in_the_room() -> None:
    """The track moves, the plate stands: one path, whether it is given on the plate or in the room."""
    start, goal = ends(5)
    robot = robot_of(5)
    goal[7:] = start[7:]
    one, other = (commanded(plan_of(5, make(robot, goal), start)) for make in (to_plate, to_room))
    np.testing.assert_allclose(one, other, rtol=0, atol=1e-9)
    assert plan_of(5, to_plate(robot, goal), start).path_segments[0].frame is None
