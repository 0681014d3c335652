"""Kinds of tool paths: one file each, and the table that names them."""

from ropsim.controller.kinds.request import PathRequest as PathRequest
from ropsim.controller.kinds.table import TOOL_PATHS as TOOL_PATHS
from ropsim.controller.kinds.table import ToolPathMaker as ToolPathMaker
