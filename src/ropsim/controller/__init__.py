"""The generic controller: path planner, interpolator, inverse transform, joint interpolation and control."""

from ropsim.controller.chain import MotionChain as MotionChain
from ropsim.controller.chain import PlannedMove as PlannedMove
from ropsim.controller.chain import plan_move as plan_move
from ropsim.controller.chain import standard_chain as standard_chain
from ropsim.controller.entities import Interpolator as Interpolator
from ropsim.controller.entities import InverseTransform as InverseTransform
from ropsim.controller.entities import JointInterpolator as JointInterpolator
from ropsim.controller.entities import PathPlanner as PathPlanner
from ropsim.controller.entities import Refusal as Refusal
from ropsim.controller.entities import Sample as Sample
from ropsim.controller.entities import SensorInterface as SensorInterface
from ropsim.controller.interpolator import StandardInterpolator as StandardInterpolator
from ropsim.controller.inverse_transform import StandardInverseTransform as StandardInverseTransform
from ropsim.controller.joint_controller import CompiledLaw as CompiledLaw
from ropsim.controller.joint_controller import PythonLaw as PythonLaw
from ropsim.controller.joint_controller import cascaded_p_pi as cascaded_p_pi
from ropsim.controller.joint_controller import external_law as external_law
from ropsim.controller.joint_controller import law_of as law_of
from ropsim.controller.joint_interpolator import SplineJointInterpolator as SplineJointInterpolator
from ropsim.controller.law_diagnostics import GainError as GainError
from ropsim.controller.path_planner import StandardPathPlanner as StandardPathPlanner
from ropsim.controller.sensor_interface import ScriptedSensors as ScriptedSensors
from ropsim.controller.sensor_interface import with_change as with_change
from ropsim.controller.work_frames import WorkFrames as WorkFrames
