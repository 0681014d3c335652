"""Paths: ways of the tool and of the joints over their own length, their sections, and what joins them."""

from ropsim.motion.paths.corner import CornerFault as CornerFault
from ropsim.motion.paths.corner import corner as corner
from ropsim.motion.paths.curve import Curve as Curve
from ropsim.motion.paths.differences import numeric_points as numeric_points
from ropsim.motion.paths.joint_blend import JointBlend as JointBlend
from ropsim.motion.paths.joint_blend import joint_blend as joint_blend
from ropsim.motion.paths.joint_line import JointLine as JointLine
from ropsim.motion.paths.line import Line as Line
from ropsim.motion.paths.orientation import ToolTurn as ToolTurn
from ropsim.motion.paths.orientation import TurnPoints as TurnPoints
from ropsim.motion.paths.orientation import tool_turn as tool_turn
from ropsim.motion.paths.path import STANDS as STANDS
from ropsim.motion.paths.path import STILL as STILL
from ropsim.motion.paths.path import JointPath as JointPath
from ropsim.motion.paths.path import JointPoints as JointPoints
from ropsim.motion.paths.path import Path as Path
from ropsim.motion.paths.path import ToolPath as ToolPath
from ropsim.motion.paths.path import ToolPoints as ToolPoints
from ropsim.motion.paths.section import JointSection as JointSection
from ropsim.motion.paths.section import ToolSection as ToolSection
from ropsim.motion.paths.traced import Traced as Traced
from ropsim.motion.paths.zone import enter as enter
from ropsim.motion.paths.zone import leave as leave
from ropsim.motion.paths.corner import CornerFault as CornerFault
from ropsim.motion.paths.corner import corner as corner
from ropsim.motion.paths.curve import Curve as Curve
