"""Zones never cost time: where stops are quicker the arm stops, and that is said."""

from collections.abc import Sequence
from itertools import pairwise, product

import numpy as np
import pytest

from ropsim.model import Payload
from ropsim.planning import MotionState, plan
from ropsim.planning.testing import Blend, JointSpaceBlend, Stretch, Times, quicker_stops
from support.walking_arms import chain as chain_of_walker
from support.walks import cost_of_zones, hairpins, random_walk

ROUND = JointSpaceBlend(0.01, 0.01, 0.0, 0.0)
COSTLY = [
    ("puma560", 7019),
    ("puma560 on a track", 7017),
    ("puma560 on a track", 5206),
    ("puma560 on a track", 5050),
    ("puma560 with wrist angles", 7033),
    ("scara", 7000),
]
"""Hairpins of which some corners cost more than a stop: with all of them the motion takes 5 to 9 % longer."""


@pytest.mark.parametrize(("name", "seed"), COSTLY)
def test_a_stretch_takes_no_longer_than_with_a_stop_at_each_point(name: str, seed: int) -> None:
    """`python -m tools.walks` looks at this for as many stretches as one has time for."""
    walk = hairpins(chain_of_walker(name), np.random.default_rng(seed))
    assert cost_of_zones(chain_of_walker(name), walk, Payload()) == []


def test_a_zone_for_which_joints_would_be_slowed_for_longer_is_left_and_said() -> None:
    chain = chain_of_walker("puma560 on a track")
    some = 0
    for seed in (19, 35, 46, 51, 53, 55):
        walk = hairpins(chain, np.random.default_rng(seed))
        achieved, _ = plan(chain, walk.moves, MotionState.at_rest(walk.q_start))
        assert achieved is not None
        left = [one for one in achieved.findings if "to slow down for the joints" in one.message]
        assert {one.code for one in left} <= {"M560"}
        assert len(left) <= [move.zone for move in achieved.moves[:-1]].count(0.0)
        some += len(left)
    assert some


class Table:
    """Times of moves from rest to rest, at random: a way round a corner may cost more than a stop."""

    def __init__(self, moves: int, seed: int, whole: float | None = None) -> None:
        random = np.random.default_rng(seed)
        self.moves = moves
        self.corners: list[Blend | None] = [ROUND] * (moves - 1)
        self.asked: list[Stretch] = []
        self._times = {
            (first, last): (last - first) * float(random.uniform(0.7, 1.1))
            for first in range(moves)
            for last in range(first + 1, moves + 1)
        }
        self._times[0, moves] = whole or self._times[0, moves]
        self._less = {span: time * float(random.uniform(0.6, 1.0)) for span, time in self._times.items()}

    def exact(self, span: Stretch) -> float:
        self.asked.append(span)
        return self._times[span]

    def of_stops(self, stops: Sequence[int]) -> float:
        return sum(self._times[span] for span in pairwise([0, *(one + 1 for one in stops), self.moves]))

    def found(self) -> tuple[int, ...]:
        ends = np.linspace(0.0, self.of_stops(()), self.moves + 1)[1:].tolist()
        alone = [self._less[number, number + 1] for number in range(self.moves)]
        return quicker_stops(self.corners, ends, alone, Times(self._less.__getitem__, self.exact))


@pytest.mark.parametrize("moves", [2, 3, 5])
def test_the_stops_are_those_with_the_least_time_of_all(moves: int) -> None:
    for seed in range(60):
        table = Table(moves, seed)
        every = product((False, True), repeat=moves - 1)
        least = min(table.of_stops(np.flatnonzero(choice).tolist()) for choice in every)
        assert table.of_stops(table.found()) == pytest.approx(least, rel=2e-6)


def test_no_more_is_planned_than_what_may_be_the_quickest() -> None:
    """Of the many ways from stop to stop few are planned, each once; the motion as it is never again."""
    for seed in range(20):
        table = Table(12, seed, whole=24.0)
        table.found()
        assert len(set(table.asked)) == len(table.asked)
        assert (0, 12) not in table.asked
        assert 12 <= len(table.asked) < 42
        assert max(last - first for first, last in table.asked) <= 4


def test_only_corners_beside_a_move_that_takes_longer_are_looked_at() -> None:
    asked: list[Stretch] = []

    def exact(span: Stretch) -> float:
        asked.append(span)
        return 0.9 * (span[1] - span[0])

    times = Times(exact, exact)
    alone = [1.0] * 6
    assert quicker_stops([ROUND] * 5, [0.7, 1.4, 2.1, 2.8, 3.5, 4.2], alone, times) == ()
    assert not asked
    slow_at_the_end = [0.7, 1.4, 2.1, 2.8, 3.5, 4.8]
    assert quicker_stops([ROUND] * 5, slow_at_the_end, alone, times) == ()
    assert set(asked) == {(0, 5), (5, 6)}
    asked.clear()
    assert quicker_stops([None, ROUND, None, None, None], [1.5, 2.3, 3.4, 4.4, 5.4, 6.4], alone, times) == (
        1,
    )
    assert set(asked) == {(1, 2), (2, 3)}


def test_zones_of_random_stretches_cost_no_time() -> None:
    for seed in range(4):
        walk = random_walk(chain_of_walker("puma560"), np.random.default_rng(seed))
        assert cost_of_zones(chain_of_walker("puma560"), walk, Payload()) == []
