"""The JSON header of a recording file: everything but the arrays."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TypeVar

from ropsim.core import Diagnostic, Label, Severity, Span, TextEdit
from ropsim.flow import Channel, Event, Placement, Recording
from ropsim.records.diagnostic_json import diagnostic_entry, span_entry
from ropsim.records.plain_values import tagged, untagged
from ropsim.spatial import Pose, PoseError, frozen

FORMAT = "ropsim-recording"
VERSION = 2
"""Written; version 1 had no placements."""

Entry = Mapping[str, object]
T = TypeVar("T")


class DocumentError(ValueError):
    """An entry of the header is missing or of the wrong type; the message names it."""


@dataclass(frozen=True, slots=True)
class ChannelFacts:
    """A channel without its values: unit, column names, description."""

    unit: str
    columns: tuple[str, ...]
    description: str


@dataclass(frozen=True, slots=True)
class Document:
    """What the JSON header says; see `ropsim.flow.Recording` for the meaning of the entries."""

    duration: float
    header: Mapping[str, object]
    channels: Mapping[str, ChannelFacts]
    events: tuple[Event, ...]
    findings: tuple[Diagnostic, ...]
    placements: tuple[Placement, ...]


def document(recording: Recording) -> dict[str, object]:
    """Return the header of a recording as plain values for strict JSON.

    Raises:
        NotPlainError: header, event data or finding data hold something else than plain values.
    """
    return {
        "format": FORMAT,
        "version": VERSION,
        "duration": tagged(recording.duration),
        "header": tagged(dict(recording.header)),
        "channels": {name: _channel_entry(channel) for name, channel in recording.channels.items()},
        "events": [_event_entry(event) for event in recording.events],
        "findings": [diagnostic_entry(finding, tagged) for finding in recording.findings],
        "placements": [_placement_entry(placement) for placement in recording.placements],
    }


def read_document(plain: object) -> Document:
    """Return the header that plain values describe.

    Raises:
        DocumentError: an entry is missing or of the wrong type.
    """
    entry = _mapping(plain, "header")
    channels = _mapping(_get(entry, "channels", dict), "channels")
    return Document(
        duration=_number(entry, "duration"),
        header=_free(entry, "header"),
        channels={name: _channel(_mapping(facts, name)) for name, facts in channels.items()},
        events=tuple(_event(_mapping(event, "event")) for event in _get(entry, "events", list)),
        findings=tuple(_finding(_mapping(finding, "finding")) for finding in _get(entry, "findings", list)),
        placements=_placements(entry),
    )


def _channel_entry(channel: Channel) -> dict[str, object]:
    return {"unit": channel.unit, "columns": list(channel.columns), "description": channel.description}


def _event_entry(event: Event) -> dict[str, object]:
    return {
        "time": tagged(event.time),
        "kind": event.kind,
        "text": event.text,
        "span": span_entry(event.span),
        "duration": tagged(event.duration),
        "data": tagged(dict(event.data)),
    }


def _placement_entry(placement: Placement) -> dict[str, object]:
    return {
        "time": tagged(placement.time),
        "body": placement.body,
        "parent": placement.parent,
        "pose": [tagged(number) for number in placement.X_PB.as_tuple()],
        "visible": placement.visible,
    }


def _placements(entry: Entry) -> tuple[Placement, ...]:
    if entry.get("version") == 1:
        return ()
    return tuple(_placement(_mapping(one, "placement")) for one in _get(entry, "placements", list))


def _placement(entry: Entry) -> Placement:
    numbers = [_number({"pose": value}, "pose") for value in _get(entry, "pose", list)]
    try:
        X_PB = Pose(frozen(numbers[:3]), frozen(numbers[3:]))
    except PoseError as error:
        raise DocumentError(f"`pose` is none: {error.diagnostic.message}") from error
    body, parent = _get(entry, "body", str), _get(entry, "parent", str)
    return Placement(_number(entry, "time"), body, parent, X_PB, _get(entry, "visible", bool))


def _channel(entry: Entry) -> ChannelFacts:
    return ChannelFacts(_get(entry, "unit", str), _texts(entry, "columns"), _get(entry, "description", str))


def _event(entry: Entry) -> Event:
    return Event(
        _number(entry, "time"),
        _get(entry, "kind", str),
        _get(entry, "text", str),
        _span(entry),
        _number(entry, "duration"),
        _free(entry, "data"),
    )


def _finding(entry: Entry) -> Diagnostic:
    severity = _get(entry, "severity", str)
    if severity not in {known.value for known in Severity}:
        raise DocumentError(f"`severity` is `{severity[:40]}`")
    return Diagnostic(
        _get(entry, "code", str),
        _get(entry, "slug", str),
        Severity(severity),
        _get(entry, "message", str),
        _span(entry),
        _get(entry, "label", str),
        tuple(_label(_mapping(label, "secondary")) for label in _get(entry, "secondary", list)),
        _texts(entry, "notes"),
        _get(entry, "hint", str),
        _fix(entry.get("fix")),
        _free(entry, "data"),
    )


def _label(entry: Entry) -> Label:
    return Label(_required_span(entry), _get(entry, "text", str))


def _fix(entry: object) -> TextEdit | None:
    if entry is None:
        return None
    fix = _mapping(entry, "fix")
    return TextEdit(_required_span(fix), _get(fix, "replacement", str))


def _required_span(entry: Entry) -> Span:
    span = _span(entry)
    if span is None:
        raise DocumentError("`span` is missing")
    return span


def _span(entry: Entry) -> Span | None:
    if entry.get("span") is None:
        return None
    span = _mapping(entry["span"], "span")
    line, column, end_line, end_column = (
        _get(span, key, int) for key in ("line", "column", "end_line", "end_column")
    )
    return Span(_get(span, "source", str), line, column, end_line, end_column)


def _number(entry: Entry, key: str) -> float:
    value = untagged(entry.get(key))
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise DocumentError(f"`{key}` is not a number")
    try:
        return float(value)
    except OverflowError as error:
        raise DocumentError(f"`{key}` is too large a number") from error


def _free(entry: Entry, key: str) -> Mapping[str, object]:
    return _mapping(untagged(_get(entry, key, dict)), key)


def _texts(entry: Entry, key: str) -> tuple[str, ...]:
    values: list[object] = _get(entry, key, list)
    return tuple(_typed(value, key, str) for value in values)


def _get(entry: Entry, key: str, kind: type[T]) -> T:
    if key not in entry:
        raise DocumentError(f"`{key}` is missing")
    return _typed(entry[key], key, kind)


def _typed(value: object, key: str, kind: type[T]) -> T:
    if not isinstance(value, kind) or (kind is int and isinstance(value, bool)):
        raise DocumentError(f"`{key}` is a `{type(value).__name__}`, not a `{kind.__name__}`")
    return value


def _mapping(value: object, key: str) -> Mapping[str, object]:
    if not isinstance(value, dict):
        raise DocumentError(f"`{key}` is a `{type(value).__name__}`, not a mapping")
    return value
