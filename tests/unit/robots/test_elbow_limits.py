"""Limits of joints that follow axes by couplings: the elbow of the palletizer, however it is asked for."""

import math
from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.cellfile import read_cell
from ropsim.core import SourceText
from ropsim.flow import ModalState, MotionKind, MoveInstruction
from ropsim.kinematics import (
    IkOptions,
    IkStatus,
    Limits,
    forward,
    inverse,
    limit_violations,
)
from ropsim.kinematics.testing import NO_AXIS
from ropsim.model import RobotModel, audit, coordinates, coupled_limits, on_track
from ropsim.planning import MotionPlan, Refusal, plan_move, standard_chain
from ropsim.spatial import Array, Pose
from ropsim.studio.testing import limit_words, within_limits
from support.cells import one_station

ROBOT = robots.load("palletizer")
LOWER, UPPER = math.radians(-155.0), math.radians(-25.0)
ROUNDING = 1e-9


def arm(*degrees: float) -> Array:
    return np.radians(degrees)


FOLDED = arm(0.0, 140.0, -40.0, 0.0)  # elbow at -180°
OUT = arm(0.0, 42.0, 20.0, 0.0)  # elbow at -22°
WORKING = arm(0.0, 95.0, -10.0, 0.0)


def test_only_limits_that_the_axes_do_not_keep_are_listed() -> None:
    """Other joints that follow may turn as far as the axes take them; those of serial arms follow none."""
    assert [joint.name for joint in coupled_limits(ROBOT).joints] == ["elbow"]
    for name in ("puma560", "scara", "two_link"):
        assert coupled_limits(robots.load(name)).joints == ()


def test_values_are_those_of_the_joints_themselves() -> None:
    rng, made, limits = np.random.default_rng(0), coordinates(ROBOT), coupled_limits(ROBOT)
    for q in rng.uniform(ROBOT.lower_limits, ROBOT.upper_limits, (20, 4)):
        Q = made.T @ q + made.c
        for joint, value in zip(limits.joints, limits.values(q).tolist(), strict=True):
            assert value == pytest.approx(float(Q[ROBOT.joints.index(joint)]))


def planned(q_start: Array, kind: MotionKind, target: Pose | tuple[float, ...]) -> MotionPlan | Refusal:
    controller = robots.default_controller("palletizer")
    cell = one_station("c", ROBOT, controller)
    move = MoveInstruction(kind, target, ModalState())
    return plan_move(standard_chain(cell, cell.first), move, q_start)


def refusal(found: MotionPlan | Refusal) -> tuple[str, object, str]:
    assert isinstance(found, Refusal)
    (finding,) = found.diagnostics
    return finding.code, finding.data["joint"], finding.message


def test_a_target_in_joint_coordinates_with_a_folded_elbow_is_refused() -> None:
    code, joint, message = refusal(planned(WORKING, MotionKind.PTP, tuple(FOLDED.tolist())))
    assert (code, joint) == ("M502", "elbow")
    assert "-180.0°" in message
    assert "-155.0°" in message


@pytest.mark.parametrize(("q", "limit"), [(FOLDED, "-155.0°"), (OUT, "-25.0°")])
def test_a_pose_that_only_a_folded_or_drawn_out_elbow_reaches_is_refused(q: Array, limit: str) -> None:
    for kind in (MotionKind.PTP, MotionKind.LIN):
        code, joint, message = refusal(planned(WORKING, kind, forward(ROBOT, q)))
        assert (code, joint) == ("M502", "elbow")
        assert limit in message


def test_a_line_that_folds_the_elbow_on_its_way_is_refused_where_it_does() -> None:
    """Both ends are within the limits; in the middle the wrist comes nearer to the shoulder."""
    ends = [arm(turn, 110.0, -40.0, 0.0) for turn in (-70.0, 70.0)]
    for q in ends:
        assert (coupled_limits(ROBOT).excess(q) == 0.0).all()
    code, joint, _ = refusal(planned(ends[0], MotionKind.LIN, forward(ROBOT, ends[1])))
    assert (code, joint) == ("M503", "elbow")


