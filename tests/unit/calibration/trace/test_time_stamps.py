"""How wrong the times of samples are, from the trace alone."""

import numpy as np
import pytest

from ropsim.calibration import Trace
from ropsim.calibration.trace.time_stamps import time_noise
from ropsim.spatial import Array
from support.logged_traces import ENCODER

NEAR = 0.25
"""Share: the median of some hundred samples, neighbours of each other."""
ROUNDING = 3e-5
"""What rounding to steps of 0.002° makes of exact times, at these speeds [s]."""


def way(time: Array) -> Array:
    """Return three joints that swing [rad], shape (k, 3)."""
    return np.asarray(np.column_stack([np.sin(rate * time) for rate in (1.0, 1.7, 2.3)]), dtype=np.float64)


def logged(time: Array, at: Array) -> Trace:
    """Return what is logged with the given times at other ones."""
    return Trace(time, np.round(way(at) / ENCODER) * ENCODER)


@pytest.mark.parametrize("deviation", [2e-4, 1e-3, 2e-3])
def test_the_deviation_of_times_is_found(deviation: float) -> None:
    time = np.linspace(0.0, 5.592, 700)
    at = time + deviation * np.random.default_rng(0).standard_normal(len(time))
    assert time_noise(logged(time, at)) == pytest.approx(deviation, rel=NEAR)


def test_times_that_are_uneven_and_right_are_not_wrong() -> None:
    time = np.asarray(np.cumsum(np.random.default_rng(0).uniform(0.005, 0.011, 700)), dtype=np.float64)
    assert time_noise(logged(time, time)) < ROUNDING


def test_a_trace_that_stands_or_is_short_has_none() -> None:
    time = np.linspace(0.0, 5.592, 700)
    assert time_noise(Trace(time, np.zeros((700, 3)))) == 0.0
    assert time_noise(logged(time[:10], time[:10] + 0.001)) == 0.0
