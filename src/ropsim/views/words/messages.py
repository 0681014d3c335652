"""Messages of a program to its operator by `print`, in order of time."""

from collections.abc import Sequence

from ropsim.core import frozen_dataclass
from ropsim.flow import MessageEvent, Recording
from ropsim.views.words.characters import clean
from ropsim.views.words.figures import seconds


@frozen_dataclass
class Message:
    """One message.

    Attributes:
        time: [s].
        text: as the program made it; any characters.
        source: name of the program text, empty where unknown.
        line: of the `print`, 0 where unknown.
        visit: its loop pass, 0 where unknown.
        station: name of the station whose program it is; empty where the run has no other one.
    """

    time: float
    text: str
    source: str
    line: int
    visit: int
    station: str = ""

    @property
    def place(self) -> str:
        """Return its line, behind the name of its station where there are several; empty where unknown."""
        return f"{self.station} {self.line or ''}".strip()


def messages(recording: Recording) -> tuple[Message, ...]:
    """Return all messages of a run."""
    return tuple(
        Message(
            event.time,
            event.text,
            event.span.source if event.span else "",
            event.line,
            event.visit,
            event.station if len(recording.facts.stations) > 1 else "",
        )
        for event in recording.events
        if isinstance(event, MessageEvent)
    )


def messages_text(printed: Sequence[Message]) -> str:
    """Return the messages for a terminal: time, line and text, one row each."""
    times = [seconds(one.time) for one in printed]
    lines = [_place_text(one) for one in printed]
    widest, longest = max(map(len, times), default=0), max(map(len, lines), default=0)
    rows = zip(times, lines, printed, strict=True)
    return "\n".join(
        f"{time:>{widest}} s  {line:<{longest}}  {clean(one.text)}".rstrip() for time, line, one in rows
    )


def _place_text(one: Message) -> str:
    line = f"line {one.line}" if one.line else ""
    return f"{clean(one.station)}  {line}".strip()
