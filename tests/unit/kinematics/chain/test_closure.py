"""Closed chains that are cut: their bodies stand where textbook linkages have them."""

from dataclasses import replace

import numpy as np

from ropsim.kinematics import forward, forward_batch, frames_batch, inverse
from ropsim.model import LoopCut, audit
from ropsim.spatial import Pose
from support.linkages import COUPLER, CRANK, FOUR_BAR, GROUND, IN_PLANE, ROCKER, ROD, SLIDER_CRANK, at

CLOSED = 1e-10
ANGLES = np.linspace(-3.0, 3.0, 13)


def test_the_slider_goes_as_far_as_the_crank_lets_it() -> None:
    """X = r·cos q + √(l² - r²·sin² q), by Pythagoras."""
    frames = frames_batch(SLIDER_CRANK, ANGLES[:, np.newaxis])
    expected = CRANK * np.cos(ANGLES) + np.sqrt(ROD**2 - (CRANK * np.sin(ANGLES)) ** 2)
    np.testing.assert_allclose(frames[:, 2, 0, 3], expected, rtol=0, atol=CLOSED)
    end = frames[:, 1, :3, 3] + ROD * frames[:, 1, :3, 0]
    np.testing.assert_allclose(end, frames[:, 2, :3, 3], rtol=0, atol=CLOSED)


def test_the_rocker_of_a_four_bar_obeys_freudenstein() -> None:
    """F. Freudenstein 1955: K1·cos ψ - K2·cos φ + K3 = cos(φ - ψ), ψ of the rocker against the ground."""
    frames = frames_batch(FOUR_BAR, ANGLES[:, np.newaxis])
    psi = np.arctan2(frames[:, 2, 1, 0], frames[:, 2, 0, 0])
    K1, K2 = GROUND / CRANK, GROUND / ROCKER
    K3 = (CRANK**2 - COUPLER**2 + ROCKER**2 + GROUND**2) / (2.0 * CRANK * ROCKER)
    left = K1 * np.cos(psi) - K2 * np.cos(ANGLES) + K3
    np.testing.assert_allclose(left, np.cos(ANGLES - psi), rtol=0, atol=1e-9)
    assert (psi > 0.0).all()  # it stays in the assembly of the home position


def test_a_place_does_not_depend_on_what_was_asked_beside_it() -> None:
    alone = frames_batch(FOUR_BAR, [[2.0]])[0]
    among = frames_batch(FOUR_BAR, [[-3.0], [2.0], [1.0]])[1]
    np.testing.assert_array_equal(alone, among)
    np.testing.assert_array_equal(forward_batch(FOUR_BAR, [[2.0]])[0], alone[-1])


def test_a_chain_that_cannot_reach_is_left_open() -> None:
    short = replace(SLIDER_CRANK, cuts=(LoopCut(1, at(0.05), 2, Pose(), IN_PLANE),))
    frames = frames_batch(short, [[np.pi / 2.0]])[0]
    end = frames[1, :3, 3] + 0.05 * frames[1, :3, 0]
    assert np.linalg.norm(end - frames[2, :3, 3]) >= CRANK - 0.05


def test_a_linkage_is_sound_and_its_crank_is_found_for_a_place_of_the_slider() -> None:
    assert not [finding for finding in audit(FOUR_BAR) if finding.is_error]
    found = inverse(SLIDER_CRANK, forward(SLIDER_CRANK, [0.8]))
    np.testing.assert_allclose(np.sort(found.solutions[:, 0]), [-0.8, 0.8], atol=1e-6)
