"""Collisions and the least distance of a run: lines for a terminal, and a section of the HTML report."""

import textwrap
from collections.abc import Iterator, Sequence

from ropsim.core import plural
from ropsim.flow import Clearance, Contact, RunFacts, WayFacts, body_title
from ropsim.views.markup.markup import table, text
from ropsim.views.words.characters import clean, fit
from ropsim.views.words.figures import seconds

COLUMNS = 80
INDENT = 13
MOST = 100
"""Maximum number of contacts listed in a report."""
NOTHING = "no body with a known shape is beside the robot"
UNSEEN = "no shape is known of"
MET = "not checked, in each other at the start or drawn so"


def way_lines(facts: RunFacts) -> list[str]:
    """Return the lines on collisions and clearance; none where collisions were not checked."""
    if facts.ways is None:
        return []
    near = facts.ways.clearance
    word = "collision" if near is not None and near.distance < 0.0 else "nearest"
    first = NOTHING if near is None else f"{_distance(near.distance)}: {clean(_bodies(near))}"
    lines = [fit(f"{word:<{INDENT}}{first}", COLUMNS)]
    if near is not None:
        lines.append(f"{'':<{INDENT}}{', '.join(_when(near, facts))}")
    for entry in _unchecked(facts.ways):
        lines += textwrap.wrap(
            clean(entry), COLUMNS, initial_indent=" " * INDENT, subsequent_indent=" " * INDENT
        )
    return lines


def ways_section(facts: RunFacts) -> str:
    """Return the section of the HTML report; nothing where collisions were not checked."""
    ways = facts.ways
    if ways is None:
        return ""
    shown = f"<p>{NOTHING.capitalize()}.</p>\n"
    if ways.clearance is not None:
        near = ways.clearance
        cells = (text(_bodies(near)), _distance(near.distance), seconds(near.time), _line(near))
        header = ("bodies", "distance", "at t [s]", "line", "station")
        caption = "Least distance of the run; bodies of one robot do not count."
        shown = table(caption, header, [(*cells, text(near.station))])
    shown += _contacts("Collisions.", "depth", ways.contacts)
    shown += _contacts("May collide between two recorded times.", "depth", ways.undecided)
    shown += _contacts(f"Nearer than the required {1e3 * ways.required:g} mm.", "distance", ways.near)
    left = "".join(f"<p>{text(entry)}.</p>\n" for entry in _unchecked(ways))
    return f"<section><h2>Collisions and clearance</h2>\n{shown}{left}</section>\n"


def _contacts(caption: str, figure: str, contacts: Sequence[Contact]) -> str:
    """Return a table of contacts; nothing for none."""
    if not contacts:
        return ""
    header = ("bodies", figure, "from t [s]", "until t [s]", "worst at t [s]", "line", "pass", "station")
    rows = [
        (
            text(_bodies(one)),
            _millimetres(one.distance),
            seconds(one.begin),
            seconds(one.end),
            seconds(one.time),
            _line(one),
            str(one.visit or ""),
            text(one.station),
        )
        for one in contacts[:MOST]
    ]
    more = len(contacts) - len(rows)
    return table(caption, header, rows) + (f"<p>And {plural(more, 'contact')} more.</p>\n" if more else "")


def _bodies(near: Clearance | Contact) -> str:
    return f"{body_title(near.one)} – {body_title(near.other)}"


def _line(near: Clearance | Contact) -> str:
    return str(near.line) if near.line else ""


def _millimetres(distance: float) -> str:
    return f"{abs(1e3 * distance):.1f} mm"


def _distance(distance: float) -> str:
    """Return a distance in words, a negative one as a depth."""
    words = " deep" if distance < 0.0 else ", touching" if distance == 0.0 else ""
    return f"{_millimetres(distance)}{words}"


def _when(near: Clearance, facts: RunFacts) -> Iterator[str]:
    """Yield when it was, on which line, and of which station where there are several."""
    yield f"at t = {seconds(near.time)} s"
    if near.line:
        yield f"line {near.line}"
    if near.station and len(facts.stations) > 1:
        yield f"station {clean(near.station)}"


def _unchecked(ways: WayFacts) -> Iterator[str]:
    """Yield sentences without their stops on omitted checks."""
    if ways.unseen:
        yield f"{UNSEEN} {', '.join(ways.unseen)}"
    if ways.met:
        yield f"{MET}: {', '.join(f'{each.one} and {each.other}' for each in ways.met)}"
