"""When a motion leaves a stop: from its first steps, and not from a motion that was fitted to it."""

import numpy as np
import pytest

from ropsim.calibration.departure import lateness
from ropsim.spatial import Array
from support.logged_traces import ENCODER

TIME = np.linspace(0.0, 0.472, 60)
EXACT = 1.5e-3
"""What rounding to a step of the encoders leaves [s]."""


def ramp(start: float, jerk: float, full: float) -> Array:
    """Return the way of two joints that leave with a jerk up to a full acceleration [rad], shape (60, 2)."""
    t = np.maximum(TIME - start, 0.0)
    rises = full / jerk
    late = np.maximum(t - rises, 0.0)
    early = np.minimum(t, rises)
    way = jerk * early**3 / 6.0 + full * rises / 2.0 * late + full * late**2 / 2.0
    return np.asarray(np.round(np.outer(way, (1.0, 0.4)) / ENCODER) * ENCODER, dtype=np.float64)


@pytest.mark.parametrize("jerk", [15.0, 60.0, 200.0])
def test_the_same_ramp_is_found_at_its_departure(jerk: float) -> None:
    found = lateness(TIME, ramp(0.113, jerk, 6.0), ramp(0.1, jerk, 6.0), ENCODER)
    assert found == pytest.approx(0.013, abs=EXACT)


def test_departure_does_not_hang_on_the_jerk_of_the_other_motion() -> None:
    """Half of the jerk makes a motion late at a hundredth of its way, though it left with the other."""
    slow, quick = ramp(0.1, 30.0, 6.0), ramp(0.1, 60.0, 6.0)
    level = 0.005
    late = [float(np.interp(level, way[:, 0], TIME)) for way in (slow, quick)]
    assert late[0] - late[1] > 0.015
    assert lateness(TIME, slow, quick, ENCODER) == pytest.approx(0.0, abs=2e-3)


def test_a_motion_that_has_few_samples_on_its_first_steps_is_not_judged() -> None:
    jump = np.where(TIME < 0.1, 0.0, 1.0)[:, None]
    assert lateness(TIME, jump, jump, ENCODER) is None


def test_a_motion_that_stands_is_not_judged() -> None:
    still = np.zeros((60, 2))
    assert lateness(TIME, still, ramp(0.1, 60.0, 6.0), ENCODER) is None
