"""What was seen on the ways of a run: lines for a terminal, and a section of the HTML report."""

import textwrap
from collections.abc import Iterator

from ropsim.flow import Clearance, RunFacts, WayFacts
from ropsim.views.characters import clean, fit
from ropsim.views.figures import seconds
from ropsim.views.markup import table, text

COLUMNS = 80
INDENT = 13
NOTHING = "nothing moved against anything of a known shape"
UNSEEN = "no shape is known of"
MET = "not looked at, since they are in each other at the start or drawn so"


def way_lines(facts: RunFacts) -> list[str]:
    """Return the lines on the ways of a run; none where nobody looked for collisions."""
    if facts.ways is None:
        return []
    near = facts.ways.clearance
    first = NOTHING
    if near is not None:
        first = f"{_distance(near)}: {clean(near.one)} and {clean(near.other)}"
    lines = [fit(f"{'nearest':<{INDENT}}{first}", COLUMNS)]
    if near is not None:
        lines.append(f"{'':<{INDENT}}{', '.join(_when(near, facts))}")
    for entry in _not_looked_at(facts.ways):
        lines += textwrap.wrap(
            clean(entry), COLUMNS, initial_indent=" " * INDENT, subsequent_indent=" " * INDENT
        )
    return lines


def ways_section(facts: RunFacts) -> str:
    """Return the section of the HTML report; nothing where nobody looked for collisions."""
    if facts.ways is None:
        return ""
    near, shown = facts.ways.clearance, f"<p>{NOTHING.capitalize()}.</p>\n"
    if near is not None:
        bodies = f"{text(near.one)} and {text(near.other)}"
        line = str(near.line) if near.line else ""
        cells = (bodies, _distance(near), seconds(near.time), line, text(near.station))
        header = ("bodies", "distance", "at t [s]", "line", "station")
        shown = table("Least distance of the run; bodies of one robot do not count.", header, [cells])
    left = "".join(f"<p>{text(entry)}.</p>\n" for entry in _not_looked_at(facts.ways))
    return f"<section><h2>Ways</h2>\n{shown}{left}</section>\n"


def _distance(near: Clearance) -> str:
    """Return a distance in words, a negative one as a depth."""
    millimetres = round(near.distance * 1e3, 1)
    return f"{abs(millimetres):.1f} mm{' in each other' if millimetres < 0.0 else ''}"


def _when(near: Clearance, facts: RunFacts) -> Iterator[str]:
    """Yield when it was, on which line, and of which station where there are several."""
    yield f"at t = {seconds(near.time)} s"
    if near.line:
        yield f"line {near.line}"
    if near.station and len(facts.stations) > 1:
        yield f"station {clean(near.station)}"


def _not_looked_at(ways: WayFacts) -> Iterator[str]:
    """Yield sentences without their stops on what was not looked at."""
    if ways.unseen:
        yield f"{UNSEEN} {', '.join(ways.unseen)}"
    if ways.met:
        yield f"{MET}: {', '.join(f'{each.one} and {each.other}' for each in ways.met)}"
