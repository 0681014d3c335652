"""A step by which a run gets slower: the same on paths that compiled loops know and on others."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim.controller.bands import bands_of
from ropsim.controller.course import course_of
from ropsim.controller.fit import as_bounds_allow
from ropsim.controller.kept_limits import ArmBounds
from ropsim.controller.leg import Leg, leg_of
from ropsim.controller.parts import Part, parts_of
from ropsim.controller.pieces import pieces_of
from ropsim.controller.run_step import Aim, slower_run
from ropsim.controller.stretch_motion import StretchMotion
from ropsim.motion import ROUNDING, JointBounds, Ticks
from support.motion import CHAIN, PUMA, START, interface_pose, lin, shifted

AHEAD, TICK = 10, 1e-3


def line(way: tuple[float, float, float]) -> tuple[Part, ...]:
    leg = leg_of(CHAIN, lin(shifted(interface_pose(START), *way)), START)
    assert isinstance(leg, Leg)
    return parts_of(pieces_of([leg], []), AHEAD)


@pytest.mark.parametrize("way", [(-0.1, 0.1, 0.0), (-0.06, -0.16, 0.15), (-0.19, -0.07, -0.26)])
@pytest.mark.parametrize("share", [0.05, 0.3])
def test_a_step_on_known_paths_is_that_on_any_path(way: tuple[float, float, float], share: float) -> None:
    (part,) = line(way)
    bounds = JointBounds(PUMA.max_speeds, share * PUMA.max_accelerations, share * PUMA.max_jerks)
    arm, motion = ArmBounds(bounds, None), StretchMotion.on(course_of([part], 1))
    fit = as_bounds_allow(motion, arm, Ticks(TICK))
    over = np.flatnonzero((fit.reference.strain.used > 1.0 + ROUNDING).any(axis=0))
    ticks = over[over > 0].astype(np.float64)
    bands = bands_of(part, np.linspace(0.0, part.law.duration, 80), 0.0)
    aim = Aim(arm, TICK, 0.999, AHEAD)
    assert motion.table is not None
    assert len(ticks) > 0
    known = slower_run(motion, fit.reference, 0, bands, ticks, aim)
    other = slower_run(replace(motion, table=None), fit.reference, 0, bands, ticks, aim)
    assert known[0].share < 1.0
    assert known[0].share == pytest.approx(other[0].share, rel=1e-12)
    assert known[0].causes.tolist() == other[0].causes.tolist()
    np.testing.assert_allclose(known[0].bounds, other[0].bounds, rtol=1e-12)
    assert known[1].counts.tolist() == other[1].counts.tolist()
    np.testing.assert_allclose(known[1].law.segments, other[1].law.segments, rtol=1e-9, atol=1e-9)
