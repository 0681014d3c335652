"""LIN: the straight line."""

from ropsim.core import Diagnostic
from ropsim.motion import Line, ToolPath
from ropsim.planning.kinds.request import PathRequest


def lin(request: PathRequest) -> ToolPath | tuple[Diagnostic, ...] | None:
    """Return the straight line from start to end; None where they are one pose."""
    line = Line(request.X_start, request.X_end, request.orientation)
    return line if line.length > 0.0 else None
