"""A step by which a run gets slower where joints cannot follow."""

import numpy as np
import pytest

from ropsim.motion import ROUNDING, JointBounds, Ticks
from ropsim.planning.testing import (
    Aim,
    ArmBounds,
    PlannedMove,
    Section,
    Trajectory,
    as_bounds_allow,
    limit_grid_of,
    planned_move_of,
    sections_of,
    segments_of,
    slower_section,
    timing_of,
)
from support.motion import CHAIN, PUMA, RULES, START, interface_pose, lin, shifted

TICK = 1e-3


def line(way: tuple[float, float, float]) -> tuple[Section, ...]:
    leg = planned_move_of(CHAIN, lin(shifted(interface_pose(START), *way)), START)
    assert isinstance(leg, PlannedMove)
    return sections_of(segments_of([leg], []), RULES)


@pytest.mark.parametrize("way", [(-0.1, 0.1, 0.0), (-0.06, -0.16, 0.15), (-0.19, -0.07, -0.26)])
@pytest.mark.parametrize("share", [0.05, 0.3])
def test_a_step_lowers_bounds_where_joints_cannot_follow_and_they_exceed_less_then(
    way: tuple[float, float, float], share: float
) -> None:
    (part,) = line(way)
    bounds = JointBounds(PUMA.max_speeds, share * PUMA.max_accelerations, share * PUMA.max_jerks)
    arm, motion = ArmBounds(bounds, None), Trajectory.on(timing_of([part], 1))
    before = as_bounds_allow(motion, arm, Ticks(TICK))
    over = np.flatnonzero((before.reference.utilisation.used > 1.0 + ROUNDING).any(axis=0))
    ticks = over[over > 0].astype(np.float64)
    assert len(ticks) > 0
    bands = limit_grid_of(part, np.linspace(0.0, part.law.duration, 80), 0.0)
    lower, slower = slower_section(motion, before.reference, 0, bands, ticks, Aim(arm, TICK, 0.999, RULES))
    after = as_bounds_allow(motion.timed(timing_of([slower], 1)), arm, Ticks(TICK))
    lowered = (lower.bounds < lower.planned).any(axis=0)
    assert (lower.bounds <= lower.planned).all()
    assert ((lower.causes[0] >= 0.0) == lowered).all()
    assert slower.law.duration > part.law.duration
    assert after.reference.utilisation.used.max() < before.reference.utilisation.used.max()
