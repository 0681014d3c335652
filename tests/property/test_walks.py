"""Random stretches on every arm: limits kept at every control tick, whatever kinds and zones meet."""

import numpy as np
import pytest

from ropsim.model import Payload
from ropsim.planning import MotionState, plan
from support.examples import examples
from support.walking_arms import WALKERS, chain
from support.walks import faults_of, hairpins, random_walk

LOAD = Payload(2.0, np.array([0.02, -0.01, 0.08]))
WALKS = {"of all kinds": random_walk, "of hairpins": hairpins}


@pytest.mark.parametrize("name", WALKERS)
@pytest.mark.parametrize("kind", WALKS)
@pytest.mark.parametrize("seed", range(examples(12)))
def test_limits_hold_at_every_control_tick(name: str, kind: str, seed: int) -> None:
    """`python -m tools.walks` does the same for as many walks as one has time for."""
    walk = WALKS[kind](chain(name), np.random.default_rng(seed))
    assert faults_of(chain(name), walk, (Payload(), LOAD)[seed % 2]) == []


@pytest.mark.parametrize("name", WALKERS)
def test_the_same_stretch_is_planned_to_the_same_bits(name: str) -> None:
    entities = chain(name)
    walk = random_walk(entities, np.random.default_rng(3))
    first, again = (plan(entities, walk.moves, MotionState.at_rest(walk.q_start)) for _ in range(2))
    assert first == again
