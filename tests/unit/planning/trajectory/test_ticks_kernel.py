"""At which control ticks the motion comes to what: the compiled loop beside searches in arrays."""

from itertools import pairwise

import numpy as np
import pytest

from ropsim.planning.testing import ticks_come

SLACK = 1e-9


@pytest.mark.parametrize("seed", range(6))
def test_ticks_are_those_that_a_search_for_each_time_finds(seed: int) -> None:
    random = np.random.default_rng(seed)
    counts = random.integers(1, 4, 5)
    firsts = np.append(0, np.cumsum(counts))
    laws = [np.cumsum(random.uniform(0.1, 0.5, count)) for count in counts]
    runs = np.zeros((5, 7))
    for number, law in enumerate(laws):
        both = random.uniform(0.0, 0.08) if number % 2 else 0.0
        start = runs[number - 1, 1] - both if number else 0.0
        runs[number] = start, start + law[-1], law[-1], 0.0, 0.0, firsts[number], both
    phi = np.append(np.arange(0.004, runs[-1, 1], 0.004), runs[-1, 1])
    moves = np.array([0.0, phi[7], phi[9] + 0.5 * SLACK, *np.sort(random.uniform(0.0, phi[-1], 4))])
    pieces, overlaps, ended = np.empty((firsts[-1], 2)), np.empty((5, 2)), np.empty(len(moves))
    ticks_come(runs, np.concatenate(laws), moves, phi, SLACK, pieces, overlaps, ended)
    for number, (law, run) in enumerate(zip(laws, runs, strict=True)):
        begin, end = run[0] + run[6], run[1] - (runs[number + 1, 6] if number < 4 else 0.0)
        times = np.array([begin, *np.clip(run[0] + law[:-1], begin, end), end])
        found = np.searchsorted(phi, times + SLACK, "right").tolist()
        own = pieces[firsts[number] : firsts[number + 1]].tolist()
        assert own == [list(pair) for pair in pairwise(found)]
        both = np.searchsorted(phi, run[0] + np.array([0.0, run[6]]) + SLACK, "right")
        assert overlaps[number].tolist() == both.tolist()
    assert pieces[-1, 1] == len(phi)
    assert ended[:3].tolist() == [0.0, 8.0, 10.0]
    assert ended[3:].tolist() == (np.searchsorted(phi, moves[3:] - SLACK) + 1).tolist()


def test_the_last_piece_lasts_to_the_last_tick_though_the_motion_rests_before() -> None:
    runs, phi = (
        np.array([[0.0, 0.1, 0.1, 0.0, 0.0, 0.0, 0.0]]),
        np.array([0.04, 0.08, 0.1 - 1e-6, 0.1 - 1e-6]),
    )
    pieces, overlaps, ended = np.empty((1, 2)), np.empty((1, 2)), np.empty(1)
    ticks_come(runs, np.array([0.1]), np.array([0.1]), phi, SLACK, pieces, overlaps, ended)
    assert pieces.tolist() == [[0.0, 4.0]]
    assert ended.tolist() == [4.0]
