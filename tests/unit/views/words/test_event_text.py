import pytest

from ropsim.flow import (
    EVENTS,
    AwaitEvent,
    Event,
    GripEvent,
    InputEvent,
    MessageEvent,
    MotionKind,
    MoveEvent,
    Origin,
    OutputEvent,
    ReleaseEvent,
    SkipEvent,
    TaskEvent,
    WaitEvent,
)
from ropsim.views import event_text

TEXTS: list[tuple[Event, str]] = [
    (MoveEvent(0.0, origin=Origin(visit=3), motion=MotionKind.LIN, ordinal=0), "LIN pass 3"),
    (SkipEvent(0.0, motion=MotionKind.PTP), "PTP not possible"),
    (WaitEvent(0.0, pause=0.5), "wait 0.5 s"),
    (AwaitEvent(0.0, channel="ready", value=True, came=True), "wait until ready"),
    (AwaitEvent(0.0, channel="ready", value=False, came=False), "wait until not ready, in vain"),
    (OutputEvent(0.0, channel="lamp", value=True), "lamp = on"),
    (MessageEvent(0.0, text="two\nlines"), "two\nlines"),
    (GripEvent(0.0, part="box"), "grip box"),
    (GripEvent(0.0), "close on nothing"),
    (ReleaseEvent(0.0, part="box"), "release box"),
    (ReleaseEvent(0.0), "open"),
    (TaskEvent(0.0, name="pick", serial=1, depth=1), "pick"),
    (InputEvent(0.0, signal="level", value=2.5), "level = 2.5"),
]


@pytest.mark.parametrize(("event", "text"), TEXTS)
def test_an_event_is_told_in_a_few_words(event: Event, text: str) -> None:
    assert event_text(event) == text


def test_every_kind_of_event_has_its_words() -> None:
    assert {type(event) for event, _ in TEXTS} == set(EVENTS.values())
