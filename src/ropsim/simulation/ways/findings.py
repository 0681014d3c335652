"""Findings on contacts, one for a pair and line: errors on penetrations, warnings on too little clearance."""

from collections import defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import replace

from ropsim.core import Diagnostic, Kind, Span
from ropsim.flow import Contact, RunFacts, body_title
from ropsim.simulation.diagnostics.run_diagnostics import NOT_SEPARATED, PENETRATION, TOO_NEAR

_FILLED = "`{}` counts without its hollows, if it has any: what is in one of them is free in truth"
AROUND = "lead the arm around it by a point on the way, or move what is in the way"
DENSER = "lead the arm farther from it, or move slower there"
FARTHER = "lead the arm farther from it, or require less by `clearance` in `[cell]`"


def contact_findings(facts: RunFacts) -> tuple[Diagnostic, ...]:
    """Return the findings on the contacts of a run, in order of time; none where collisions were not checked.

    Args:
        facts: of the run.
    """
    if facts.ways is None:
        return ()
    deep = (_penetration(some, facts) for some in _groups(facts.ways.contacts))
    undecided = (_not_separated(some, facts) for some in _groups(facts.ways.undecided))
    near = (_too_near(some, facts) for some in _groups(facts.ways.near))
    return (*deep, *undecided, *near)


def without_contact_findings(findings: Iterable[Diagnostic]) -> Iterator[Diagnostic]:
    """Yield the findings that `contact_findings` did not make."""
    codes = {PENETRATION.code, NOT_SEPARATED.code, TOO_NEAR.code}
    return (one for one in findings if one.code not in codes)


def _groups(contacts: Iterable[Contact]) -> Iterator[list[Contact]]:
    """Yield the contacts of the same bodies on the same line."""
    found: dict[tuple[str, str, int], list[Contact]] = defaultdict(list)
    for one in contacts:
        found[one.bodies, one.station, one.line].append(one)
    yield from found.values()


def _penetration(some: list[Contact], facts: RunFacts) -> Diagnostic:
    deepest = min(some, key=lambda one: one.distance)
    words = f"collision {deepest.bodies}, {-1e3 * deepest.distance:.1f} mm deep{_where(some)}"
    return _finding(PENETRATION, words, AROUND, some, deepest, facts)


def _not_separated(some: list[Contact], facts: RunFacts) -> Diagnostic:
    deepest = min(some, key=lambda one: one.distance)
    depth = f"{-1e3 * deepest.distance:.1f} mm deep between two recorded times"
    words = f"{deepest.bodies} may collide: up to {depth}{_where(some)}"
    return _finding(NOT_SEPARATED, words, DENSER, some, deepest, facts)


def _too_near(some: list[Contact], facts: RunFacts) -> Diagnostic:
    nearest = min(some, key=lambda one: one.distance)
    required = facts.ways.required if facts.ways else 0.0
    words = f"clearance {nearest.bodies}, {max(1e3 * nearest.distance, 0.0):.1f} mm"
    words += f" of the required {1e3 * required:g} mm{_where(some)}"
    return _finding(TOO_NEAR, words, FARTHER, some, nearest, facts)


def _where(some: list[Contact]) -> str:
    """Return line and passes, such as `, line 17 (24 passes)`."""
    line = some[0].line
    passes = len({one.visit for one in some})
    count = f" ({passes} passes)" if passes > 1 else ""
    return f", line {line}{count}" if line else count


def _finding(
    kind: Kind, words: str, hint: str, some: list[Contact], worst: Contact, facts: RunFacts
) -> Diagnostic:
    station = facts.station(worst.station)
    programs = [each.source for each in facts.stations]
    source = station.source if station else ""
    shared = (f"at station `{worst.station}`",) if programs.count(source) > 1 else ()
    found = kind.at(
        Span.whole_line(source, worst.line) if source and worst.line else None,
        words,
        label=f"worst at t = {worst.time:.2f} s",
        hint=hint,
        data={
            "bodies": worst.bodies,
            "one": worst.one,
            "other": worst.other,
            "distance_m": worst.distance,
            "time_s": worst.time,
            "begin_s": worst.begin,
            "end_s": worst.end,
            "place_m": worst.place,
            "station": worst.station,
            "passes": tuple(sorted({one.visit for one in some} - {0})),
        },
    )
    filled = facts.ways.filled if facts.ways else ()
    meshes = tuple(_FILLED.format(body_title(name)) for name in (worst.one, worst.other) if name in filled)
    return replace(found, notes=(*shared, *meshes))
