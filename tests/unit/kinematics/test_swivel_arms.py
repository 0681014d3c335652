"""Arms with a swivel angle: frames may lie anywhere on their axes, and an arm a little beside its class."""

from dataclasses import replace
from math import pi

import numpy as np
import pytest

from ropsim.kinematics import (
    IkOptions,
    IkStatus,
    Limits,
    classes_missed,
    forward,
    forward_batch,
    inverse,
    inverse_batch,
    joint_frames,
    solver_of,
)
from ropsim.kinematics.solvers.offset.swivel import closed_form
from ropsim.kinematics.testing import COUPLED, SwivelSolver, swivel
from ropsim.model import Coupling, RobotModel
from ropsim.spatial import Array, Pose, quaternion
from support.published_arms import published_arm, random_joints

HERE = Pose()
SIA20 = published_arm("motoman_sia20d")
REACHED = 1e-9  # m, entries of the rotation matrix: what is promised
SAME = 1e-9  # rad
NEAR = 0.05  # rad: the swivel angle of an arm that was snapped by 4e-4 is that of another arm


def placed(robot: RobotModel, joint: int, before: Pose, after: Pose = HERE) -> RobotModel:
    """Return a robot whose joint (from 0) is placed by `before @ placement @ after`."""
    joints = list(robot.joints)
    joints[joint] = replace(joints[joint], placement=before @ joints[joint].placement @ after)
    return replace(robot, joints=tuple(joints))


def along(height: float) -> Pose:
    return Pose(np.array([0.0, 0.0, height]))


def slid(robot: RobotModel) -> RobotModel:
    """Return the same arm with the frames of its joints elsewhere on their axes."""
    for joint, height in enumerate((0.11, -0.07, 0.05, 0.04, -0.13, 0.06)):
        robot = placed(robot, joint, Pose(), along(height))
        robot = placed(robot, joint + 1, along(-height))
    return robot


def off(joint: int, angle: float, length: float) -> RobotModel:
    """Return an arm with one joint turned [rad] and moved [m] away from where the class has it."""
    turn = Pose(np.array([length, length, 0.0]), np.array(quaternion.from_zyx(0.0, 0.0, angle)))
    return placed(SIA20, joint, Pose(), turn)


def solver(robot: RobotModel) -> SwivelSolver:
    found = solver_of(robot)
    assert isinstance(found, SwivelSolver)
    return found


def apart(q: Array, other: Array) -> Array:
    return np.asarray(np.abs((q - other + pi) % (2.0 * pi) - pi).max(axis=-1))


def test_frames_that_lie_elsewhere_on_their_axes_change_no_branch() -> None:
    robot, Q = slid(SIA20), random_joints(SIA20, 10, seed=1)
    T = forward_batch(SIA20, Q)
    np.testing.assert_allclose(forward_batch(robot, Q), T, atol=1e-12)
    assert apart(inverse_batch(robot, T, Q), inverse_batch(SIA20, T, Q)).max() < SAME
    far = Pose(np.array([1.5, 0.3, 0.4]))
    ours, theirs = inverse(robot, far).reach, inverse(SIA20, far).reach
    assert ours is not None
    assert theirs is not None
    assert (ours.distance, ours.longest) == pytest.approx((theirs.distance, theirs.longest), abs=1e-12)


