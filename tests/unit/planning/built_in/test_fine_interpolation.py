"""Coarse and fine interpolation: how far lines and cubics between interpolation ticks are off."""

import numpy as np
import pytest

from ropsim.flow import JointReference
from ropsim.model import Rates
from ropsim.planning import FineInterpolation
from ropsim.planning.testing import cubics, lines

EVERY, TICKS, PERIOD = 8, 1001, 1e-3  # the last interpolation period is a short one
END = TICKS * PERIOD
OMEGA = np.pi / END
RATES = Rates(1000, EVERY)


def motion() -> JointReference:
    """Return q = (1 - cos ωt)/2 and twice as much: at rest at both ends, with known derivatives."""
    t = PERIOD * np.arange(1, TICKS + 1)
    way = np.array([1.0, 2.0])
    q, qd, qdd = 0.5 - 0.5 * np.cos(OMEGA * t), 0.5 * OMEGA * np.sin(OMEGA * t), np.cos(OMEGA * t)
    rows = [np.outer(q, way), np.outer(qd, way), 0.5 * OMEGA**2 * np.outer(qdd, way)]
    rows[1][-1], rows[2][-1] = 0.0, 0.0
    return JointReference(*rows)


MOTION, START = motion(), np.zeros(2)


@pytest.mark.parametrize("kind", [lines, cubics])
def test_where_each_tick_is_one_of_interpolation_all_are_of_the_trajectory(kind: FineInterpolation) -> None:
    assert kind(MOTION, START, Rates(1000, 1)) is MOTION


@pytest.mark.parametrize(
    ("kind", "bound"),
    [
        (lines, OMEGA**2 * (EVERY * PERIOD) ** 2 / 8.0),  # max |q''| = ω² for the second joint
        (cubics, OMEGA**4 * (EVERY * PERIOD) ** 4 / 384.0),
    ],
)
def test_the_error_comes_to_its_textbook_bound_and_stays_below(kind: FineInterpolation, bound: float) -> None:
    made = kind(MOTION, START, RATES)
    error = np.abs(made.q - MOTION.q).max()
    assert 0.9 * bound < error <= bound * (1.0 + 1e-6)


@pytest.mark.parametrize("kind", [lines, cubics])
def test_it_meets_the_trajectory_at_the_interpolation_ticks_and_ends_at_rest(kind: FineInterpolation) -> None:
    made = kind(MOTION, START, RATES)
    here = np.append(np.arange(EVERY, TICKS, EVERY), TICKS) - 1
    np.testing.assert_allclose(made.q[here], MOTION.q[here], rtol=0.0, atol=1e-14)
    assert (made.qd[-1] == 0.0).all()
    assert (made.qdd[-1] == 0.0).all()


def test_speeds_of_lines_are_the_steps_of_their_coordinates() -> None:
    made = lines(MOTION, START, RATES)
    steps = np.diff(np.vstack((START, made.q)), axis=0) / PERIOD
    np.testing.assert_allclose(made.qd[:-1], steps[:-1], rtol=0.0, atol=1e-10)
    assert len(np.unique(np.round(made.qd[:-1, 0], 9))) <= TICKS // EVERY + 1


def test_speeds_of_cubics_are_the_derivatives_of_their_coordinates() -> None:
    made = cubics(MOTION, START, RATES)
    middle = (made.q[2:] - made.q[:-2]) / (2.0 * PERIOD)
    assert np.abs(made.qd[1:-1] - middle)[2:-2].max() < 2e-5
