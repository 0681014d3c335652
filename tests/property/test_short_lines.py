"""Random chains of short lines: within the stated deviation, within limits, no slower than zone by zone."""

from itertools import pairwise

import numpy as np
import pytest

from ropsim.planning import planning
from ropsim.spatial import Array
from support.short_lines import chain_with_limits, distances, flown, positions_of

CHAIN = chain_with_limits("irb120")
BOX = np.array((0.070, 0.250, 0.120))
"""Half the size of a box round (400, 0, 450) mm that an IRB 120 reaches with the tool down [m]."""
FAST, SLOW = range(4), range(4, 132)


def random_chain(seed: int) -> tuple[Array, float, float]:
    """Return points [m], a zone [m] and a speed [m/s]: steps, noise and bends of all sizes."""
    rng = np.random.default_rng(seed)
    step = float(np.exp(rng.uniform(np.log(0.3e-3), np.log(10e-3))))
    count = int(rng.integers(8, 100))
    steps = step * np.exp(rng.uniform(0.0, 1.5) * rng.normal(size=count))
    way, radius = np.append(0.0, np.cumsum(steps)), float(np.exp(rng.uniform(np.log(0.01), np.log(0.4))))
    bent = np.column_stack(
        (
            radius * np.sin(way / radius),
            radius * np.cos(way / radius * rng.uniform(0.5, 1.0)),
            0.3 * radius * np.sin(0.7 * way / radius),
        )
    )
    noise = step * float(np.exp(rng.uniform(np.log(1e-4), np.log(0.05))))
    points = bent + noise * rng.normal(size=bent.shape)
    points -= 0.5 * (points.max(axis=0) + points.min(axis=0))
    inside = np.asarray((np.abs(points) < BOX).all(axis=1))
    first = int(np.argmax(inside))
    last = first + int(np.argmin(np.append(inside[first:], False)))
    zone = step * float(np.exp(rng.uniform(np.log(0.1), np.log(3.0))))
    return points[first:last] + np.array((0.4, 0.0, 0.45)), zone, float(rng.uniform(0.05, 0.6))


def check(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Check the laws on one chain."""
    points, zone, speed = random_chain(seed)
    if len(points) < 5 or min(np.linalg.norm(b - a) for a, b in pairwise(points)) < 1e-5:
        return
    done = flown(CHAIN, points, zone, speed)
    said = [finding.data for finding in done.findings if finding.code == "M576"]
    places = positions_of(CHAIN, done)
    if said and said[0]["lines"] == len(points) - 1:
        assert distances(places, points).max() <= float(str(said[0]["deviation_m"])) + 1e-7
    np.testing.assert_allclose(places[-1], points[-1], atol=1e-9)
    ends = [move.last for move in done.moves]
    assert ends == sorted(ends)
    with monkeypatch.context() as changed:
        changed.setattr(planning, "with_curves", lambda _, moves: list(moves))
        rounded = flown(CHAIN, points, zone, speed)
    assert done.duration <= 1.02 * rounded.duration


@pytest.mark.parametrize("seed", FAST)
def test_a_random_chain(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    check(seed, monkeypatch)


@pytest.mark.slow
@pytest.mark.parametrize("seed", SLOW)
def test_many_random_chains(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    check(seed, monkeypatch)
