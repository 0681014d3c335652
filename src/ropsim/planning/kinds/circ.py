"""CIRC: the arc of a circle through a via point."""

from ropsim.core import Diagnostic
from ropsim.motion import NO_ARC, ArcFault, ToolPath, arc
from ropsim.planning.kinds.request import PathRequest
from ropsim.planning.records.wording import passes


def circ(request: PathRequest) -> ToolPath | tuple[Diagnostic, ...] | None:
    """Return the arc from the start through the via point to the end, or by an angle; else M566."""
    move = request.move
    if len(request.via) != 1:
        return (_fault(request, f"the arc has {len(request.via)} via points, allowed is one"),)
    found = arc(request.X_start, request.via[0], request.X_end, mode=request.orientation, angle=move.angle)
    return (_fault(request, found.value),) if isinstance(found, ArcFault) else found


def _fault(request: PathRequest, why: str) -> Diagnostic:
    origin = request.move.origin
    return NO_ARC.at(
        origin.span,
        f"there is no arc: {why}",
        label=passes(origin),
        hint="give a via point well between start and end, beside the line through them; or use `lin`",
        data=origin.data,
    )
