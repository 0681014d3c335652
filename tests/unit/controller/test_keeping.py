"""Motions within all limits: how densely they are planned costs no time."""

import numpy as np
import pytest

from ropsim import robots
from ropsim.controller import MotionState, keeping, plan
from ropsim.flow import ModalState
from ropsim.model import Payload
from support.cells import chain_of, one_station
from support.motion import ptp

CHAIN = chain_of(one_station("c", robots.load("scara"), robots.default_controller("scara")))
HEAVY = Payload(38.5, np.array([-0.19, 0.11, 0.04]))
START, GOAL = np.array([1.16, 0.9, 0.026, 0.47]), (0.126, -1.905, 0.144, 0.363)


def seconds() -> float:
    planned, refusal = plan(
        CHAIN, [ptp(GOAL, ModalState(ptp_speed=0.5), 1)], MotionState.at_rest(START), HEAVY
    )
    assert planned is not None, refusal
    assert [finding.code for finding in planned.findings] == ["M563"]  # it is slowed
    return planned.duration


def test_a_heavy_load_goes_as_fast_as_with_places_that_lie_densely(monkeypatch: pytest.MonkeyPatch) -> None:
    asked = seconds()
    monkeypatch.setattr(keeping, "_SPACING", 4e-3)
    assert asked <= 1.01 * seconds()
