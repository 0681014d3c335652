"""Messages of a live run so far, for a tab that opens later."""

from collections.abc import Callable, Mapping

from ropsim.studio.wire.live_messages import LiveStatus
from ropsim.studio.wire.messages import Message

MOST = {"stamped": 1000, "happened": 4000}
"""Number of newest key presses and events sent to a late tab."""


class LiveLog:
    """Messages of the present live run; none without one.

    Args:
        tell: sends a message to every tab.
    """

    def __init__(self, tell: Callable[[Message], None]) -> None:
        self._tell = tell
        self._status: Message | None = None
        self._program = ""
        self._speed = 1.0
        self._counts = dict.fromkeys(MOST, 0)
        self._layout: tuple[Message, ...] = ()
        self._others: dict[object, Message] = {}
        self._tasks: dict[object, object] = {}

    @property
    def messages(self) -> tuple[Message, ...]:
        """Return how the run stands, its layout, and in order parts, key presses and events."""
        return () if self._status is None else (self._status, *self._layout, *self._others.values())

    def start(self, program: str, speed: float) -> None:
        """Begin a new run."""
        self._forget()
        self._program, self._speed = program, speed
        self._status = LiveStatus("starting", speed, program)
        self._tell(self._status)

    def add(self, message: Mapping[str, object]) -> None:
        """Take a message of the run and send it on."""
        match message:
            case {"type": "live"}:
                self._status = message
            case {"type": "layout"}:
                self._layout = (message,)
            case {"type": "placed", "body": body}:
                self._others.pop(("placed", body), None)  # only where it is now, in order of time
                self._others["placed", body] = message
            case {"type": "happened", "event": {"kind": "task", "station": at, "data": {"serial": serial}}}:
                if (known := self._tasks.get((at, serial))) in self._others:
                    self._others[known] = message  # only how long it is now
                else:
                    self._tasks[at, serial] = self._keep("happened", message)
            case {"type": "stamped" | "happened" as kind}:
                self._keep(kind, message)
            case _:  # notices are for who is there
                pass
        self._tell(message)

    def end(self) -> None:
        """Report that the run is over and forget it."""
        self._tell(LiveStatus("over", self._speed, self._program))
        self._status = None
        self._forget()

    def _keep(self, kind: str, message: Message) -> object:
        """Keep a message as the newest of its kind, and no more than late tabs hear of; return its key."""
        self._counts[kind] += 1
        key = (kind, self._counts[kind])
        self._others[key] = message
        self._others.pop((kind, self._counts[kind] - MOST[kind]), None)
        return key

    def _forget(self) -> None:
        self._counts = dict.fromkeys(self._counts, 0)
        self._layout = ()
        self._others.clear()
        self._tasks.clear()
