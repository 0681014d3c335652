"""Kinds of tool paths: one file each, and the table that names them."""

from ropsim.planning.kinds.request import PathRequest as PathRequest
from ropsim.planning.kinds.table import TOOL_PATHS as TOOL_PATHS
from ropsim.planning.kinds.table import ToolPathMaker as ToolPathMaker
