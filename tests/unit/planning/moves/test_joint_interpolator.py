"""The path through joint samples: all of them are passed, at the places that they were taken from."""

import numpy as np
import pytest

from ropsim.flow import JointSamples
from ropsim.planning import StandardJointInterpolator
from ropsim.spatial import Array

ROUNDING = 1e-12
LENGTH = 0.3
START: Array = np.array([0.1, -0.4, 1.0])


def samples(count: int) -> JointSamples:
    steps = np.random.default_rng(5).uniform(-0.01, 0.01, (count, 3))
    return JointSamples(LENGTH, START + np.cumsum(steps, axis=0))


@pytest.mark.parametrize("count", [2, 3, 7, 64, 251])
def test_the_path_goes_through_all_samples(count: int) -> None:
    given = samples(count)
    path = StandardJointInterpolator().refine(given)
    assert path.length == LENGTH
    assert np.abs(path.joints(np.linspace(0.0, LENGTH, count)).q - given.q).max() < ROUNDING


def test_derivatives_are_by_the_length_of_the_path() -> None:
    s = np.linspace(0.0, LENGTH, 40)
    q = np.stack([np.sin(3.0 * s), np.cos(2.0 * s), s], axis=1)
    points = StandardJointInterpolator().refine(JointSamples(LENGTH, q)).joints(s)
    expected = np.stack([3.0 * np.cos(3.0 * s), -2.0 * np.sin(2.0 * s), np.ones(40)], axis=1)
    assert np.abs(points.d1 - expected).max() < 1e-8  # differences of order six, 8 mm apart
    bends = np.stack([-9.0 * np.sin(3.0 * s), -4.0 * np.cos(2.0 * s), np.zeros(40)], axis=1)
    assert np.abs(points.d2 - bends).max() < 1e-5


def test_a_joint_that_stands_still_has_no_derivatives() -> None:
    path = StandardJointInterpolator().refine(JointSamples(LENGTH, np.tile(START, (50, 1))))
    points = path.joints(np.linspace(0.0, LENGTH, 200))
    assert np.abs(points.q - START).max() < ROUNDING
    assert np.abs(points.d1).max() < 1e-10
    assert np.abs(points.d2).max() < 1e-7


def test_roughness_is_what_the_path_through_every_second_sample_misses() -> None:
    given = JointSamples(LENGTH, np.sin(np.linspace(0.0, 9.0, 33))[:, None] * START)
    interpolator, step = StandardJointInterpolator(), LENGTH / 32
    path, rough = interpolator.refine_with_roughness(given)
    coarse = interpolator.refine(JointSamples(LENGTH, given.q[::2]))
    missed = np.abs(coarse.joints(step * np.arange(1.0, 32.0, 2.0)).q - given.q[1::2]).max(axis=1)
    assert missed.max() > 1e-6
    assert rough is not None
    np.testing.assert_allclose(rough, missed, rtol=0.0, atol=ROUNDING)
    places = np.linspace(0.0, LENGTH, 7)
    assert path.joints(places).d2.tolist() == interpolator.refine(given).joints(places).d2.tolist()


@pytest.mark.parametrize("count", [2, 16, 18, 15])
def test_few_samples_and_those_of_even_number_tell_no_roughness(count: int) -> None:
    given = JointSamples(LENGTH, np.linspace(START, 2.0 * START, count))
    path, rough = StandardJointInterpolator().refine_with_roughness(given)
    assert rough is None
    assert path.length == LENGTH
