"""Time laws of sections as long, uneven and short-sighted as they come: no step, no bound exceeded."""

from collections.abc import Sequence

import numpy as np
import pytest

from ropsim import robots
from ropsim.motion import JERK_LIMITED, TIME_LAWS, TimeLaw, jerk_limited
from ropsim.planning import MotionState, plan
from ropsim.spatial import Array
from support.random_limits import LimitsInRows, excess_of, random_limits
from support.random_short_lines import random_short_lines

ROUNDING = 1e-9  # relative to the greatest, or to the bound
LENGTH = 1e-12  # relative; a phase ends where the next one begins


def keeps_the_laws(limits: LimitsInRows) -> None:
    """Assert the laws of motion for one path segment per path limit, and that path segments do not matter."""
    bounds = limits.bounds
    law = jerk_limited(bounds, np.ones(len(bounds)))
    found = excess_of(bounds, law)
    assert max(found) <= ROUNDING, found
    assert found.length <= LENGTH, found
    follows_itself(bounds, law)
    is_expressed_by(law, limits)


def follows_itself(bounds: Array, law: TimeLaw) -> None:
    """Assert that phases lead from the start of the first path limit to the end of the last, in order."""
    number, times, s, _, _, _, h, s_end = law.segments
    assert (h > 0.0).all()
    assert sorted(set(number.tolist())) == list(range(len(bounds)))
    same = number[1:] == number[:-1]
    assert (np.diff(number) >= 0.0).all()
    assert times[0] == s[0] == 0.0
    assert (s[1:] == np.where(same, s_end[:-1], 0.0)).all()
    assert (s_end[np.append(~same, True)] == bounds[:, 0]).all()
    assert (np.abs(np.append(times[1:], law.duration) - times - h) <= LENGTH * law.duration).all()


def is_expressed_by(law: TimeLaw, limits: LimitsInRows) -> None:
    """Assert that longer path segments have the same motion."""
    bounds, counts = limits.bounds, limits.counts.astype(int)
    longer = jerk_limited(*limits)
    row = law.segments[0].astype(int)
    last = np.cumsum(counts) - 1
    gone = np.cumsum(bounds[:, 0]) - bounds[:, 0]
    gone -= np.repeat(gone[np.append(0, last[:-1] + 1)], counts)
    assert (longer.segments[[1, 3, 4, 5, 6]] == law.segments[[1, 3, 4, 5, 6]]).all()
    assert (longer.segments[0] == np.repeat(np.arange(len(counts)), counts)[row]).all()
    far = np.abs(longer.segments[[2, 7]] - law.segments[[2, 7]] - gone[row])
    assert (far <= LENGTH * bounds[:, 0].sum()).all()
    assert (longer.ends == law.ends[last]).all()


@pytest.mark.parametrize("first", range(0, 400, 50))
def test_a_section_has_no_steps_and_exceeds_no_bound(first: int) -> None:
    for seed in range(first, first + 50):
        keeps_the_laws(random_limits(np.random.default_rng(seed)))


@pytest.mark.slow
@pytest.mark.parametrize("first", range(1000, 21000, 1000))
def test_twenty_thousand_sections_have_no_steps_and_exceed_no_bound(first: int) -> None:
    for seed in range(first, first + 1000):
        keeps_the_laws(random_limits(np.random.default_rng(seed)))


def sections_of_lines(
    seeds: Sequence[int], robot: str, monkeypatch: pytest.MonkeyPatch
) -> list[LimitsInRows]:
    """Return the path limits of all sections that are timed while chains of short lines are planned."""
    found = list[LimitsInRows]()

    def noted(bounds: Array, counts: Array) -> TimeLaw:
        found.append(LimitsInRows(bounds.copy(), counts.copy()))
        return TIME_LAWS[JERK_LIMITED](bounds, counts)

    monkeypatch.setattr("ropsim.planning.planning.TIME_LAWS", {JERK_LIMITED: noted})
    for seed in seeds:
        chain, moves, start = random_short_lines(np.random.default_rng(seed), robots.load(robot))
        plan(chain, moves, MotionState.at_rest(start))
    return found


@pytest.mark.slow
@pytest.mark.parametrize("robot", ["irb120", "ur5e"])
@pytest.mark.parametrize("first", range(0, 150, 30))
def test_sections_of_short_lines_have_no_steps_and_exceed_no_bound(
    first: int, robot: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    sections = sections_of_lines(range(first, first + 30), robot, monkeypatch)
    assert len(sections) >= 30
    for limits in sections:
        keeps_the_laws(limits)