def test_within_the_limits_moves_are_made() -> None:
    found = planned(WORKING, MotionKind.PTP, tuple(arm(20.0, 80.0, -40.0, 10.0).tolist()))
    assert isinstance(found, MotionPlan)


@pytest.mark.parametrize("q", [FOLDED, OUT])
def test_inverse_kinematics_respects_the_elbow_and_says_by_how_much_it_is_beyond(q: Array) -> None:
    pose = forward(ROBOT, q)
    found = inverse(ROBOT, pose)
    assert found.status is IkStatus.OUT_OF_LIMITS
    assert found.solutions.shape == (0, 4)
    worst = found.violations[0]
    assert worst.name == "elbow"
    elbow = float(q[2] - q[1])
    assert worst.excess == pytest.approx(max(LOWER - elbow, elbow - UPPER), abs=1e-6)
    assert inverse(ROBOT, pose, IkOptions(Limits.IGNORE)).status is IkStatus.FOUND


@pytest.mark.parametrize("seed", range(10))
def test_a_branch_is_a_solution_or_exceeds_a_limit_never_both(seed: int) -> None:
    q = np.random.default_rng(seed).uniform(ROBOT.lower_limits, ROBOT.upper_limits)
    pose = forward(ROBOT, q)
    inside = {str(one) for one in inverse(ROBOT, pose).postures}
    free = inverse(ROBOT, pose, IkOptions(limits=Limits.IGNORE))
    for branch, posture in zip(free.solutions, free.postures, strict=True):
        assert (str(posture) in inside) == (not limit_violations(ROBOT, branch))


def test_the_elbow_counts_on_a_track_too() -> None:
    whole = on_track(ROBOT, robots.linear_track(2.0))
    q = np.zeros(whole.n)
    q[[k for k in range(whole.n) if k not in whole.external]] = FOLDED
    found = inverse(whole, forward(whole, q), IkOptions(near=q))
    assert (found.status, found.violations[0].name) == (IkStatus.OUT_OF_LIMITS, "elbow")


def test_a_jogged_arm_stops_where_its_elbow_does() -> None:
    for wanted in (FOLDED, OUT, arm(0.0, 145.0, -80.0, 0.0), arm(0.0, 40.0, 25.0, 400.0)):
        q = within_limits(ROBOT, wanted)
        assert (coupled_limits(ROBOT).excess(q) <= ROUNDING).all()
        assert (q >= ROBOT.lower_limits).all()
        assert (q <= ROBOT.upper_limits).all()
        told = [text for level, text in limit_words(ROBOT, q, wanted) if level == "error"]
        assert any(text.startswith("joint elbow stops at its") for text in told)
    np.testing.assert_array_equal(within_limits(ROBOT, WORKING), WORKING)
    assert not [level for level, _ in limit_words(ROBOT, WORKING, WORKING) if level == "error"]


def test_an_arm_without_limits_at_its_elbow_folds() -> None:
    joints = tuple(
        replace(one, lower=-math.inf, upper=math.inf) if one.name in ("elbow", "rod") else one
        for one in ROBOT.joints
    )
    free = replace(ROBOT, joints=joints)
    assert coupled_limits(free).joints == ()
    assert inverse(free, forward(free, FOLDED)).status is IkStatus.FOUND


def test_a_start_with_a_folded_elbow_is_told() -> None:
    text = '[robot]\nmodel = "palletizer"\nstart = [0, 140, -40, 0]\n'
    _, findings = read_cell(SourceText("cell.toml", text), "folded")
    (found,) = findings
    assert found.span is not None
    assert (found.code, found.span.line) == ("X815", 3)
    assert "joint `elbow`" in found.message
    assert "-155 deg" in found.message


def test_a_home_with_a_folded_elbow_is_told() -> None:
    assert [found.code for found in audit(ROBOT) if found.is_error] == []
    (found,) = (one for one in audit(replace(ROBOT, home=FOLDED)) if one.is_error)
    assert found.code == "X857"
    assert "`elbow`" in found.message


