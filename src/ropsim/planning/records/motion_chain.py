"""The entities of the slow side of the controller, together."""

from dataclasses import dataclass, field

from ropsim.flow import ModalState
from ropsim.model import ControllerModel, RobotModel
from ropsim.motion import JERK_LIMITED
from ropsim.planning.records.entities import (
    FineInterpolation,
    Interpolator,
    InverseTransform,
    JointInterpolator,
    PathCorrector,
    PathPlanner,
    every_tick,
)
from ropsim.planning.records.path_corrector import StandardPathCorrector
from ropsim.planning.records.work_frames import WorkFrames
from ropsim.spatial import Pose


@dataclass(frozen=True, slots=True, eq=False)
class MotionChain:
    """The entities between a move instruction and the joint controller, in series.

    Attributes:
        planner: move instruction to path.
        interpolator: path of the tool to pose setpoints.
        inverse: pose setpoints to joint samples.
        joint_interpolator: joint samples to a path of the joints.
        robot: the arm.
        controller: rates, limits, how far it looks ahead.
        corrector: shifts paths by sensor readings during execution.
        work: tools and task frames of the cell.
        time_law: name of the law by which paths are timed, see `motion.TIME_LAWS`.
        fine: references of the joints at control ticks from those of the trajectory.
    """

    planner: PathPlanner
    interpolator: Interpolator
    inverse: InverseTransform
    joint_interpolator: JointInterpolator
    robot: RobotModel
    controller: ControllerModel
    corrector: PathCorrector = field(default_factory=StandardPathCorrector)
    work: WorkFrames = field(default_factory=WorkFrames)
    time_law: str = JERK_LIMITED
    fine: FineInterpolation = every_tick

    def tool_pose(self, modal: ModalState) -> Pose:
        """Return X_MT of the tool in force; of the mechanical interface itself where the tool is unknown."""
        X_MT = self.work.tool_pose(modal, None)
        return X_MT if isinstance(X_MT, Pose) else Pose()
