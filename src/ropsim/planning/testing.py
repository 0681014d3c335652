"""Door for tests: names behind the front of the package. Production code does not import it."""

from ropsim.planning.blends.blend import Stop as Stop
from ropsim.planning.blends.blend import blend_between as blend_between
from ropsim.planning.joint_limits.arm_limits import ArmBounds as ArmBounds
from ropsim.planning.moves.planned_move import PlannedMove as PlannedMove
from ropsim.planning.moves.planned_move import planned_move_of as planned_move_of
from ropsim.planning.trajectory.sections import Section as Section
from ropsim.planning.trajectory.sections import sections_of as sections_of
from ropsim.planning.trajectory.segments import segments_of as segments_of
from ropsim.planning.trajectory.timing import Timing as Timing
from ropsim.planning.trajectory.timing import timing_of as timing_of
from ropsim.planning.trajectory.trajectory import Trajectory as Trajectory
