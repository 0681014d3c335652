"""Random stretches on every arm: limits kept at every control tick, whatever kinds and zones meet."""

import numpy as np
import pytest

from ropsim.controller import MotionState, plan
from ropsim.model import Payload
from support.motion import references
from support.walking_arms import CHAINS
from support.walks import random_walk, shares, tool_shares

WITHIN = 1.0 + 1e-9  # of limits: rounding
WITHIN_TOOL = 1.0 + 1e-4  # paths of joints are true to 1e-9 m between samples
WITHIN_TOOL_JERK = 1.06  # where splines bend most, at single ticks; lines keep it like acceleration
LOAD = Payload(2.0, np.array([0.02, -0.01, 0.08]))
PERIOD = 1e-3  # [s]


@pytest.mark.parametrize("name", CHAINS)
@pytest.mark.parametrize("seed", range(12))
def test_limits_hold_at_every_control_tick(name: str, seed: int) -> None:
    chain = CHAINS[name]
    walk = random_walk(chain, np.random.default_rng(seed))
    payload = (Payload(), LOAD)[seed % 2]
    planned, refusal = plan(chain, walk.moves, MotionState.at_rest(walk.q_start), payload)
    assert planned is not None or refusal is not None
    if planned is None:
        return
    asked = shares(chain.robot, planned, payload)
    assert max(asked.values()) <= WITHIN, asked
    of_tool = tool_shares(chain.robot, planned)
    assert max(of_tool["speed"], of_tool["acceleration"]) <= WITHIN_TOOL, of_tool
    assert of_tool["jerk"] <= WITHIN_TOOL_JERK, of_tool
    q, qd, qdd = references(planned)
    bend = np.abs(np.diff(qdd, axis=0)).max(initial=0.0)
    steps, mean = np.diff(q, axis=0) / PERIOD, (qd[1:] + qd[:-1]) / 2.0
    assert np.abs(steps - mean).max(initial=0.0) <= bend * PERIOD + 1e-9
    steps, mean = np.diff(qd, axis=0) / PERIOD, (qdd[1:] + qdd[:-1]) / 2.0
    assert np.abs(steps - mean).max(initial=0.0) <= bend + 1e-6


@pytest.mark.parametrize("name", CHAINS)
def test_the_same_stretch_is_planned_to_the_same_bits(name: str) -> None:
    chain = CHAINS[name]
    walk = random_walk(chain, np.random.default_rng(3))
    first, again = (plan(chain, walk.moves, MotionState.at_rest(walk.q_start)) for _ in range(2))
    assert first == again
