"""Planning: move instructions become a trajectory within all limits, or a refusal that says why not."""

from ropsim.planning.achieved.zones import NEXT_IS_SKIPPED as NEXT_IS_SKIPPED
from ropsim.planning.achieved.zones import stopped_by as stopped_by
from ropsim.planning.chain import plan_move as plan_move
from ropsim.planning.chain import standard_chain as standard_chain
from ropsim.planning.chain import work_frames as work_frames
from ropsim.planning.entity_checks.entity_faults import ENTITY_FAILS as ENTITY_FAILS
from ropsim.planning.entity_checks.entity_faults import entity_fails as entity_fails
from ropsim.planning.entity_checks.entity_faults import guarded as guarded
from ropsim.planning.entity_checks.entity_faults import is_our_own as is_our_own
from ropsim.planning.entity_checks.entity_faults import raised as raised
from ropsim.planning.entity_checks.entity_faults import refused as refused
from ropsim.planning.joint_limits.arm_limits import arm_bounds as arm_bounds
from ropsim.planning.joint_limits.binding import binding_constraints as binding_constraints
from ropsim.planning.kinds import TOOL_PATHS as TOOL_PATHS
from ropsim.planning.kinds import PathRequest as PathRequest
from ropsim.planning.kinds import ToolPathMaker as ToolPathMaker
from ropsim.planning.moves.interpolator import StandardInterpolator as StandardInterpolator
from ropsim.planning.moves.inverse_transform import StandardInverseTransform as StandardInverseTransform
from ropsim.planning.moves.joint_interpolator import StandardJointInterpolator as StandardJointInterpolator
from ropsim.planning.moves.path_planner import StandardPathPlanner as StandardPathPlanner
from ropsim.planning.planning import ordered as ordered
from ropsim.planning.planning import plan as plan
from ropsim.planning.planning import timed as timed
from ropsim.planning.postures.damped_inverse import DampedInverseTransform as DampedInverseTransform
from ropsim.planning.records.coordination import Coordination as Coordination
from ropsim.planning.records.entities import Interpolator as Interpolator
from ropsim.planning.records.entities import InverseTransform as InverseTransform
from ropsim.planning.records.entities import JointInterpolator as JointInterpolator
from ropsim.planning.records.entities import PathCorrector as PathCorrector
from ropsim.planning.records.entities import PathPlanner as PathPlanner
from ropsim.planning.records.entities import Refusal as Refusal
from ropsim.planning.records.entities import Sample as Sample
from ropsim.planning.records.entities import SensorInterface as SensorInterface
from ropsim.planning.records.motion_chain import MotionChain as MotionChain
from ropsim.planning.records.motion_plan import MotionPlan as MotionPlan
from ropsim.planning.records.motion_plan import MotionSequence as MotionSequence
from ropsim.planning.records.motion_plan import MotionState as MotionState
from ropsim.planning.records.motion_plan import TimedMove as TimedMove
from ropsim.planning.records.moving_frames import MovingFrame as MovingFrame
from ropsim.planning.records.path_corrector import (
    ProportionalIntegralCorrector as ProportionalIntegralCorrector,
)
from ropsim.planning.records.path_corrector import StandardPathCorrector as StandardPathCorrector
from ropsim.planning.records.planned_path import MoveLimits as MoveLimits
from ropsim.planning.records.planned_path import PlannedPath as PlannedPath
from ropsim.planning.records.sensed_cell import ArmState as ArmState
from ropsim.planning.records.sensed_cell import NothingSensed as NothingSensed
from ropsim.planning.records.sensed_cell import SensedBefore as SensedBefore
from ropsim.planning.records.sensed_cell import SensedCell as SensedCell
from ropsim.planning.records.trigger_ticks import PlannedTrigger as PlannedTrigger
from ropsim.planning.records.work_frames import WorkFrames as WorkFrames
from ropsim.planning.records.work_frames import inverted as inverted
from ropsim.planning.sequence_checks import PLANNED_ACCELERATION as PLANNED_ACCELERATION
from ropsim.planning.sequence_checks import PLANNED_SPEED as PLANNED_SPEED
from ropsim.planning.trajectory.sections import TimingRules as TimingRules
