"""Laws of profiles and straight ways on random cases, with ruckig as the oracle of optimal time."""

import numpy as np
import ruckig
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from ropsim.motion import (
    JointLine,
    JointMotionLimits,
    Line,
    OrientationMode,
    ProfileLimits,
    ToolLimits,
    durations,
    evaluate,
    plan_profile,
    plan_time_law,
)
from ropsim.planning.testing import joint_path_limits, tool_path_limits
from ropsim.spatial import Pose
from support.examples import examples

SAME_TIME = 1e-9  # relative; both are closed forms, ruckig states 1e-8 s for its own tests
ROUNDING = 1e-9  # relative; evaluated at 1 kHz by polynomials of third degree

sizes = st.floats(-3.0, 2.0).map(lambda exponent: float(10.0**exponent))
limits = st.builds(ProfileLimits, sizes, sizes, sizes)
angles = st.lists(st.floats(-3.0, 3.0), min_size=6, max_size=6).map(np.array)
vectors = st.lists(st.floats(0.5, 9.0), min_size=6, max_size=6).map(np.array)
quaternions = st.lists(st.floats(-1.0, 1.0), min_size=4, max_size=4).filter(
    lambda q: float(np.linalg.norm(q)) > 0.1
)
places = st.lists(st.floats(-1.0, 1.0), min_size=3, max_size=3)
poses = st.builds(lambda p, q: Pose(np.array(p), np.array(q)), places, quaternions)


@settings(max_examples=examples(200), derandomize=True)
@given(sizes, limits)
def test_duration_is_that_of_ruckig(distance: float, bounds: ProfileLimits) -> None:
    request = ruckig.InputParameter(1)
    request.current_position, request.target_position = [0.0], [distance]
    request.max_velocity, request.max_acceleration = [bounds.speed], [bounds.acceleration]
    request.max_jerk = [bounds.jerk]
    oracle = ruckig.Trajectory(1)
    assert ruckig.Ruckig(1).calculate(request, oracle) == ruckig.Result.Working
    duration = plan_profile(distance, bounds).duration
    assert abs(duration - oracle.duration) <= SAME_TIME * oracle.duration


@settings(max_examples=examples(100), derandomize=True)
@given(sizes, limits)
def test_profile_follows_the_trajectory_of_ruckig(distance: float, bounds: ProfileLimits) -> None:
    request = ruckig.InputParameter(1)
    request.current_position, request.target_position = [0.0], [distance]
    request.max_velocity, request.max_acceleration = [bounds.speed], [bounds.acceleration]
    request.max_jerk = [bounds.jerk]
    oracle = ruckig.Trajectory(1)
    ruckig.Ruckig(1).calculate(request, oracle)
    profile = plan_profile(distance, bounds)
    t = np.linspace(0.0, profile.duration, 41)
    expected = np.array([oracle.at_time(float(time))[0][0] for time in t])
    assert np.abs(evaluate(profile, t)[0] - expected).max() <= 1e-8 * distance


@settings(max_examples=examples(100), derandomize=True)
@given(sizes, limits)
def test_limits_hold_on_the_whole_way(distance: float, bounds: ProfileLimits) -> None:
    profile = plan_profile(distance, bounds)
    t = np.linspace(0.0, profile.duration, 1001)
    way, speed, acceleration = evaluate(profile, t)
    within = 1.0 + ROUNDING
    assert speed.max() <= bounds.speed * within
    assert np.abs(acceleration).max() <= bounds.acceleration * within
    jerk = np.diff(acceleration) / t[1]
    assert np.abs(jerk).max() <= bounds.jerk * within + 1e-9 * bounds.acceleration / t[1]
    assert way[-1] == distance
    assert (np.diff(way) >= -ROUNDING * distance).all()


