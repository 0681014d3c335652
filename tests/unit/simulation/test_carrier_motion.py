"""Between two rows no body leaves the straight line by more than its stated deviation."""

from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

import ropsim
from ropsim.model import WORLD, body_tree
from ropsim.simulation.testing import CarrierSet, Motion, bends_of, carriers_of

EXAMPLES = Path(__file__).parents[3] / "examples"
RATE = 250.0
BETWEEN = 8
"""States between two rows that are compared."""


def wave(random: np.random.Generator, count: int, time: np.ndarray) -> np.ndarray:
    """Return coordinates by time, shape (k, n), whose accelerations are up to 30 1/s²."""
    sizes, rates, phases = random.uniform(0.05, 0.2, (3, 1, count)) * np.array([[[1.0]], [[60.0]], [[30.0]]])
    return np.asarray(sizes * np.sin(rates * time[:, np.newaxis] + phases))


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("example", ["first_cell", "track_and_table", "two_arms", "crane", "four_squares"])
def test_frames_between_rows_are_within_the_stated_deviation(example: str, seed: int) -> None:
    """Of carriers in the world, and of carriers as others see them; cylinders and tracks included."""
    cell = ropsim.open(EXAMPLES / example).cell
    assert cell is not None
    tree, random = body_tree(cell), np.random.default_rng(seed)
    fine = np.arange(40 * BETWEEN + 1) / (RATE * BETWEEN)
    starts = {name: np.asarray(one.home) for name, one in tree.mechanisms.items() if hasattr(one, "home")}
    Q = {
        name: starts.get(name, np.zeros(one.n)) + wave(random, one.n, fine)
        for name, one in tree.mechanisms.items()
    }
    names = tuple(body.name for body in tree.bodies if body.mover is not None)
    centres = random.uniform(-0.3, 0.3, (len(names), 3))
    wanted = CarrierSet(names, centres, ((-1, 0), *pairwise(range(len(names))), (len(names) - 1, 0)))
    time = fine[::BETWEEN]
    rows = {name: q[::BETWEEN] for name, q in Q.items()}
    found = carriers_of(tree, wanted, Motion(time, rows, bends_of(time, rows)))
    true = carriers_of(tree, wanted, Motion(fine, Q, bends_of(fine, Q))).frames
    share = (np.arange(len(fine) - 1) % BETWEEN / BETWEEN)[:, np.newaxis]
    row = np.arange(len(fine) - 1) // BETWEEN
    for frame, deviation, real in zip(found.frames, found.deviation, true, strict=True):
        straight = frame[row] + share * (frame[row + 1] - frame[row])
        off = np.linalg.norm(straight[:, 9:] - real[:-1, 9:], axis=1)
        tilted = np.linalg.norm((straight - real[:-1])[:, :9].reshape(-1, 3, 3), ord=2, axis=(1, 2))
        assert (off <= deviation[row, 0] + 1e-12).all()
        assert (tilted <= deviation[row, 1] + 1e-12).all()
    assert WORLD not in names
    assert 1e-6 < float(found.deviation.max()) < 2e-3