def with_limits(**limits: tuple[float, float]) -> RobotModel:
    """Return the palletizer with other limits of some joints [deg]."""
    joints = tuple(
        replace(one, lower=math.radians(limits[one.name][0]), upper=math.radians(limits[one.name][1]))
        if one.name in limits
        else one
        for one in ROBOT.joints
    )
    return replace(ROBOT, joints=joints)


def test_what_is_beyond_is_told_to_the_billionth_and_rounding_is_not() -> None:
    limits = coupled_limits(ROBOT)
    for beyond, expected in ((1e-5, 1e-5), (1e-8, 1e-8), (1e-10, 0.0), (-1e-5, 0.0)):
        low = np.array([0.0, 1.5, 1.5 + LOWER - beyond, 0.0])
        high = np.array([0.0, 1.5, 1.5 + UPPER + beyond, 0.0])
        for q in (low, high):
            assert limits.excess(q) == pytest.approx([expected], rel=1e-6, abs=1e-15)


@pytest.mark.parametrize("elbow", [(-155.0, math.inf), (-math.inf, -25.0)])
def test_one_limit_that_the_axes_do_not_keep_is_enough(elbow: tuple[float, float]) -> None:
    robot = with_limits(elbow=elbow, rod=(-math.inf, math.inf))
    assert [joint.name for joint in coupled_limits(robot).joints] == ["elbow"]


@pytest.mark.parametrize(
    ("elbow", "names"),
    [((-226.0, -14.0), []), ((-224.0, -14.0), ["elbow"]), ((-226.0, -16.0), ["elbow"])],
)
def test_the_axes_keep_limits_that_their_own_limits_never_lead_to(
    elbow: tuple[float, float], names: list[str]
) -> None:
    """The elbow is at axis 3 (-80° to 25°) less axis 2 (40° to 145°): between -225° and -15°."""
    assert np.degrees(ROBOT.lower_limits[1:3]).tolist() == pytest.approx([40.0, -80.0])
    assert np.degrees(ROBOT.upper_limits[1:3]).tolist() == pytest.approx([145.0, 25.0])
    robot = with_limits(elbow=elbow, rod=(-math.inf, math.inf))
    assert [joint.name for joint in coupled_limits(robot).joints] == names


@pytest.mark.parametrize("q", [WORKING, FOLDED, OUT])
@pytest.mark.parametrize("axis", [1, 2])
def test_whole_turns_of_the_axes_do_not_take_the_elbow_along(q: Array, axis: int) -> None:
    turned = q.copy()
    turned[axis] += 2.0 * math.pi
    known, found = limit_violations(ROBOT, q), limit_violations(ROBOT, turned)
    assert [one.name for one in found] == [one.name for one in known]
    assert [one.value for one in found] == pytest.approx([one.value for one in known])


def test_on_a_track_the_elbow_is_still_no_axis() -> None:
    """The axes beside it are counted in the station, where the elbow has no place."""
    whole = on_track(ROBOT, robots.linear_track(2.0))
    assert whole.n == ROBOT.n + 1
    q = np.append(arm(0.0, 150.0, -40.0, 0.0), 0.3)  # axis 2 beyond its 145°, the elbow at -190°
    assert whole.external == (4,)
    found = inverse(whole, forward(whole, q), IkOptions(near=q))
    assert found.status is IkStatus.OUT_OF_LIMITS
    assert {one.name: one.joint for one in found.violations} == {
        "elbow": NO_AXIS,
        whole.axis_joints[1].name: 1,
    }


def test_an_axis_at_its_limit_leaves_the_way_to_the_others() -> None:
    """The elbow stops at -60°: axis 2 can give no more than its 50°, axis 3 goes the rest of the way."""
    robot = with_limits(elbow=(-155.0, -60.0), **{ROBOT.axis_joints[1].name: (40.0, 50.0)})
    np.testing.assert_allclose(
        within_limits(robot, arm(0.0, 48.0, 25.0, 0.0)), arm(0.0, 50.0, -10.0, 0.0), rtol=0.0, atol=ROUNDING
    )
