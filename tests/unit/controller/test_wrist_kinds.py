"""Lines, arcs and curves that the wrist leads: the way of the TCP, the joints of the wrist, singularities."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from ropsim.flow import MotionKind, MoveInstruction
from ropsim.kinematics import jacobian_at, posture, singular_distances
from ropsim.model import OrientationMode, PathDefaults, Payload
from ropsim.motion import Curve, JointPath
from ropsim.planning.testing import PlannedMove, WristPath, planned_move_of
from ropsim.spatial import Array, Pose
from support.cells import chain_of, with_station
from support.motion import CELL, LINE, PUMA, START, interface_pose, lin, planned, references, refused, shifted
from support.walks import shares
from support.wrist_angles import (
    CHAINS,
    LEADING,
    TORCH,
    X_MT,
    led,
    move_through,
    moves_from,
    torch_at,
    torch_places,
)

KINDS = MotionKind.LIN, MotionKind.CIRC, MotionKind.SPLINE
SEEDS = range(4)
ON_PATH = 1e-6  # [m], what is asked of a commanded path
AS_TOLD = 1e-7  # [rad]; the path of the joints goes through samples, to 5e-8 between them
AT_POSE = 1e-7  # of poses at joints that are true to that
QUICK = PathDefaults(3.0, 50.0, 1e3, 20.0, 500.0, 1e4)
FAST = chain_of(with_station(CELL, controller=replace(LEADING.controller, path=QUICK)))
DIFFERENCES = 1e-3  # of derivatives by differences over a control tick
HELD = 1.0 + 1e-9  # of a limit, as for all motions


def drawn(kind: MotionKind, seed: int) -> tuple[Array, MoveInstruction, list[Array]]:
    """Return a start, a move and the joint coordinates at the points of the move."""
    random = np.random.default_rng(seed)
    q_start = START + random.uniform(-0.2, 0.2, 6)
    return q_start, *moves_from(q_start, random)[kind]


def knots(leg: PlannedMove) -> Array:
    """Return the places of the points of a move, shape (k,)."""
    assert isinstance(leg.tool, WristPath)
    way = leg.tool.path
    return way.knots if isinstance(way, Curve) else np.array([0.0, way.length])


def whirls(joints: JointPath, places: Array) -> float:
    """Return how far joints of the wrist turn back between two places each, at most [rad]."""
    worst = 0.0
    for begin, end in pairwise(places.tolist()):
        wrist = joints.joints(np.linspace(begin, end, 201)).q[:, 3:]
        back = np.abs(np.diff(wrist, axis=0)).sum(axis=0) - np.abs(wrist[-1] - wrist[0])
        worst = max(worst, float(back.max()))
    return worst


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("kind", KINDS)
def test_the_tcp_stays_on_its_path_at_every_control_tick(kind: MotionKind, seed: int) -> None:
    q_start, move, _ = drawn(kind, seed)
    fixed = planned_move_of(CHAINS[OrientationMode.FIXED_AXIS], move, q_start)
    assert isinstance(fixed, PlannedMove)
    assert fixed.tool is not None
    done = planned(move, q_start, LEADING)
    assert fixed.tool.distance(torch_places(done.reference.q)).max() <= ON_PATH
    assert np.abs(torch_at(done.q_end).matrix() - torch_at_goal(move)).max() <= AT_POSE


def torch_at_goal(move: MoveInstruction) -> Array:
    assert not isinstance(move.target, tuple)
    assert move.target is not None
    return move.target.matrix()


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("kind", KINDS)
def test_joints_of_the_wrist_turn_back_at_points_only(kind: MotionKind, seed: int) -> None:
    q_start, move, _ = drawn(kind, seed)
    leg = led(move, q_start)
    assert leg.joints is not None
    assert whirls(leg.joints, knots(leg)) <= AS_TOLD


@pytest.mark.parametrize("seed", SEEDS)
def test_a_curve_has_the_poses_of_its_points_and_the_posture_of_its_start(seed: int) -> None:
    q_start, move, points = drawn(MotionKind.SPLINE, seed)
    leg = led(move, q_start)
    assert leg.joints is not None
    at = leg.joints.joints(knots(leg)).q
    assert at == pytest.approx(np.vstack((q_start, *points)), abs=AS_TOLD)
    for q, X_BT in zip(at[1:], (*move.via, move.target), strict=True):
        assert isinstance(X_BT, Pose)
        assert np.abs(torch_at(q).matrix() - X_BT.matrix()).max() <= AT_POSE
        assert posture(PUMA, q).words[:2] == posture(PUMA, q_start).words[:2]


@pytest.mark.parametrize("seed", SEEDS)
def test_joints_of_a_curve_are_twice_continuously_differentiable_over_its_points(seed: int) -> None:
    """What is left of a step in the second derivative goes with the distance at which it is looked for."""
    q_start, move, _ = drawn(MotionKind.SPLINE, seed)
    leg = led(move, q_start)
    assert leg.joints is not None
    inner = knots(leg)[1:-1]
    steps = []
    for beside in (1e-3, 1e-4, 1e-5):
        before, behind = (
            leg.joints.joints(inner + side * beside * leg.joints.length) for side in (-1.0, 1.0)
        )
        steps.append(np.abs(behind.d2 - before.d2).max() * leg.joints.length**2)
    assert steps[1] < 0.2 * steps[0]
    assert steps[2] < 0.2 * steps[1]


def through(kind: MotionKind) -> tuple[Array, MoveInstruction]:
    """Return a start and a move whose wrist passes its singularity on the way; a curve once at a point."""
    q_start = np.array([0.2, 1.1, -2.9, 0.7, -0.4, 0.3])
    wrist = {MotionKind.LIN: [0.4], MotionKind.CIRC: [-0.1, 0.4], MotionKind.SPLINE: [-0.2, 0.0, 0.15, 0.4]}
    points = []
    for share, bend in zip(np.linspace(0.0, 1.0, len(wrist[kind]) + 1)[1:], wrist[kind], strict=True):
        beside = 0.03 * np.sin(np.pi * share)
        points.append(
            q_start + np.array([0.2 * share, beside - 0.1 * share, 0.2 * share, 0.0, bend + 0.4, 0.0])
        )
    return q_start, move_through(kind, points, replace(TORCH, path_speed=0.1))


@pytest.mark.parametrize("kind", KINDS)
def test_the_singularity_of_the_wrist_is_passed_at_full_speed(kind: MotionKind) -> None:
    q_start, move = through(kind)
    done = planned(move, q_start, LEADING)
    assert done.findings == ()  # not slowed
    q, qd, _ = references(done)
    crossing = int(np.argmin(np.abs(q[:, 4])))
    assert q[0, 4] < 0.0 < q[-1, 4]
    found = singular_distances(PUMA, q[crossing])
    assert found is not None
    assert found.wrist <= abs(qd[crossing, 4]) * done.period
    rows = zip(q, qd, strict=True)
    speeds = np.array([np.linalg.norm((jacobian_at(PUMA, here, X_MT) @ rate)[:3]) for here, rate in rows])
    assert speeds[crossing] == pytest.approx(0.1, rel=1e-6)
    leg = led(move, q_start)
    assert leg.tool is not None
    assert leg.tool.distance(torch_places(q)).max() <= ON_PATH
    assert np.abs(q[:, 3] - 0.7).max() < 1e-6  # it does not turn over
    assert (np.diff(q[:, 4]) >= -1e-9).all()


@pytest.mark.parametrize("kind", [MotionKind.LIN, MotionKind.CIRC])
def test_with_a_fixed_axis_the_same_way_is_slowed_or_refused(kind: MotionKind) -> None:
    q_start, move = through(kind)
    found = planned_move_of(CHAINS[OrientationMode.FIXED_AXIS], move, q_start)
    if isinstance(found, PlannedMove):
        slow = planned(move, q_start, CHAINS[OrientationMode.FIXED_AXIS]).duration
        assert slow > 1.2 * planned(move, q_start, LEADING).duration
    else:
        assert found.diagnostics[0].code in {"M503", "M505"}


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("kind", KINDS)
def test_limits_hold_at_full_speed(kind: MotionKind, seed: int) -> None:
    q_start, move, _ = drawn(kind, seed)
    done = planned(move, q_start, FAST)
    asked = shares(PUMA, done, Payload())
    assert max(asked.values()) <= HELD
    assert max(asked.values()) > 0.9  # and one of them is reached


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("kind", [MotionKind.LIN, MotionKind.CIRC])
def test_limits_of_the_tool_hold_and_one_of_them_sets_the_time(kind: MotionKind, seed: int) -> None:
    q_start, move, _ = drawn(kind, seed)
    done, limits = planned(move, q_start, LEADING), LEADING.controller.path
    q, qd, _ = references(done)
    rates = np.array([jacobian_at(PUMA, here, X_MT) @ rate for here, rate in zip(q, qd, strict=True)])
    speeds = np.linalg.norm(rates.reshape(-1, 2, 3), axis=2)
    accelerations = np.linalg.norm(np.diff(rates, axis=0).reshape(-1, 2, 3), axis=2) / done.period
    speed = speeds.max(axis=0) / (limits.speed, limits.orientation_speed)
    acceleration = accelerations.max(axis=0) / (limits.acceleration, limits.orientation_acceleration)
    used = max(*speed.tolist(), *acceleration.tolist())
    assert 0.75 <= used <= 1.0 + DIFFERENCES


def test_the_orientation_between_points_follows_from_the_arm() -> None:
    q_start, move, _ = drawn(MotionKind.SPLINE, 1)
    leg = led(move, q_start)
    assert leg.tool is not None
    assert leg.joints is not None
    s = np.linspace(0.0, leg.tool.length, 23)
    points, at = leg.tool.tool(s), leg.joints.joints(s)
    h = 1e-6 * leg.tool.length
    ahead, back = (leg.tool.tool(np.clip(s + side, 0.0, leg.tool.length)).d1 for side in (h, -h))
    for k in range(len(s)):
        assert points.matrices[k] == pytest.approx((interface_pose(at.q[k]) @ X_MT).matrix(), abs=AT_POSE)
        assert points.d1[k] == pytest.approx(jacobian_at(PUMA, at.q[k], X_MT) @ at.d1[k], abs=1e-5)
    bends = (ahead - back)[1:-1] / (2.0 * h)
    assert points.d2[1:-1] == pytest.approx(bends, abs=1e-4 * np.abs(bends).max())


def test_a_point_of_a_curve_that_the_elbow_does_not_reach_as_it_is_is_told_with_its_place() -> None:
    up = np.array([0.26, 0.12, -1.81, 0.3, -0.83, 0.2])
    down = np.array([2.07, 0.98, -0.55, -1.06, 1.21, 3.95])  # elbow down only
    found = refused(move_through(MotionKind.SPLINE, [down, up + 0.1]), up, LEADING)
    assert (found.code, found.span) == ("M586", LINE)
    x, y, z = (1e3 * torch_at(down).position).tolist()
    assert f"({x:.1f}, {y:.1f}, {z:.1f}) mm in the base frame, is not reached" in found.message
    assert "its point at " in found.message
    assert found.message.endswith(": joint `5` would be at -100.3°, its limit is -100.0°")


@pytest.mark.parametrize("way", [(0.06, 0.0, 0.0), (0.0, 0.06, 0.0), (0.03, 0.2, -0.1)])
def test_a_line_that_keeps_its_orientation_takes_one_time_in_all_modes(way: tuple[float, ...]) -> None:
    move = lin(shifted(torch_at(START), *way), TORCH)
    times = [planned(move, START, chain).duration for chain in CHAINS.values()]
    assert max(times) <= 1.01 * min(times)


@pytest.mark.parametrize("kind", KINDS)
def test_a_move_to_joint_coordinates_ends_in_them(kind: MotionKind) -> None:
    q_start, move, points = drawn(kind, 0)
    wanted = points[-1] + np.array(
        [0.0, 0.0, 0.0, np.pi, -2.0 * points[-1][4], np.pi]
    )  # the wrist turned over
    assert np.abs(torch_at(wanted).matrix() - torch_at_goal(move)).max() <= AT_POSE
    done = planned(replace(move, target=tuple(wanted.tolist())), q_start, LEADING)
    assert done.q_end == pytest.approx(wanted, abs=1e-12)
    assert done.findings == ()
