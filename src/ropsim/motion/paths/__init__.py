"""Paths: ways of the tool and of the joints over their own length, their sections, and what joins them."""

from ropsim.motion.paths.path import STANDS as STANDS
from ropsim.motion.paths.path import STILL as STILL
from ropsim.motion.paths.path import JointPath as JointPath
from ropsim.motion.paths.path import JointPoints as JointPoints
from ropsim.motion.paths.path import Path as Path
from ropsim.motion.paths.path import ToolPath as ToolPath
from ropsim.motion.paths.path import ToolPoints as ToolPoints
