"""Static descriptions: arm, drives, controller, work cell. Immutable; a run keeps its own state."""

from ropsim.model.cell import Cell as Cell
from ropsim.model.cell import ClassicSettings as ClassicSettings
from ropsim.model.cell import Gripper as Gripper
from ropsim.model.cell import Part as Part
from ropsim.model.cell import Signal as Signal
from ropsim.model.cell import Sink as Sink
from ropsim.model.cell import Tool as Tool
from ropsim.model.controller import CascadedGains as CascadedGains
from ropsim.model.controller import ControllerKind as ControllerKind
from ropsim.model.controller import ControllerModel as ControllerModel
from ropsim.model.controller import PathDefaults as PathDefaults
from ropsim.model.controller import Rates as Rates
from ropsim.model.drive import Amplifier as Amplifier
from ropsim.model.drive import DcMotor as DcMotor
from ropsim.model.drive import Drive as Drive
from ropsim.model.drive import Friction as Friction
from ropsim.model.payload import Payload as Payload
from ropsim.model.payload import box as box
from ropsim.model.payload import combine as combine
from ropsim.model.robot import DhRow as DhRow
from ropsim.model.robot import Joint as Joint
from ropsim.model.robot import JointType as JointType
from ropsim.model.robot import Link as Link
from ropsim.model.robot import ParameterOrigin as ParameterOrigin
from ropsim.model.robot import RobotModel as RobotModel