@settings(max_examples=examples(100), derandomize=True)
@given(angles, angles, vectors, vectors, vectors)
def test_ptp_keeps_every_joint_within_its_limits_and_takes_one_of_them_to_its_bound(
    q_start: np.ndarray, q_end: np.ndarray, v: np.ndarray, a: np.ndarray, j: np.ndarray
) -> None:
    assume(float(np.abs(q_end - q_start).max()) > 1e-8)
    bounds = JointMotionLimits(v, a, 10.0 * j)
    law = plan_time_law(joint_path_limits(JointLine(q_start, q_end), bounds))
    rows = law.at(np.linspace(0.0, law.duration, 1001))
    way = np.abs(q_end - q_start)
    sizes = rows.speeds.max(), np.abs(rows.accelerations).max(), np.abs(law.jerks).max()
    limits_of = bounds.speed, bounds.acceleration, bounds.jerk
    shares = [float((way * size / limit).max()) for size, limit in zip(sizes, limits_of, strict=True)]
    assert max(shares) <= 1.0 + ROUNDING
    assert max(shares) >= 1.0 - 1e-6
    assert abs(durations(q_start, q_end[None], bounds)[0] - law.duration) <= ROUNDING * law.duration


@settings(max_examples=examples(50), derandomize=True)
@given(angles, angles, vectors)
def test_ptp_is_a_straight_line_in_joint_space(q_start: np.ndarray, q_end: np.ndarray, v: np.ndarray) -> None:
    assume((q_start != q_end).any())
    q = JointLine(q_start, q_end).joints(np.linspace(0.0, 1.0, 21)).q
    way = q_end - q_start
    along = (q - q_start) @ way / max(float(way @ way), 1e-300)
    assert np.abs(q - q_start - along[:, None] * way).max() < 1e-12
    assert q[[0, -1]].tolist() == [q_start.tolist(), q_end.tolist()]


TOOL_LIMITS = ToolLimits(0.25, 2.0, 20.0, 1.0, 6.0, 60.0)


@settings(max_examples=examples(100), derandomize=True)
@given(poses, poses)
def test_line_is_straight_turns_about_one_axis_and_respects_both_limits(X_start: Pose, X_end: Pose) -> None:
    path = Line(X_start, X_end)
    assume(path.length > 0.0)
    law = plan_time_law(tool_path_limits(path, TOOL_LIMITS))
    rows = law.at(np.linspace(0.0, law.duration, 201))
    points = path.tool(rows.parameters)
    way = X_end.position - X_start.position
    offsets = points.matrices[:, :3, 3] - X_start.position
    assert np.abs(np.cross(offsets, way)).max() < 1e-14
    rotations = points.matrices[:, :3, :3]
    assert np.abs(rotations @ np.swapaxes(rotations, 1, 2) - np.eye(3)).max() < 1e-13
    axis = X_start.rotation() @ path.axis
    assert np.abs(rotations @ path.axis - axis).max() < 1e-13
    sizes = np.stack([np.linalg.norm(part, axis=1) for part in (points.d1[:, :3], points.d1[:, 3:])])
    for values, linear, angular in (
        (rows.speeds, TOOL_LIMITS.speed, TOOL_LIMITS.orientation_speed),
        (np.abs(rows.accelerations), TOOL_LIMITS.acceleration, TOOL_LIMITS.orientation_acceleration),
    ):
        shares = sizes * values / np.array([[linear], [angular]])
        assert shares.max() <= 1.0 + ROUNDING


@settings(max_examples=examples(100), derandomize=True)
@given(poses, poses, st.sampled_from(OrientationMode))
def test_line_starts_and_ends_at_its_poses(X_start: Pose, X_end: Pose, mode: OrientationMode) -> None:
    path = Line(X_start, X_end, mode)
    assume(path.length > 0.0)
    ends = path.tool(np.array([0.0, path.length])).matrices
    assert np.abs(ends[0] - X_start.matrix()).max() < 1e-14
    assert np.abs(ends[1] - X_end.matrix()).max() < 1e-13
    assert ends[1, :3, 3].tolist() == X_end.position.tolist()
