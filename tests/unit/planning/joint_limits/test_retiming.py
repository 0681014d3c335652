"""Motions within all limits: how densely they are planned costs no time."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.flow import ModalState
from ropsim.model import Payload
from ropsim.motion import Effort, JointBounds, Motion, Reference, Ticks, as_planned
from ropsim.planning import MotionPlan, MotionState, plan
from ropsim.planning.testing import evaluated, reached_speeds, retiming
from support.cells import chain_of, one_station
from support.motion import CHAIN as OF_PUMA
from support.motion import PUMA, interface_pose, lin, planned_stretch, ptp, shifted
from support.motion import START as STARTED
from support.walks import WITHIN, shares

CHAIN = chain_of(one_station("c", robots.load("scara"), robots.default_controller("scara")))
HEAVY = Payload(38.5, np.array([-0.19, 0.11, 0.04]))
QUICK = ModalState(path_speed=2.0, path_acceleration=2.0, path_jerk=20.0, zone=0.02)
ARM = replace(PUMA, joints=tuple(replace(one, max_jerk=0.3 * one.max_jerk) for one in PUMA.joints))
JERKLESS = replace(OF_PUMA, robot=ARM)
CORNER = interface_pose(STARTED)
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
    monkeypatch.setattr(retiming, "_SPACING", 4e-3)
    assert asked <= 1.01 * seconds()


@pytest.fixture
def periods(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """Return the periods of the ticks at which motions have been looked at, in order."""
    found: list[float] = []
    look = as_planned

    def noted(motion: Motion, bounds: JointBounds, effort: Effort | None, ticks: Ticks) -> Reference:
        found.append(ticks.period)
        return look(motion, bounds, effort, ticks)

    monkeypatch.setattr(evaluated, "as_planned", noted)
    monkeypatch.setattr(reached_speeds, "helpful_limits", lambda *_: ())  # it plans slow moves again
    return found


def zigzag(side: float) -> MotionPlan:
    """Return the plan of lines around a corner and back, which joints cannot follow as the tool could."""
    ways = (-side, 0.0, 0.0), (-side, side, 0.0), (0.0, side, 0.0), (0.0, 0.0, 0.0)
    return planned_stretch([lin(shifted(CORNER, *way), QUICK) for way in ways], STARTED, JERKLESS)


@pytest.mark.parametrize("first", [1e-3, 4e-3, 20e-3])
def test_lines_are_looked_at_first_at_a_few_ticks_and_last_at_each(
    first: float, periods: list[float], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(retiming, "_FIRST_SPACING", first)
    monkeypatch.setattr(retiming, "_FEWEST_TICKS", 8)
    planned = zigzag(0.2)
    assert periods == [pytest.approx(first), *[planned.period] * (len(periods) - 1)]
    assert len(periods) > 1  # joints could not follow at first
    assert max(shares(ARM, planned, Payload()).values()) <= WITHIN


def test_short_motions_are_looked_at_at_each_tick_at_once(
    periods: list[float], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(retiming, "_FEWEST_TICKS", 150)
    planned = zigzag(1e-3)
    assert planned.duration < retiming._FEWEST_TICKS * retiming._FIRST_SPACING
    assert set(periods) == {planned.period}


def test_a_ptp_move_within_the_limits_is_looked_at_at_each_tick_as_well(periods: list[float]) -> None:
    planned = planned_stretch([ptp(tuple((STARTED + 1.0).tolist()))], STARTED, OF_PUMA)
    assert periods == [pytest.approx(4 * planned.period), planned.period]
    assert max(shares(PUMA, planned, Payload()).values()) <= WITHIN


@pytest.mark.parametrize("side", [0.05, 0.1, 0.2])
def test_how_densely_lines_are_looked_at_first_costs_no_time(
    side: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked = zigzag(side).duration
    monkeypatch.setattr(retiming, "_FIRST_SPACING", 1e-3)
    assert asked <= 1.001 * zigzag(side).duration
