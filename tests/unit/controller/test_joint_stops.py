"""Zones for which joints are slowed longer than a stop takes are left, and that is said."""

from importlib import import_module

import numpy as np
import pytest

from ropsim.controller import MotionPlan, MotionState, plan
from support.walking_arms import CHAINS
from support.walks import hairpins

ARM, SEED = "puma560 on a track", 6
"""A stretch of which two corners turn nearly back, between lines and an arc that a wrist hardly follows."""


def planned() -> MotionPlan:
    walk = hairpins(CHAINS[ARM], np.random.default_rng(SEED))
    made, _ = plan(CHAINS[ARM], walk.moves, MotionState.at_rest(walk.q_start))
    assert made is not None
    return made


def never(*_: object) -> tuple[int, ...]:
    return ()


def said(made: MotionPlan) -> list[str]:
    return [one.code for one in made.findings if "for which joints must be slowed" in one.message]


def test_a_zone_that_costs_more_than_a_stop_is_left_and_said(monkeypatch: pytest.MonkeyPatch) -> None:
    with_stops = planned()
    monkeypatch.setattr(import_module("ropsim.controller.planning"), "joint_stops", never)
    round_all = planned()
    assert set(said(with_stops)) == {"M560"}
    assert said(round_all) == []
    assert with_stops.duration < 0.95 * round_all.duration
