"""Lines of a run of commands: tasks of the program have theirs in its text, commands have no lines there."""

from dataclasses import replace

import numpy as np

from ropsim.core import Diagnostic, Span
from ropsim.flow import Channel, Event, Recording
from ropsim.workbench import SESSION, Session


def in_program(session: Session) -> Recording:
    """Return the recording of a session on the lines of the program of its project.

    Actions of a command have no line there; actions of a task of the program have the line of that task.
    """
    recording = session.recording
    program = session.project.program().source.name
    last = session.prelude.count("\n") + 1

    def there(span: Span | None) -> Span | None:
        if span is None or span.source != SESSION:
            return span
        return replace(span, source=program) if span.line <= last else None

    def event(one: Event) -> Event:
        return replace(one, origin=one.origin and replace(one.origin, span=there(one.origin.span)))

    def finding(one: Diagnostic) -> Diagnostic:
        return replace(one, span=there(one.span))

    channels, stations = dict(recording.channels), list(recording.facts.stations)
    for number, station in enumerate(stations):
        if station.source == SESSION:
            stations[number] = replace(station, source=program)
            name = recording.facts.channel("line", station.name)
            channels[name] = _up_to(channels[name], last)
    return replace(
        recording,
        channels=channels,
        events=tuple(map(event, recording.events)),
        findings=tuple(map(finding, recording.findings)),
        facts=replace(recording.facts, stations=tuple(stations)),
    )


def _up_to(channel: Channel, last: int) -> Channel:
    """Return a channel of lines without the lines behind one."""
    return replace(channel, values=np.where(channel.values > last, 0, channel.values))
