"""The spline between joint samples: interpolation, continuity, rest at the ends, scipy as the oracle."""

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

from ropsim.controller import SplineJointInterpolator
from ropsim.flow import JointReference, JointSamples
from ropsim.spatial import Array

PERIOD = 0.004
TICKS = 4
ROUNDING = 1e-12  # of positions of size 1; derivatives lose the powers of the period

START: Array = np.array([0.1, -0.4, 1.0])


def samples(count: int) -> JointSamples:
    steps = np.random.default_rng(5).uniform(-0.01, 0.01, (count, 3))
    return JointSamples(PERIOD, START + np.cumsum(steps, axis=0))


def refined(count: int) -> JointReference:
    return SplineJointInterpolator().refine(samples(count), START, TICKS)


@pytest.mark.parametrize("count", [1, 2, 3, 7, 64, 251])
def test_references_are_those_of_the_clamped_cubic_spline(count: int) -> None:
    knots = np.concatenate((START[None], samples(count).q))
    spline = CubicSpline(np.arange(count + 1) * PERIOD, knots, bc_type="clamped")
    t = np.arange(1, count * TICKS + 1) * PERIOD / TICKS
    reference = refined(count)
    assert np.abs(reference.q - spline(t)).max() < ROUNDING
    assert np.abs(reference.qd - spline(t, 1)).max() < ROUNDING / PERIOD
    inside = np.arange(len(t)) < len(t) - 1  # scipy takes the last piece for the last knot, too
    assert np.abs(reference.qdd - spline(t, 2))[inside].max() < ROUNDING / PERIOD**2


@pytest.mark.parametrize("count", [1, 2, 3, 64])
def test_references_pass_exactly_through_the_samples(count: int) -> None:
    assert refined(count).q[TICKS - 1 :: TICKS].tolist() == samples(count).q.tolist()


@pytest.mark.parametrize("count", [1, 2, 64])
def test_the_arm_is_at_rest_at_the_end(count: int) -> None:
    assert refined(count).qd[-1].tolist() == [0.0, 0.0, 0.0]


def test_a_joint_that_stands_still_has_references_at_rest() -> None:
    still = JointSamples(PERIOD, np.tile(START, (50, 1)))
    reference = SplineJointInterpolator().refine(still, START, TICKS)
    assert (reference.q == START).all()
    assert not reference.qd.any()
    assert not reference.qdd.any()


def test_no_samples_give_no_ticks() -> None:
    nothing = JointSamples(PERIOD, np.empty((0, 3)))
    assert SplineJointInterpolator().refine(nothing, START, TICKS).ticks == 0


def test_one_tick_per_sample_gives_the_samples_themselves() -> None:
    reference = SplineJointInterpolator().refine(samples(9), START, 1)
    assert reference.q.tolist() == samples(9).q.tolist()
