"""Coarse and fine interpolation: how far lines and cubics between interpolation ticks are off."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.flow import JointReference
from ropsim.model import BuiltIn, ControllerModel, Rates
from ropsim.planning.trajectory.between_ticks import between_ticks

EVERY, TICKS, PERIOD = 8, 1001, 1e-3  # the last interpolation period is a short one
END = TICKS * PERIOD
OMEGA = np.pi / END


def controller(*built_in: BuiltIn) -> ControllerModel:
    usual = robots.default_controller("puma560")
    return replace(usual, rates=Rates(1000, EVERY), built_in=built_in)


def motion() -> JointReference:
    """Return q = (1 - cos ωt)/2 and twice as much: at rest at both ends, with known derivatives."""
    t = PERIOD * np.arange(1, TICKS + 1)
    way = np.array([1.0, 2.0])
    q, qd, qdd = 0.5 - 0.5 * np.cos(OMEGA * t), 0.5 * OMEGA * np.sin(OMEGA * t), np.cos(OMEGA * t)
    rows = [np.outer(q, way), np.outer(qd, way), 0.5 * OMEGA**2 * np.outer(qdd, way)]
    rows[1][-1], rows[2][-1] = 0.0, 0.0
    return JointReference(*rows)


MOTION, START = motion(), np.zeros(2)


def test_without_a_choice_each_tick_is_of_the_trajectory() -> None:
    assert between_ticks(MOTION, START, controller()) is MOTION
    assert between_ticks(MOTION, START, controller(BuiltIn.EVERY_TICK)) is MOTION


@pytest.mark.parametrize(
    ("kind", "bound"),
    [
        (BuiltIn.LINEAR, OMEGA**2 * (EVERY * PERIOD) ** 2 / 8.0),  # max |q''| = ω² for the second joint
        (BuiltIn.CUBIC, OMEGA**4 * (EVERY * PERIOD) ** 4 / 384.0),
    ],
)
def test_the_error_comes_to_its_textbook_bound_and_stays_below(kind: BuiltIn, bound: float) -> None:
    made = between_ticks(MOTION, START, controller(kind))
    error = np.abs(made.q - MOTION.q).max()
    assert 0.9 * bound < error <= bound * (1.0 + 1e-6)


@pytest.mark.parametrize("kind", [BuiltIn.LINEAR, BuiltIn.CUBIC])
def test_it_meets_the_trajectory_at_the_interpolation_ticks_and_ends_at_rest(kind: BuiltIn) -> None:
    made = between_ticks(MOTION, START, controller(kind))
    here = np.append(np.arange(EVERY, TICKS, EVERY), TICKS) - 1
    np.testing.assert_allclose(made.q[here], MOTION.q[here], rtol=0.0, atol=1e-14)
    assert (made.qd[-1] == 0.0).all()
    assert (made.qdd[-1] == 0.0).all()


def test_speeds_of_lines_are_the_steps_of_their_coordinates() -> None:
    made = between_ticks(MOTION, START, controller(BuiltIn.LINEAR))
    steps = np.diff(np.vstack((START, made.q)), axis=0) / PERIOD
    np.testing.assert_allclose(made.qd[:-1], steps[:-1], rtol=0.0, atol=1e-10)
    assert len(np.unique(np.round(made.qd[:-1, 0], 9))) <= TICKS // EVERY + 1


def test_speeds_of_cubics_are_the_derivatives_of_their_coordinates() -> None:
    made = between_ticks(MOTION, START, controller(BuiltIn.CUBIC))
    middle = (made.q[2:] - made.q[:-2]) / (2.0 * PERIOD)
    assert np.abs(made.qd[1:-1] - middle)[2:-2].max() < 2e-5
