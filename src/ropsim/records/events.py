"""Events and facts of a recording as plain values for strict JSON, and back."""

from ropsim.flow import EVENTS, Event
from ropsim.records.plain_records import DocumentError, plain_record, record_from

KIND = "kind"


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
