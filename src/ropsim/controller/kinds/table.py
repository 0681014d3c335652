"""The kinds of tool paths by the words of the instructions."""

from collections.abc import Callable, Mapping
from types import MappingProxyType

from ropsim.controller.kinds.circ import circ
from ropsim.controller.kinds.lin import lin
from ropsim.controller.kinds.request import PathRequest
from ropsim.controller.kinds.spline import spline
from ropsim.core import Diagnostic
from ropsim.flow import MotionKind
from ropsim.motion import ToolPath

ToolPathMaker = Callable[[PathRequest], ToolPath | tuple[Diagnostic, ...] | None]
"""Makes a path, says why there is none, or returns None where nothing would move."""

TOOL_PATHS: Mapping[str, ToolPathMaker] = MappingProxyType(
    {MotionKind.LIN: lin, MotionKind.CIRC: circ, MotionKind.SPLINE: spline}
)
"""A new kind is a file beside `lin.py` and an entry here; a planner may be given a table of its own."""
