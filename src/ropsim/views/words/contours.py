"""Names of contours."""

from ropsim.views.accuracy import ContourFigures


def contour_name(one: ContourFigures) -> str:
    """Return what a contour is called: its task, lines and pass."""
    first, last = one.lines
    lines = f"line {first}" if first == last else f"lines {min(first, last)} to {max(first, last)}"
    named = f"{one.task}, {lines}" if one.task and one.task != "main" else lines
    return f"{named}, pass {one.visit}" if one.visit > 1 else named
