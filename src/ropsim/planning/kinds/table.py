"""The kinds of tool paths by the words of the instructions."""

from collections.abc import Callable, Mapping
from types import MappingProxyType

from ropsim.core import Diagnostic
from ropsim.flow import MotionKind
from ropsim.motion import ToolPath
from ropsim.planning.kinds.circ import circ
from ropsim.planning.kinds.lin import lin
from ropsim.planning.kinds.request import PathRequest
from ropsim.planning.kinds.spline import spline

ToolPathMaker = Callable[[PathRequest], ToolPath | tuple[Diagnostic, ...] | None]
"""Makes a path, says why there is none, or returns None where nothing would move."""

TOOL_PATHS: Mapping[str, ToolPathMaker] = MappingProxyType(
    {MotionKind.LIN: lin, MotionKind.CIRC: circ, MotionKind.SPLINE: spline}
)
"""A new kind is a file next to `lin.py` and an entry here; a planner may have its own table."""
