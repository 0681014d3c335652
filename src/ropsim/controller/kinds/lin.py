"""LIN: the straight line."""

from ropsim.controller.kinds.request import PathRequest
from ropsim.core import Diagnostic
from ropsim.motion import Line, ToolPath, is_length


def lin(request: PathRequest) -> ToolPath | tuple[Diagnostic, ...] | None:
    """Return the straight line from start to end; None where they are one pose."""
    if not is_length(request.X_start, request.X_end):
        return None
    return Line(request.X_start, request.X_end, request.orientation)
