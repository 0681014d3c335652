"""SPLINE: a smooth curve through points."""

from ropsim.controller.kinds.request import PathRequest
from ropsim.controller.wording import passes
from ropsim.core import Diagnostic
from ropsim.motion import NO_SPLINE, SplineFault, ToolPath
from ropsim.motion import spline as spline_through


def spline(request: PathRequest) -> ToolPath | tuple[Diagnostic, ...] | None:
    """Return the curve from the start through all via points to the end; else M567."""
    found = spline_through((request.X_start, *request.via, request.X_end))
    if not isinstance(found, SplineFault):
        return found
    origin = request.move.origin
    finding = NO_SPLINE.at(
        origin.span,
        f"there is no curve through the points: {found.value}",
        label=passes(origin),
        hint="put these points further apart, or spread the turn over more of them"
        if found is SplineFault.WHIRLS
        else "give points that differ from one another",
        data={"pass": origin.visit},
    )
    return (finding,)
