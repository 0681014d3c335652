"""Time-synchronised PTP on random moves, with ruckig as the oracle."""

import numpy as np
import ruckig
from hypothesis import given, settings
from hypothesis import strategies as st

from ropsim.motion import JointMotionLimits, SynchronisedJoints
from support.examples import examples

ROUNDING = 1e-9  # relative; evaluated by polynomials of third degree
SAME_TIME = 1e-9  # relative; both are closed forms, ruckig states 1e-8 s for its own tests
MOVES = 1000

angles = st.lists(st.floats(-3.0, 3.0), min_size=6, max_size=6).map(np.array)
sizes = st.lists(st.floats(-1.0, 1.5), min_size=6, max_size=6).map(lambda e: 10.0 ** np.array(e))
limits = st.builds(lambda v, a, j: JointMotionLimits(v, a, 10.0 * j), sizes, sizes, sizes)


def test_a_thousand_moves_take_the_time_of_ruckig() -> None:
    random = np.random.default_rng(9)
    planner, request, oracle = ruckig.Ruckig(6), ruckig.InputParameter(6), ruckig.Trajectory(6)
    request.synchronization = ruckig.Synchronization.Time
    for _ in range(MOVES):
        q_start, q_end = random.uniform(-np.pi, np.pi, (2, 6))
        v, a, j = random.uniform(0.5, 5.0, 6), random.uniform(1.0, 20.0, 6), random.uniform(5.0, 400.0, 6)
        request.current_position, request.target_position = q_start.tolist(), q_end.tolist()
        request.max_velocity, request.max_acceleration = v.tolist(), a.tolist()
        request.max_jerk = j.tolist()
        assert planner.calculate(request, oracle) == ruckig.Result.Working
        move = SynchronisedJoints(q_start, q_end, JointMotionLimits(v, a, j))
        assert abs(move.length - oracle.duration) <= SAME_TIME * oracle.duration


@settings(max_examples=examples(100), derandomize=True)
@given(angles, angles, limits)
def test_every_joint_keeps_its_limits_and_never_turns_back(
    q_start: np.ndarray, q_end: np.ndarray, bounds: JointMotionLimits
) -> None:
    move = SynchronisedJoints(q_start, q_end, bounds)
    points = move.joints(np.linspace(0.0, move.length, 1001))
    assert (np.abs(points.d1) <= bounds.speed * (1.0 + ROUNDING)).all()
    assert (np.abs(points.d2) <= bounds.acceleration * (1.0 + ROUNDING)).all()
    assert (np.abs(move.shapes[0]) <= bounds.jerk * (1.0 + ROUNDING)).all()
    assert (points.d1 * np.sign(q_end - q_start) >= 0.0).all()
    assert (np.diff(points.q, axis=0) * np.sign(q_end - q_start) >= -1e-14).all()


@settings(max_examples=examples(50), derandomize=True)
@given(angles, angles, limits)
def test_the_way_back_is_the_mirror_of_the_way_there(
    q_start: np.ndarray, q_end: np.ndarray, bounds: JointMotionLimits
) -> None:
    there, back = SynchronisedJoints(q_start, q_end, bounds), SynchronisedJoints(q_end, q_start, bounds)
    assert there.length == back.length
    t = np.linspace(0.0, there.length, 101)
    assert np.abs(there.joints(t).q - back.joints(there.length - t).q).max() <= 1e-13
