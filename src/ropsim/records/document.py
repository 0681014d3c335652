"""The JSON header of a recording file: everything but the arrays."""

from collections.abc import Mapping
from typing import TypeVar

from ropsim.core import (
    Category,
    Diagnostic,
    Kind,
    Label,
    Severity,
    Span,
    TextEdit,
    catalogue,
    frozen_dataclass,
)
from ropsim.flow import EVENTS, Channel, ChannelGroup, Event, Placement, Recording, RunContent, RunFacts
from ropsim.records.diagnostic_json import diagnostic_entry
from ropsim.records.plain_records import DocumentError, number, plain_record, record_from
from ropsim.records.plain_values import tagged, untagged
from ropsim.spatial import Pose, PoseError, frozen

FORMAT = "ropsim-recording"
VERSION = 4
"""Written; `older` handles earlier versions."""

Entry = Mapping[str, object]
T = TypeVar("T")
KIND = "kind"


@frozen_dataclass
class ChannelFacts:
    """A channel without its values; see `ropsim.flow.Channel` for the meaning of the entries."""

    unit: str
    columns: tuple[str, ...]
    description: str
    group: ChannelGroup
    subject: str
    held: bool


@frozen_dataclass
class Document:
    """Content of the JSON header; see `ropsim.flow.Recording` for the meaning of the entries."""

    duration: float
    facts: RunFacts
    channels: Mapping[str, ChannelFacts]
    events: tuple[Event, ...]
    findings: tuple[Diagnostic, ...]
    placements: tuple[Placement, ...]
    content: RunContent


def document(recording: Recording) -> dict[str, object]:
    """Return the header of a recording as plain values for strict JSON.

    Raises:
        NotPlainError: data of findings hold something else than plain values.
    """
    return {
        "format": FORMAT,
        "version": VERSION,
        "duration": tagged(recording.duration),
        "facts": plain_record(recording.facts),
        "channels": {name: _channel_entry(channel) for name, channel in recording.channels.items()},
        "events": [event_entry(event) for event in recording.events],
        "findings": [diagnostic_entry(finding, tagged) for finding in recording.findings],
        "placements": [_placement_entry(placement) for placement in recording.placements],
        "content": {
            "cell": recording.content.cell,
            "lines": {name: list(lines) for name, lines in recording.content.lines.items()},
            "results": {
                name: [[line, key] for line, key in keys.items()]
                for name, keys in recording.content.results.items()
            },
        },
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
        facts=record_from(RunFacts, _get(entry, "facts", dict), "facts"),
        channels={name: record_from(ChannelFacts, one, name[:40]) for name, one in channels.items()},
        events=tuple(read_event(event) for event in _get(entry, "events", list)),
        findings=tuple(_finding(_mapping(finding, "finding")) for finding in _get(entry, "findings", list)),
        placements=tuple(_placement(_mapping(one, "placement")) for one in _get(entry, "placements", list)),
        content=_content(_mapping(entry.get("content", {}), "content")),
    )


def _content(entry: Entry) -> RunContent:
    """Return the content of a run; empty for runs recorded without it."""
    lines = _mapping(entry.get("lines", {}), "lines")
    results = _mapping(entry.get("results", {}), "results")
    return RunContent(
        _get({"cell": "", **entry}, "cell", str),
        {name: _whole_numbers(numbers, name[:40]) for name, numbers in lines.items()},
        {name: _keys_of_lines(keys, name[:40]) for name, keys in results.items()},
    )


def _keys_of_lines(plain: object, name: str) -> Mapping[int, str]:
    found: dict[int, str] = {}
    for pair in plain if isinstance(plain, list) else (None,):
        match pair:
            case [int(line), str(key)]:
                found[line] = key
            case _:
                raise DocumentError(f"`{name}` is no list of lines with their keys")
    return found


def _whole_numbers(plain: object, name: str) -> tuple[int, ...]:
    if not isinstance(plain, list) or not all(type(one) is int for one in plain):
        raise DocumentError(f"`{name}` is no list of whole numbers")
    return tuple(plain)


def _channel_entry(channel: Channel) -> dict[str, object]:
    return plain_record(
        ChannelFacts(
            channel.unit,
            channel.columns,
            channel.description,
            channel.group,
            channel.subject,
            channel.held,
        )
    )


def _placement_entry(placement: Placement) -> dict[str, object]:
    return {
        "time": tagged(placement.time),
        "body": placement.body,
        "parent": placement.parent,
        "pose": [tagged(number) for number in placement.X_PB.as_tuple()],
        "visible": placement.visible,
    }


def _placement(entry: Entry) -> Placement:
    numbers = [number(value, "pose") for value in _get(entry, "pose", list)]
    try:
        X_PB = Pose(frozen(numbers[:3]), frozen(numbers[3:]))
    except PoseError as error:
        raise DocumentError(f"`pose` is none: {error.diagnostic.message}") from error
    body, parent = _get(entry, "body", str), _get(entry, "parent", str)
    return Placement(_number(entry, "time"), body, parent, X_PB, _get(entry, "visible", bool))


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
        _category(entry),
    )


def _category(entry: Entry) -> Category:
    """Return the category of a finding; recordings before it was written have that of its kind."""
    if "category" not in entry:
        kind = _kinds_of_runs().get(_get(entry, "code", str))
        return kind.category if kind is not None else Category.OTHER
    word = _get(entry, "category", str)
    if word not in {known.value for known in Category}:
        raise DocumentError(f"`category` is `{word[:40]}`")
    return Category(word)


def _kinds_of_runs() -> Mapping[str, Kind]:
    """Return the kinds of all findings of runs, by code."""
    import ropsim.simulation  # noqa: F401  it defines them

    return catalogue()


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
    return record_from(Span, entry["span"], "span")


def _number(entry: Entry, key: str) -> float:
    return number(entry.get(key), key)


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


def event_entry(event: Event) -> dict[str, object]:
    """Return an event as plain values: its kind, and its fields by their names."""
    return {KIND: event.kind, **plain_record(event)}


def read_event(plain: object) -> Event:
    """Return the event that plain values describe.

    Raises:
        DocumentError: it is of no known kind, or an entry is missing or of the wrong type.
    """
    word = plain.get(KIND) if isinstance(plain, dict) else None
    kind = EVENTS.get(word) if isinstance(word, str) else None
    if kind is None:
        raise DocumentError(f"`{KIND}` of an event is `{str(word)[:40]}`, known are {', '.join(EVENTS)}")
    return record_from(kind, plain, kind.kind)
