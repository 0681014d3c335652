"""Curves of random chains: as near to the polyline as stated, never farther than the tolerances."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation, Slerp

from ropsim.motion import Compression, CurvePart, compressed
from support.straight_chains import (
    StraightChain,
    curves,
    distances_from,
    random_chain,
    samples_of,
    widest_tolerances,
)

ROUNDING = 1e-12  # [m]
TURN_BY_ZONE = np.radians(0.1) / 1e-3  # [rad/m]


def keeps_its_word(given: StraightChain, found: Compression) -> None:
    """Assert that deviations are no greater than stated and tolerances hold at many places of each move."""
    tolerances = widest_tolerances(given)
    lengths = np.linalg.norm(np.diff(given.points, axis=0), axis=1)
    cut = np.minimum(given.zones, 0.5 * np.minimum(lengths[:-1], lengths[1:]))
    turns = TURN_BY_ZONE * np.concatenate((cut[:1], cut, cut[-1:]))
    for part in curves(found):
        s, moves = samples_of(part)
        points = part.curve.tool(s)
        near = given.points[max(part.first - 1, 0) : part.last + 2]
        distances = distances_from(near, points.matrices[:, :3, 3])
        assert distances.max() <= part.deviation + ROUNDING
        ends = np.clip(np.stack((moves, moves + 1)), part.first, part.last)
        assert (distances <= tolerances[ends].min(axis=0) * (1.0 + 1e-6) + ROUNDING).all()
        assert part.deviation <= tolerances[part.first : part.last + 1].max() * (1.0 + 1e-6)
        assert part.turn <= max(turns[part.first : part.last + 1].max(), 1e-6) * (1.0 + 1e-6)
        assert angles_from(given, part).max() <= part.turn + 1e-9


def angles_from(given: StraightChain, part: CurvePart, each: int = 23) -> np.ndarray:
    """Return angles between curve and polyline at shares of the moves that are wholly on the curve [rad]."""
    shares = (np.arange(each) + 0.5) / each
    found = []
    for k in range(part.last - part.first):
        one, two = part.parameters[k], part.parameters[k + 1]
        there = part.curve.tool(one + (two - one) * shares).matrices[:, :3, :3]
        ends = Rotation.from_matrix(given.rotations[part.first + k : part.first + k + 2])
        found.append((Slerp([0.0, 1.0], ends)(shares).inv() * Rotation.from_matrix(there)).magnitude())
    return np.concatenate(found)


def parts_follow_each_other(given: StraightChain, found: Compression) -> None:
    """Assert that every move belongs to one part and that points of curves are passed in order."""
    move = 0
    for part in found.parts:
        if isinstance(part, CurvePart):
            assert part.first == move < part.last
            assert (np.diff(part.parameters) > 0.0).all()
            move = part.last
        else:
            assert part.number == move
            move += 1
    assert move == len(given.points) - 1
    numbers = [point for point, _ in found.breaks]
    assert numbers == sorted(set(numbers))
    inside = {k for part in curves(found) for k in range(part.first + 1, part.last)}
    assert inside.isdisjoint(numbers)


def check(seed: int) -> None:
    given = random_chain(np.random.default_rng(seed))
    found = compressed(*given)
    parts_follow_each_other(given, found)
    keeps_its_word(given, found)


@pytest.mark.parametrize("seed", range(60))
def test_curves_deviate_as_stated_and_within_the_tolerances(seed: int) -> None:
    check(seed)


@pytest.mark.slow
@pytest.mark.parametrize("first", range(100, 1100, 50))
def test_curves_of_a_thousand_chains_deviate_as_stated(first: int) -> None:
    for seed in range(first, first + 50):
        check(seed)
