"""How long motions lasted in a trace, whatever the limits of the plan that is laid over it."""

import numpy as np
import pytest

from ropsim.calibration import MotionSettings, settings_of
from ropsim.calibration.comparing import compared
from ropsim.calibration.logged_sequence import duration
from ropsim.calibration.replanning import replanner
from ropsim.calibration.sequence_fit import placed
from support.logged_traces import logged, site

PROGRAM = """\
program main
units mm, deg, s
mov (500, -200, 300; down)
wait 0.2
lin (500, 0, 300; down)
wait 0.2
mov (350, 300, 500; down)
"""
NEAR = 0.004
"""Of the time of a motion: half a period of the log, at both ends."""
WRONG = 0.01
"""Of the time of a motion: what other jerks change at least here."""


@pytest.mark.parametrize("jerk", [0.6, 1.0, 1.6])
def test_a_duration_is_that_of_the_trace_under_other_jerks(jerk: float) -> None:
    """Ends that came from the plan would hide its error there."""
    made = site(PROGRAM)
    known = settings_of(made.station)
    factors = np.array([1.0, 1.0, jerk])
    other = MotionSettings(known.joints * factors[:, None], known.tool * factors[:, None], known.look_ahead)
    replan = replanner(made.cell, made.station, made.orders)
    found, count, _ = compared(
        replan, made.orders, known, made.station.robot.axis_joints, logged(made, known)
    )
    assert len(found) == count == 3
    for one in found:
        true, motion = replan(one.number, known), replan(one.number, other)
        assert true is not None
        assert motion is not None
        assert jerk == 1.0 or abs(motion.duration / true.duration - 1.0) > WRONG
        assert duration(one, motion, placed(one, other, motion).start) == pytest.approx(
            true.duration, rel=NEAR
        )
