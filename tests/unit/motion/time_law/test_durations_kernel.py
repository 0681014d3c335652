"""The duration of one motion in compiled code is that of the function that takes many."""

import numpy as np

from ropsim.motion import JointMotionLimits, durations, write_duration

ROUNDING = 1e-13


def test_it_is_that_of_durations() -> None:
    random, told = np.random.default_rng(8), np.empty(1)
    for _ in range(300):
        limits = np.exp(random.uniform(-3.0, 3.0, (3, 4)))
        q_start, q_end = random.normal(size=(2, 4)) * np.exp(random.uniform(-6.0, 4.0, (2, 1)))
        write_duration(q_start, q_end, limits, told)
        slow = durations(q_start, q_end[None], JointMotionLimits(*limits))[0]
        assert abs(told[0] - slow) <= ROUNDING * slow


def test_where_there_is_none_it_is_no_number() -> None:
    told = np.empty(1)
    for wrong in (np.zeros((3, 2)), -np.ones((3, 2)), np.full((3, 2), np.inf)):
        write_duration(np.zeros(2), np.ones(2), wrong, told)
        assert np.isnan(told[0])
    write_duration(np.zeros(2), np.array([np.inf, 1.0]), np.ones((3, 2)), told)
    assert np.isnan(told[0])
