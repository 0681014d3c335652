"""Events of a pack: data of all events for a page."""

from dataclasses import asdict, fields, is_dataclass
from enum import Enum

from ropsim.flow import Event
from ropsim.views.words.event_text import event_text

_COMMON = {field.name for field in fields(Event)}
_NAMES: dict[type, tuple[str, ...]] = {}
"""Names of the fields by kind: reading them from a record dominates the time."""


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