def test_the_answers_of_an_arm_of_the_class_are_those_of_the_closed_form_unpolished(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(swivel, "polished", None)
    one, Q = solver(SIA20), random_joints(SIA20, 5, seed=6)
    T, bare = forward_batch(SIA20, Q), np.empty((5, 8, 7))
    closed_form(one)(np.zeros(80), np.full(5, 0.3), T, bare)
    assert np.array_equal(one.branches_at(T, np.zeros(7), np.full(5, 0.3)), bare, equal_nan=True)


@pytest.mark.parametrize("joint", [2, 6])
def test_an_arm_that_is_nearly_of_the_class_is_solved_and_polished(joint: int) -> None:
    robot = off(joint, 4e-4, 4e-6)
    assert solver(robot).snapped_by.angle == pytest.approx(4e-4, rel=1e-3)
    Q = random_joints(robot, 20, seed=2)
    T = forward_batch(robot, Q)
    branches = inverse_batch(robot, T, Q)
    assert np.nanmin(apart(branches, Q[:, None]), axis=1).max() < NEAR
    present = ~np.isnan(branches[:, :, 0])
    assert present.sum() > 150
    reached = forward_batch(robot, branches[present])
    np.testing.assert_allclose(reached, np.repeat(T, present.sum(axis=1), axis=0), rtol=0.0, atol=REACHED)
    rough = np.empty((1, 8, 7))
    closed_form(solver(robot))(np.zeros(80), np.zeros(1), T[:1], rough)
    assert np.abs(forward_batch(robot, rough[0]) - T[0]).max() > 1e-6


@pytest.mark.parametrize("joint", [2, 6])
def test_a_nearly_stretched_arm_that_was_snapped_still_reaches(joint: int) -> None:
    robot = off(joint, 4e-4, 4e-6)
    Q = random_joints(robot, 40, seed=3)
    Q[:, 3] = -solver(robot).arm.zeros[3] + np.linspace(-2e-3, 2e-3, len(Q))
    for q in Q:
        found = inverse(robot, forward(robot, q), IkOptions(Limits.IGNORE, near=q))
        assert found.status is IkStatus.FOUND


def test_the_slacks_of_a_snapped_arm_are_three_times_what_its_snap_can_make() -> None:
    """Of the cosine of the bend c = (d² - Lu² - Lr²) / (2·Lu·Lr): a turn by φ moves W by φ·size at most."""
    exact, near = solver(SIA20), solver(off(2, 4e-4, 4e-6))
    beside, upper, fore = near.arm.lengths.tolist()
    size, snap = abs(beside) + upper + fore, near.snapped_by
    worst = snap.angle * size * size / (upper * fore) + snap.length / min(upper, fore)
    assert near.strict[-4:].tolist() == pytest.approx([np.inf, 1e-10, 1e-10 + 3.0 * worst, 3.0 * worst])
    assert exact.strict[-4:].tolist() == [exact.slack, 1e-10, 1e-10, 0.0]


@pytest.mark.parametrize(("joint", "said"), [(1, "axes 1, 2 and 3"), (5, "axes 5, 6 and 7")])
def test_axes_that_miss_each_other_by_more_than_files_are_rounded_are_another_class(
    joint: int, said: str
) -> None:
    assert solver(off(joint, 0.0, 8e-6)).snapped_by.length == pytest.approx(8e-6, rel=0.01)
    assert classes_missed(off(joint, 0.0, 1.2e-5))["S-R-S"] == f"{said} do not meet in one point"


@pytest.mark.parametrize("joint", [3, 4])
def test_axis_4_may_not_pass_through_shoulder_or_wrist(joint: int) -> None:
    """Moved so that one link is nearly nothing, the other one is the whole arm."""
    arm = solver(SIA20).arm
    link = arm.u if joint == 3 else arm.r
    flat = link - (link @ arm.axis) * arm.axis
    size = float(np.linalg.norm(flat))
    for left, known in ((3e-6, True), (3e-7, False)):
        moved = shortened(joint, flat * (1.0 - left / size))
        missed = classes_missed(moved).get("S-R-S")
        assert (missed is None) == known
        assert known or missed == "axis 4 passes through the shoulder or the wrist"


def shortened(joint: int, by: Array) -> RobotModel:
    """Return the SIA20 with joint 4 or 5 moved back by a vector of frame J at coordinate zero."""
    robot = SIA20
    zero = joint_frames(robot, np.zeros(robot.n))
    R = zero[joint - 1][:3, :3] if joint == 3 else zero[3][:3, :3]
    J = zero[0][:3, :3]
    return placed(robot, joint, Pose(-(R.T @ J @ by)))


@pytest.mark.parametrize(
    ("joint", "part", "negative", "positive", "tie"),
    [(1, 0, "left", "right", "left"), (3, 1, "back", "forth", "forth"), (5, 2, "noflip", "flip", "noflip")],
)
def test_a_singular_configuration_has_the_first_name_and_one_beside_it_its_own(
    joint: int, part: int, negative: str, positive: str, tie: str
) -> None:
    one, (q,) = solver(SIA20), random_joints(SIA20, 1, seed=5)
    for angle, name in ((-1e-7, negative), (-1e-10, tie), (0.0, tie), (1e-10, tie), (1e-7, positive)):
        q[joint] = angle - one.arm.zeros[joint]
        assert one.posture(q).words[part] == name


@pytest.mark.parametrize("joint", [1, 3, 5])
def test_an_arm_may_stay_near_to_singular_configurations_alone(joint: int) -> None:
    one, q = solver(SIA20), 1.0 - solver(SIA20).arm.zeros
    assert not one.may_stay(q)
    for angle, may_stay in ((0.14, True), (-0.14, True), (pi - 0.14, True), (0.16, False), (-0.16, False)):
        q[joint] = angle - one.arm.zeros[joint]
        assert one.may_stay(q) == may_stay


def test_an_arm_with_a_coupled_joint_is_of_no_class_with_seven_axes() -> None:
    more = replace(SIA20.joints[-1], name="8", placement=Pose())
    coupled = replace(SIA20, joints=(*SIA20.joints, more), couplings=(Coupling(7, ((6, 0.5),)),), tip=7)
    assert swivel.recognise(coupled) == COUPLED
