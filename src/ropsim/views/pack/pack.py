"""The pack of a run: everything that a page needs to show it at any time, small enough to send and to keep.

docs/reference/pack.md describes it. Here are its plain header and the bytes of its columns; `records` makes
one file of them.
"""

import math
from collections.abc import Iterable, Mapping
from dataclasses import asdict, fields, is_dataclass
from enum import Enum

import numpy as np

from ropsim.core import Diagnostic, frozen_dataclass
from ropsim.flow import Event, Recording
from ropsim.model import Cell
from ropsim.spatial import Array
from ropsim.views.pack.bodies import packed_bodies
from ropsim.views.pack.channels import packed_channels
from ropsim.views.pack.columns import Body
from ropsim.views.pack.contours import packed_contours
from ropsim.views.scene.shapes import plain_pose
from ropsim.views.summary.result_figures import result_figures
from ropsim.views.summary.summary import Summary
from ropsim.views.words.event_text import event_text

VERSION = 3
RATE = 60
"""Samples per second: as many as a screen shows."""
_COMMON = {field.name for field in fields(Event)}
_NAMES: dict[type, tuple[str, ...]] = {}
"""Names of the fields by kind: reading them from a record dominates the time."""


class Stage(Enum):
    """Origin of a finding: compiling the texts, or carrying the program out."""

    COMPILING = "compiling"
    RUN = "run"


@frozen_dataclass
class Pack:
    """A pack before it becomes a file.

    Attributes:
        header: plain values; numbers may be NaN or infinite in data of the recording.
        body: bytes of the smooth columns.
    """

    header: dict[str, object]
    body: bytes


def pack(recording: Recording, cell: Cell, summary: Summary, findings: Iterable[Diagnostic] = ()) -> Pack:
    """Return the pack of a run.

    Args:
        recording: of a run in this cell; it must have the channel `q` of every mechanism.
        cell: simulated cell.
        summary: of the recording and these findings.
        findings: of compiling, shown before findings of the run.
    """
    body = Body()
    times = sample_times(recording.duration)
    header: dict[str, object] = {
        "version": VERSION,
        "duration": recording.duration,
        "rate": RATE,
        "count": len(times),
        "project": cell.name,
        "bases": {name: plain_pose(station.X_WB) for name, station in cell.stations.items()},
        "channels": packed_channels(recording, times, body),
        "bodies": packed_bodies(recording, cell, times, body),
        "events": [packed_event(event) for event in recording.events],
        "findings": run_findings(recording, findings),
        "contours": packed_contours(recording, summary),
        "result": asdict(result_figures(summary)),
        "facts": asdict(recording.facts),
    }
    return Pack(header, body.content())


def run_findings(recording: Recording, before: Iterable[Diagnostic]) -> list[Mapping[str, object]]:
    """Return all findings of a run as plain values.

    Args:
        recording: of the run.
        before: of compiling, listed before findings of the run.
    """
    return [
        *(plain_finding(one) for one in before),
        *(plain_finding(one, Stage.RUN, time_of(one, recording.events)) for one in recording.findings),
    ]


def sample_times(duration: float) -> Array:
    """Return the times of the samples [s]: every 1/60 s, the last one at the end of the run."""
    count = max(math.ceil(duration * RATE - 1e-9), 0)
    return np.append(np.arange(count) / RATE, duration)


def time_of(finding: Diagnostic, events: Iterable[Event]) -> float | None:
    """Return when a finding arose [s]: its own time, else that of its line and pass; None for neither."""
    known = finding.data.get("time_s")
    if isinstance(known, (int, float)):
        return float(known)
    if finding.span is None:
        return None
    place = (finding.span.source, finding.span.line)
    there = (event for event in events if event.span and (event.span.source, event.span.line) == place)
    return next((one.time for one in there if _is_of(finding, one)), None)


def _is_of(finding: Diagnostic, event: Event) -> bool:
    """Return whether a finding on the line of an event may have come with it."""
    point = event.origin.point if event.origin else None
    if point and "list" in finding.data:
        return (finding.data["list"], finding.data.get("point")) == (point.list, point.number)
    return finding.data.get("pass") in {None, event.visit}


def plain_finding(
    finding: Diagnostic, stage: Stage = Stage.COMPILING, time: float | None = None
) -> dict[str, object]:
    """Return a finding as plain values.

    Args:
        finding: of compiling or of a run.
        stage: that made it.
        time: at which it arose [s]; None without a time.
    """
    return {
        "code": finding.code,
        "severity": finding.severity.value,
        "stage": stage.value,
        "message": finding.message,
        "hint": finding.hint,
        "span": asdict(finding.span) if finding.span else None,
        "time": time,
        "follows": _cause(finding),
        "place": finding.data.get("place_m"),
    }


def _cause(finding: Diagnostic) -> dict[str, object] | None:
    """Return the place from which a finding likely follows."""
    source, line = finding.data.get("follows_source"), finding.data.get("follows_line")
    return {"source": source, "line": line} if source is not None else None


def plain_findings(
    findings: Iterable[Diagnostic], stage: Stage = Stage.COMPILING
) -> tuple[Mapping[str, object], ...]:
    """Return the findings of one stage without a time, as plain values."""
    return tuple(plain_finding(one, stage) for one in findings)


def packed_event(event: Event) -> dict[str, object]:
    """Return an event as plain values: time, kind, station, place in the text, and its figures."""
    own = {name: getattr(event, name) for name in _names(type(event)) if name not in _COMMON}
    passes = {"visit": event.origin.visit, "calls": event.origin.calls} if event.origin else {}
    return {
        "time": event.time,
        "duration": event.duration,
        "kind": event.kind,
        "text": event_text(event),
        "station": event.station,
        "span": asdict(event.span) if event.span else None,
        "data": {**passes, **{name: _plain(value) for name, value in own.items()}},
    }


def _names(kind: type) -> tuple[str, ...]:
    """Return the names of the fields of a record; none for any other kind of value."""
    if kind not in _NAMES:
        _NAMES[kind] = tuple(field.name for field in fields(kind)) if is_dataclass(kind) else ()
    return _NAMES[kind]


def _plain(value: object) -> object:
    if names := _names(type(value)):
        return {name: _plain(getattr(value, name)) for name in names}
    return value.value if isinstance(value, Enum) else value
