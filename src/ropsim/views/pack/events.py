"""Events of a pack: what a page is told of everything that happened."""

from dataclasses import asdict, fields, is_dataclass
from enum import Enum

from ropsim.flow import Event
from ropsim.views.event_text import event_text

_COMMON = {field.name for field in fields(Event)}


def packed_event(event: Event) -> dict[str, object]:
    """Return an event as plain values: when, what, whose, where in the text, and its own figures."""
    own = {field.name: getattr(event, field.name) for field in fields(event) if field.name not in _COMMON}
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


def _plain(value: object) -> object:
    if is_dataclass(value):
        return {field.name: _plain(getattr(value, field.name)) for field in fields(value)}
    return value.value if isinstance(value, Enum) else value
