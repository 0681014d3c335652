"""What a live run has said so far, so that a tab that comes later knows it too."""

from collections.abc import Callable, Mapping

from ropsim.studio.messages import LiveStatus, Message


class LiveLog:
    """Messages of the live run that is on; none while there is no such run.

    Args:
        tell: sends a message to every tab.
    """

    def __init__(self, tell: Callable[[Message], None]) -> None:
        self._tell = tell
        self._status: Message | None = None
        self._program = ""
        self._speed = 1.0
        self._others: list[Message] = []

    @property
    def messages(self) -> tuple[Message, ...]:
        """Return layout, placements and stamps so far, then how the run stands."""
        return () if self._status is None else (self._status, *self._others)

    def start(self, program: str, speed: float) -> None:
        """Begin a new run."""
        self._others.clear()
        self._program, self._speed = program, speed
        self._status = LiveStatus("starting", speed, program)
        self._tell(self._status)

    def add(self, message: Mapping[str, object]) -> None:
        """Take a message of the run and send it on."""
        if message.get("type") == "live":
            self._status = message
        elif message.get("type") != "notice":
            self._others.append(message)
        self._tell(message)

    def end(self) -> None:
        """Tell that the run is over and forget it."""
        self._tell(LiveStatus("over", self._speed, self._program))
        self._status = None
        self._others.clear()
