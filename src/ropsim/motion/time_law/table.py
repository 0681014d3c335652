"""Time laws by name: another one is a file and an entry here."""

from collections.abc import Mapping

from ropsim.motion.time_law.jerk_limited import jerk_limited
from ropsim.motion.time_law.law import TimeLawPlanner
from ropsim.motion.time_law.trapezoidal import ACCELERATION_RISE, trapezoidal

JERK_LIMITED = "jerk-limited"
TRAPEZOIDAL = "trapezoidal"
TIME_LAWS: Mapping[str, TimeLawPlanner] = {JERK_LIMITED: jerk_limited, TRAPEZOIDAL: trapezoidal}
"""Name of a law -> its planner."""
ACCELERATION_RISES: Mapping[str, float] = {TRAPEZOIDAL: ACCELERATION_RISE}
"""Name of a law whose accelerations go in steps -> time in which those of the joints come up [s]."""
