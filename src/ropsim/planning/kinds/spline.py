"""SPLINE: a smooth curve through points."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from ropsim.core import Diagnostic
from ropsim.motion import NO_SPLINE, SplineFault, ToolPath
from ropsim.motion import spline as spline_through
from ropsim.planning.kinds.request import PathRequest
from ropsim.planning.records.wording import passes
from ropsim.spatial import Pose

_SAME_POSITION = 1e-6
"""Points count as one within this distance [m], as points in the text do (T393)."""


def spline(request: PathRequest) -> ToolPath | tuple[Diagnostic, ...] | None:
    """Return the curve from the start through all via points to the end; else M567.

    A first point where the tool stands is no further one.
    """
    if twice := _given_twice((*request.via, request.X_end)):
        return (_fault(request, twice, "leave one of them out"),)
    found = spline_through((request.X_start, *request.via, request.X_end))
    if not isinstance(found, SplineFault):
        return found
    hint = "give points that differ from one another"
    if found is SplineFault.WHIRLS:
        hint = "put these points further apart, or spread the turn over more of them"
    return (_fault(request, found.value, hint),)


def _given_twice(points: Sequence[Pose]) -> str:
    """Return which neighbours are at one place, as the compiler says it of constants; empty for none."""
    for number, (one, other) in enumerate(pairwise(points), 1):
        if np.linalg.norm(other.position - one.position) <= _SAME_POSITION:
            last = "the target" if number + 1 == len(points) else f"point {number + 1}"
            return f"point {number} and {last} are at one place"
    return ""


def _fault(request: PathRequest, why: str, hint: str) -> Diagnostic:
    origin = request.move.origin
    return NO_SPLINE.at(
        origin.span,
        f"there is no curve through the points: {why}",
        label=passes(origin),
        hint=hint,
        data=origin.data,
    )
