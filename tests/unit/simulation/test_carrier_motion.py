"""Between two rows no body leaves the straight line by more than its stated deviation."""

from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

import ropsim
from ropsim.model import WORLD, body_tree
from ropsim.robots import library
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


def test_a_slide_that_turns_evenly_bends_the_way_of_what_it_carries() -> None:
    """Turn and slide go evenly; the point leaves the straight line by about a quarter of their product."""
    cell = ropsim.open(EXAMPLES / "first_cell").cell
    assert cell is not None
    polar = replace(cell.first, robot=library.load("stanford"))
    tree = body_tree(replace(cell, stations={"robot": polar}))
    time = np.arange(9) / RATE
    rates = {name: np.zeros(one.n) for name, one in tree.mechanisms.items()}
    rates["robot"][1:3] = 2.0, 50.0
    start = {name: np.zeros(one.n) for name, one in tree.mechanisms.items()}
    fine = {name: start[name] + np.outer(time, rates[name]) for name in rates}
    rows = {name: q[::8] for name, q in fine.items()}
    wanted = CarrierSet(("link3",), np.zeros((1, 3)), ())
    found = carriers_of(tree, wanted, Motion(time[::8], rows, bends_of(time[::8], rows)))
    true = carriers_of(tree, wanted, Motion(time, fine, bends_of(time, fine))).frames
    straight = (found.frames[0, 0, 9:] + found.frames[0, 1, 9:]) / 2.0
    off = float(np.linalg.norm(straight - true[0, 4, 9:]))
    assert off > 1e-3
    assert off <= float(found.deviation[0, 0, 0]) < 3.0 * off
