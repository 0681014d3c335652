"""Moves to targets with free orientation: the TCP on its line, one branch, corners, distances, kept turns."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import least_squares

from ropsim import robots
from ropsim.flow import ModalState, MotionKind, MoveInstruction, Origin
from ropsim.kinematics import point_answers, tool_pose
from ropsim.model import RobotModel, on_track
from ropsim.motion import SampledPath
from ropsim.planning import MotionChain, MotionState, Refusal, plan, plan_move
from ropsim.planning.testing import last_request, planned_move_of, without_request
from ropsim.spatial import Array, Pose
from support.carried import carried_cell, from_plate, to_plate
from support.cells import chain_of
from support.few_axes import (
    ARMS,
    DETERMINED,
    FREE,
    TOOL,
    beside_line,
    chain_for,
    drawn,
    places,
    to_point,
    two_link,
)
from support.motion import FINE, LINE, PUMA, START, lin, planned, planned_stretch, ptp, refused

ON_LINE = 1e-9
"""Largest distance of a TCP from its line [m]."""
LIN, PTP = MotionKind.LIN, MotionKind.PTP


def chained(name: str) -> MotionChain:
    """Return the entities for an arm of `ARMS`."""
    return chain_for(ARMS[name])


def sides(robot: RobotModel, Q: Array) -> Array:
    """Return the sign of the determinant of the position Jacobian in the plane or space of the TCP, (k,)."""
    h, found = 1e-6, []
    for q in Q:
        J = np.array(
            [places(robot, q + h * one)[0] - places(robot, q - h * one)[0] for one in np.eye(robot.n)]
        )
        if robot.n == 2:
            normal = np.cross(*(places(robot, q + one)[0] - places(robot, q)[0] for one in np.eye(2)))
            J = np.vstack((J, normal * 0.0 + _NORMALS.setdefault(robot.name + str(robot.n), normal)))
        found.append(np.sign(np.linalg.det(J)))
    return np.array(found)


_NORMALS: dict[str, Array] = {}


@pytest.mark.parametrize("name", ARMS)
def test_random_lines_keep_to_the_line_and_end_at_their_targets(name: str) -> None:
    """What is refused is out of reach or beyond a limit, by an independent search on the same branch."""
    robot, chain, rng, made = ARMS[name], chained(name), np.random.default_rng(11), 0
    for _ in range(12):
        q = drawn(robot, rng)
        step = 0.05 * rng.normal(size=robot.n) * np.minimum(robot.upper_limits - robot.lower_limits, 4.0)
        begin, end = places(robot, q)[0], places(robot, q + step)[0]
        found = plan_move(chain, to_point(LIN, end), q)
        if isinstance(found, Refusal):
            codes = {one.code for one in found.diagnostics}
            assert codes <= {"M501", "M502", "M503", "M505", "M530"}
            if name in DETERMINED:
                assert not _followed_by_scipy(robot, q, begin, end)
            continue
        made += 1
        reached = places(robot, found.reference.q)
        assert beside_line(reached, begin, end).max() < ON_LINE
        assert np.abs(reached[-1] - end).max() < ON_LINE
        low, high = robot.lower_limits, robot.upper_limits
        assert ((found.reference.q >= low - 1e-9) & (found.reference.q <= high + 1e-9)).all()
    assert made >= 4


def _followed_by_scipy(robot: RobotModel, q: Array, begin: Array, end: Array) -> bool:
    """Return whether least squares from place to place keep to limits and line, without a jump."""
    for share in np.linspace(0.0, 1.0, 201):
        point = begin + share * (end - begin)
        found = least_squares(
            lambda x, point=point: places(robot, x)[0] - point, q, xtol=1e-14, ftol=1e-14, gtol=1e-14
        )
        inside = (found.x >= robot.lower_limits - 1e-9) & (found.x <= robot.upper_limits + 1e-9)
        if np.linalg.norm(found.fun) > 1e-7 or not inside.all() or np.abs(found.x - q).max() > 0.3:
            return False
        q = found.x
    return True


@pytest.mark.parametrize("name", DETERMINED)
def test_the_branch_of_the_start_is_kept(name: str) -> None:
    robot, chain, rng, made = ARMS[name], chained(name), np.random.default_rng(12), 0
    for _ in range(8):
        q = drawn(robot, rng)
        end = places(robot, q + 0.15 * rng.normal(size=robot.n))[0]
        found = plan_move(chain, to_point(LIN, end), q)
        if not isinstance(found, Refusal):
            made += 1
            signs = sides(robot, np.vstack((q, found.reference.q[::20])))
            assert (signs == signs[0]).all()
    assert made >= 3


@pytest.mark.parametrize("share", [0.9, 0.99, 0.999, 0.9999])
@pytest.mark.parametrize("elbow", [-1.0, 1.0])
def test_a_line_next_to_the_stretched_arm_keeps_its_elbow(share: float, elbow: float) -> None:
    """Straight up past the place nearest to the reach, where the elbow is bent by few degrees only."""
    robot = two_link()
    tip = np.hypot(1.1 + 0.3, 0.1)  # the tool lengthens the second link
    reach, shoulder = 1.2 + tip, np.array([0.0, 0.05, 1.0])
    shoulder[1] = places(robot, np.zeros(2))[0, 1]
    x = share * reach
    half = 0.3 * np.sqrt(reach**2 - x**2)
    begin, end = (shoulder + np.array([x, 0.0, z]) for z in (-half, half))
    q = _answer(robot, begin, elbow)
    found = plan_move(chain_for(robot), to_point(LIN, end), q)
    assert not isinstance(found, Refusal), found
    reached = places(robot, found.reference.q)
    assert beside_line(reached, begin, end).max() < ON_LINE
    assert np.abs(reached[-1] - end).max() < ON_LINE
    bent = np.sin(found.reference.q[:, 1] + np.arctan2(-0.1, 1.4))
    assert (np.sign(bent) == np.sign(bent[0])).all()


def _answer(robot: RobotModel, point: Array, elbow: float) -> Array:
    """Return the answer whose second joint is the greater or the less one."""
    answers = point_answers(robot, TOOL, point, np.zeros(robot.n))
    return np.asarray(max(answers.branches, key=lambda q: elbow * q[1]))


def test_a_line_through_the_stretched_arm_is_refused_with_its_distance() -> None:
    robot = two_link()
    q = np.array([0.3, -0.4])
    begin = places(robot, q)[0]
    far = begin + np.array([0.5, 0.0, 0.0])
    found = refused(to_point(LIN, far), q, chain_for(robot))
    assert found.code == "M501"
    reach = 1.2 + np.hypot(1.4, 0.1)
    away = np.linalg.norm(far - np.array([0.0, far[1], 1.0])) - reach
    assert found.data["distance_m"] == pytest.approx(away, abs=1e-9)
    assert f"{away * 1e3:.2f} mm beyond the reach" in found.message


@pytest.mark.parametrize("kind", [LIN, PTP])
def test_a_target_beside_the_plane_is_refused_with_its_distance(kind: MotionKind) -> None:
    robot, q = two_link(), np.array([0.7, -1.2])
    point = places(robot, q + 0.1)[0] + np.array([0.0, 3.2e-3, 0.0])
    found = refused(to_point(kind, point), q, chain_for(robot))
    assert found.code == "M530"
    assert "3.20 mm beside the plane of the arm" in found.message
    assert found.data["beside_m"] == pytest.approx(3.2e-3)


def test_a_line_stops_being_made_at_a_joint_limit_and_says_which() -> None:
    robot, q = two_link(), np.array([2.6, 1.2])
    begin = places(robot, q)[0]
    end = places(robot, np.array([3.0, 1.2]))[0]
    found = refused(to_point(LIN, end), q, chain_for(robot))
    assert found.code in {"M502", "M503"}
    near = begin + 0.3 * (places(robot, np.array([2.9, 1.2]))[0] - begin)
    made = plan_move(chain_for(robot), to_point(LIN, near), q)
    assert not isinstance(made, Refusal)


@pytest.mark.parametrize("name", ["planar 3R", "4 axes", "5 axes"])
def test_few_lines_of_arms_with_joints_to_spare_end_at_a_limit(name: str) -> None:
    """They begin a twentieth of the range away from one; with constant weights a third of them would."""
    robot, chain, rng, at_limit, made = ARMS[name], chained(name), np.random.default_rng(14), 0, 0
    for _ in range(12):
        q = drawn(robot, rng)
        joint = int(rng.integers(robot.n))
        q[joint] = robot.lower_limits[joint] + 0.05 * (robot.upper_limits - robot.lower_limits)[joint]
        found = plan_move(chain, to_point(LIN, places(robot, q + 0.15 * rng.normal(size=robot.n))[0]), q)
        if isinstance(found, Refusal):
            at_limit += found.diagnostics[0].code == "M503"
            continue
        made += 1
        assert robot.lower_limits[joint] - 1e-9 <= found.reference.q[:, joint].min()
    assert at_limit <= 1
    assert made >= 9


@pytest.mark.parametrize("name", ["planar 2R", "anthropomorphic", "SCARA", "5 axes"])
@pytest.mark.parametrize("track", [None, 1.3])
def test_an_arm_on_a_track_follows_lines_of_the_room(name: str, track: float | None) -> None:
    arm = ARMS[name]
    robot, n = on_track(arm, robots.linear_track(4.0)), arm.n
    q = np.append(drawn(arm, np.random.default_rng(3)), 1.0)
    there = q.copy()
    there[:n] += 0.02 * np.minimum(arm.upper_limits - arm.lower_limits, 5.0)
    there[n] = track or 1.0
    begin, end = places(robot, q)[0], places(robot, there)[0]
    move = to_point(LIN, end)
    found = plan_move(chain_for(robot), replace(move, external=(track,)) if track else move, q)
    assert not isinstance(found, Refusal), found
    reached = places(robot, found.reference.q)
    assert beside_line(reached, begin, end).max() < ON_LINE
    assert np.abs(reached[-1] - end).max() < ON_LINE
    assert found.q_end[n] == there[n]


@pytest.mark.parametrize("name", DETERMINED)
def test_a_joint_move_takes_the_nearest_branch(name: str) -> None:
    robot, chain, rng = ARMS[name], chained(name), np.random.default_rng(13)
    for _ in range(6):
        q = drawn(robot, rng)
        near = np.clip(q + 0.05 * rng.normal(size=robot.n), robot.lower_limits, robot.upper_limits)
        found = plan_move(chain, to_point(PTP, places(robot, near)[0]), q)
        assert not isinstance(found, Refusal)
        assert np.abs(found.q_end - near).max() < 1e-6
        assert not found.findings


def test_of_two_branches_the_one_is_taken_from_which_a_later_line_can_be_followed() -> None:
    """The nearest one would lead the elbow beyond its limit on the line behind it."""
    robot = two_link()
    narrow = replace(robot, joints=(robot.joints[0], replace(robot.joints[1], lower=-1.75, upper=2.9)))
    chain, low = chain_for(narrow), np.array([1.9, -1.7])
    begin = places(narrow, low)[0]
    end = places(narrow, np.array([2.2, -2.1]))[0]
    alone = plan_move(chain, to_point(PTP, begin), low + 0.02)
    assert not isinstance(alone, Refusal)
    assert alone.q_end[1] < 0.0
    assert refused(to_point(LIN, end), alone.q_end, chain).code in {"M502", "M503"}
    moves = [to_point(PTP, begin, 0.005), to_point(LIN, end)]
    made = planned_stretch(moves, low + 0.02, chain)
    assert made.reference.q[-1, 1] > 0.0
    assert "M585" in {one.code for one in made.findings}


@pytest.mark.parametrize("words", [(), ("down",)])
def test_the_word_alone_asks_for_no_posture(words: tuple[str, ...]) -> None:
    """Where a later line cannot be followed a posture may be why, a free orientation is not."""
    X = tool_pose(PUMA, START, Pose())
    first = replace(ptp(Pose(X.position + 0.02), FINE), posture=replace(FREE, words=words))
    far = replace(lin(Pose(X.position + np.array([0.0, 0.0, 3.0])), FINE), posture=FREE)
    (only,) = without_request([first], 0)
    assert only.has_free_orientation
    assert not only.asks_for_branch
    assert last_request([first, far]) == (0 if words else None)


def test_a_corner_between_lines_is_passed_without_a_stop() -> None:
    robot, chain = two_link(), chain_for(two_link())
    q = np.array([0.9, -1.7])
    at = places(robot, q)[0]
    corners = [at + np.array(way) for way in ((0.1, 0, 0), (0.1, 0, 0.1), (0, 0, 0.1))]
    moves = [to_point(LIN, one, 0.01) for one in corners[:2]] + [to_point(LIN, corners[2])]
    made = planned_stretch(moves, q, chain)
    reached = places(robot, made.reference.q)
    speeds = np.linalg.norm(np.diff(reached, axis=0), axis=1) / made.period
    middle = speeds[len(speeds) // 10 : -len(speeds) // 10]
    assert middle.min() > 0.02
    away = np.minimum.reduce(
        [beside_line(reached, a, b) for a, b in zip([at, *corners], corners, strict=False)]
    )
    near = np.minimum.reduce([np.linalg.norm(reached - one, axis=1) for one in corners[:2]])
    assert away[near > 0.0101].max() < ON_LINE
    assert away.max() < 0.01


@pytest.mark.parametrize("name", ["planar 3R", "SCARA", "4 axes", "5 axes"])
def test_corners_of_arms_with_joints_to_spare_go_over_smoothly(name: str) -> None:
    robot, chain, rng = ARMS[name], chained(name), np.random.default_rng(21)
    for _ in range(40):
        q = drawn(robot, rng)
        points = [places(robot, q + step)[0] for step in 0.1 * rng.normal(size=(3, robot.n)).cumsum(axis=0)]
        moves = [to_point(LIN, one, 0.01) for one in points[:2]] + [to_point(LIN, points[2])]
        made, refusal = plan(chain, moves, MotionState.at_rest(q))
        if refusal is None and made is not None and len(made.blends) == 2:
            break
    else:
        raise AssertionError("no sequence could be made")
    q_rows = np.vstack((q, made.reference.q))
    qd = np.vstack((np.zeros(robot.n), made.reference.qd))
    steps = np.diff(q_rows, axis=0) - 0.5 * made.period * (qd[1:] + qd[:-1])
    assert np.abs(steps).max() < 1e-4 * made.period * np.abs(qd).max() + 1e-7


@pytest.mark.parametrize("kind", [MotionKind.CIRC, MotionKind.SPLINE])
def test_arcs_and_curves_keep_to_their_path(kind: MotionKind) -> None:
    robot, q = two_link(), np.array([0.9, -1.7])
    at = places(robot, q)[0]
    via, end = at + np.array([0.1, 0.0, 0.1]), at + np.array([0.2, 0.0, 0.0])
    made = plan_move(chain_for(robot), to_point(kind, end, via=(via,)), q)
    assert not isinstance(made, Refusal), made
    reached = places(robot, made.reference.q)
    assert np.abs(reached[-1] - end).max() < ON_LINE
    assert np.linalg.norm(reached - via, axis=1).min() < 1e-3
    assert np.abs(reached[:, 1] - at[1]).max() < ON_LINE
    if kind is MotionKind.CIRC:
        centre = at + np.array([0.1, 0.0, 0.0])
        assert np.abs(np.linalg.norm(reached - centre, axis=1) - 0.1).max() < ON_LINE


@pytest.mark.parametrize("name", ARMS)
def test_the_path_of_the_joints_has_exact_derivatives(name: str) -> None:
    """Between its samples, too, the TCP is on the line and goes along it with speed 1."""
    robot, chain, rng = ARMS[name], chained(name), np.random.default_rng(31)
    q = drawn(robot, rng)
    step = 0.02 * rng.normal(size=robot.n) * np.minimum(robot.upper_limits - robot.lower_limits, 4.0)
    begin, end = places(robot, q)[0], places(robot, q + step)[0]
    made = planned_move_of(chain, to_point(LIN, end), q)
    assert not isinstance(made, Refusal), made
    joints = made.joints
    assert isinstance(joints, SampledPath)
    assert joints.derivatives is not None
    s, h = np.linspace(0.01, 0.99, 57) * joints.length, 1e-6
    at = joints.joints(s)
    assert beside_line(places(robot, at.q), begin, end).max() < ON_LINE
    speed = (places(robot, at.q + h * at.d1) - places(robot, at.q - h * at.d1)) / (2.0 * h)
    assert np.abs(speed - (end - begin) / joints.length).max() < 1e-6


def test_orientation_limits_do_not_bind_what_is_free() -> None:
    robot, q = two_link(), np.array([0.9, -1.7])
    end = places(robot, q)[0] + np.array([0.3, 0.0, 0.2])
    move = to_point(LIN, end)
    slow = replace(move, modal=replace(move.modal, orientation_speed=1e-3, orientation_acceleration=1e-3))
    made = [plan_move(chain_for(robot), one, q) for one in (move, slow)]
    assert not any(isinstance(one, Refusal) for one in made)
    one, other = (len(one.reference.q) for one in made if not isinstance(one, Refusal))
    assert one == other


def test_a_pose_that_the_arm_cannot_keep_on_the_way_names_the_word() -> None:
    """The flange of two links turns by 0.09° beside a turn that is even with the way."""
    robot, q = two_link(), np.array([0.9, -1.7])
    X = tool_pose(robot, q, Pose())
    end = X.position + np.array([0.1, 0.0, 0.0])
    answers = point_answers(robot, Pose(), end, q)
    q_end = min(answers.branches, key=lambda one: float(np.abs(one - q).max()))
    target = tool_pose(robot, q_end, Pose())
    found = refused(lin(target, FINE), q, chain_for(robot))
    assert found.code == "M530"
    assert "`free`" in found.hint
    free = replace(lin(target, FINE), posture=FREE)
    assert not isinstance(plan_move(chain_for(robot), free, q), Refusal)


def test_a_target_of_which_the_position_is_missed_does_not_name_it() -> None:
    robot, q = two_link(), np.array([0.9, -1.7])
    found = refused(lin(Pose(np.array([1.0, 0.3, 1.0])), FINE), q, chain_for(robot))
    assert "`free`" not in found.hint


@pytest.mark.parametrize("kind", [LIN, PTP])
def test_an_arm_with_six_axes_keeps_its_orientation(kind: MotionKind) -> None:
    X = tool_pose(PUMA, START, Pose())
    target = Pose(X.position + np.array([0.05, 0.02, -0.04]), np.array([0.3, 0.9, 0.1, 0.2]))
    made = planned(MoveInstruction(kind, target, FINE, Origin(LINE), posture=FREE))
    there = tool_pose(PUMA, made.q_end, Pose())
    assert np.abs(there.position - target.position).max() < ON_LINE
    assert np.abs(there.matrix()[:3, :3] - X.matrix()[:3, :3]).max() < ON_LINE


@pytest.mark.parametrize("kind", [LIN, PTP])
def test_on_a_plate_that_turns_the_orientation_is_that_over_the_plate(kind: MotionKind) -> None:
    cell = carried_cell()
    robot, chain = cell.first.robot, chain_of(cell)
    q = np.concatenate((START, [2.0, 0.1, 0.2]))
    there = q.copy()
    there[-1] += 0.15
    before = from_plate(robot, q[np.newaxis])[0]
    target = replace(to_plate(robot, there, kind), posture=FREE)
    assert isinstance(target.target, Pose)
    move = replace(
        target, target=Pose(before[:3, 3] + np.array([0.01, 0.02, 0.0]), target.target.orientation)
    )
    made = plan_move(chain, move, q)
    assert not isinstance(made, Refusal), made
    after = from_plate(robot, made.q_end[np.newaxis])[0]
    assert np.abs(after[:3, :3] - before[:3, :3]).max() < ON_LINE
    assert np.abs(after[:3, 3] - before[:3, 3] - np.array([0.01, 0.02, 0.0])).max() < ON_LINE
    assert made.q_end[-1] == there[-1]


def test_an_arm_with_six_axes_says_which_orientation_it_cannot_keep() -> None:
    far = Pose(np.array([0.0, 0.86, 0.1]))
    found = refused(MoveInstruction(LIN, far, FINE, Origin(LINE), posture=FREE))
    assert "at the start of the move" in " ".join(found.notes)
    assert "in place of `free`" in found.hint
    again = refused(MoveInstruction(LIN, far, FINE, Origin(LINE)))
    assert "in place of `free`" not in again.hint


def test_a_free_line_after_another_tool_overlaps_it() -> None:
    """Where the orientation counts on one side only there is no common path: the motions overlap."""
    robot, q = two_link(), np.array([0.9, -1.7])
    at = places(robot, q)[0]
    first = to_point(LIN, at + np.array([0.1, 0.0, 0.0]), 0.01)
    of_flange = tool_pose(robot, q, Pose()).position + np.array([0.1, 0.0, 0.1])
    second = replace(to_point(LIN, of_flange), modal=ModalState(path_speed=0.2))
    made = planned_stretch([first, second], q, chain_for(robot))
    reached = tool_pose(robot, made.reference.q[-1], Pose()).position
    assert np.abs(reached - of_flange).max() < ON_LINE
    assert len(made.blends) == 1
