"""A thousand random stretches on every arm: shares of the limits that they take, and the time of a plan."""

from typing import Any

import numpy as np
import pytest
from measuring import Measure

from ropsim.model import Payload
from ropsim.planning import MotionChain, MotionState, plan
from support.walking_arms import WALKERS
from support.walking_arms import chain as chain_of_walker
from support.walks import random_walk, shares

STRETCHES = 1000
FEWEST = 300
"""Moves that are planned on any arm; one of two joints cannot make most lines, its stretches end there."""


@pytest.mark.parametrize("name", WALKERS)
def test_a_thousand_stretches(name: str, benchmark: Any) -> None:
    chain = chain_of_walker(name)
    measure = Measure(benchmark)
    (moves, asked), time = measure(lambda: _walked(chain), rounds=1, warmup=0)
    for quantity, share in asked.items():
        measure.figure(f"{name}: largest share of {quantity}", share, most=1.0 + 1e-9)
    measure.figure(f"{name}: moves planned", moves, least=FEWEST)
    measure.figure(f"{name}: ms per move, with the checks", 1e3 * time.best / moves)


def _walked(chain: MotionChain) -> tuple[int, dict[str, float]]:
    """Return how many moves were planned, and the largest share of each limit."""
    moves, worst = 0, dict.fromkeys(("speed", "acceleration", "jerk", "torque"), 0.0)
    for seed in range(STRETCHES):
        walk = random_walk(chain, np.random.default_rng(seed))
        planned, _ = plan(chain, walk.moves, MotionState.at_rest(walk.q_start))
        if planned is not None:
            moves += len(planned.moves)
            worst |= {
                key: max(worst[key], share) for key, share in shares(chain.robot, planned, Payload()).items()
            }
    return moves, worst
