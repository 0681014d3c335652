"""Identity of a run: its content, independent of line numbers in the text."""

import hashlib
import pickle
from collections.abc import Mapping
from dataclasses import replace
from itertools import zip_longest

import numpy as np

from ropsim.core import Diagnostic, Span
from ropsim.flow import Channel, Contact, Event, Recording, RunFacts, WayFacts
from ropsim.icr import Program, program_id
from ropsim.model import Cell
from ropsim.simulation import contact_findings, without_contact_findings
from ropsim.studio.wire.jobs import Fidelity, InputChange


def content_of(
    cell: Cell, codes: Mapping[str, Program], fidelity: Fidelity, inputs: tuple[InputChange, ...]
) -> str:
    """Return the key of a run: cell, programs without their source lines, fidelity and inputs.

    Comments, blank lines and names of the text have no part in it.

    Args:
        cell: where the program runs.
        codes: compiled, by station.
        fidelity: how it is run.
        inputs: that it is given.
    """
    # the records of a cell are made in the order of its file, so equal cells have equal bytes
    plain = pickle.dumps((cell, fidelity, inputs), protocol=5)
    programs = " ".join(program_id(code) for code in codes.values())
    return f"{programs} {hashlib.sha256(plain).hexdigest()}"


def moved_lines(before: Program, after: Program) -> Mapping[int, int]:
    """Return where the lines of a program stand in another text of the same program; unmoved ones left out.

    Args:
        before: compiled from the older text.
        after: the same code, compiled from the newer one.
    """
    moved: dict[int, int] = {}
    for old, new in zip_longest(before.procedures, after.procedures):
        if old is not None and new is not None:
            for line, there in zip(old.lines, new.lines, strict=False):
                moved.setdefault(line, there)
            for place, there_too in zip(old.places, new.places, strict=False):
                moved.setdefault(place.line, there_too.line)
    return {line: there for line, there in moved.items() if line > 0 and there > 0 and line != there}


def on_lines(recording: Recording, source: str, lines: Mapping[int, int]) -> Recording:
    """Return a recording with the lines of one text renumbered: events, findings and channels `line`.

    Args:
        recording: of a run.
        source: name of the text.
        lines: new number of each line that has moved.
    """
    if not lines:
        return recording

    def there(span: Span | None) -> Span | None:
        if span is None or span.source != source or span.line not in lines:
            return span
        by = lines[span.line] - span.line
        return replace(span, line=span.line + by, end_line=span.end_line + by)

    def event(one: Event) -> Event:
        return replace(one, origin=one.origin and replace(one.origin, span=there(one.origin.span)))

    def finding(one: Diagnostic) -> Diagnostic:
        return replace(one, span=there(one.span))

    channels = dict(recording.channels)
    facts = recording.facts
    for name in (facts.channel("line", one.name) for one in facts.stations if one.source == source):
        if name in channels:
            channels[name] = _renumbered(channels[name], lines)
    facts = replace(facts, ways=facts.ways and _ways_on_lines(facts, facts.ways, source, lines))
    return replace(
        recording,
        channels=channels,
        events=tuple(map(event, recording.events)),
        findings=(
            *(finding(one) for one in without_contact_findings(recording.findings)),
            *contact_findings(facts),
        ),
        facts=facts,
    )


def _ways_on_lines(facts: RunFacts, ways: WayFacts, source: str, lines: Mapping[int, int]) -> WayFacts:
    """Return the contacts of a run with the lines of one text renumbered."""
    own = {one.name for one in facts.stations if one.source == source}

    def contact(one: Contact) -> Contact:
        return replace(one, line=lines.get(one.line, one.line)) if one.station in own else one

    near = ways.clearance
    if near is not None and near.station in own:
        near = replace(near, line=lines.get(near.line, near.line))
    contacts, others = tuple(map(contact, ways.contacts)), tuple(map(contact, ways.near))
    undecided = tuple(map(contact, ways.undecided))
    return replace(ways, clearance=near, contacts=contacts, near=others, undecided=undecided)


def _renumbered(channel: Channel, lines: Mapping[int, int]) -> Channel:
    known, places = np.unique(channel.values, return_inverse=True)
    new = np.array([lines.get(int(value), value) for value in known], dtype=channel.values.dtype)
    return replace(channel, values=new[places])
