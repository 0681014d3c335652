"""Messages that wait, with the requests among them that the editor has cancelled."""

from collections import deque

from ropsim.core import frozen_dataclass
from ropsim.lsp.protocol.messages import Call, Fault, Id


@frozen_dataclass
class Ended:
    """The end of the stream."""


# A waiting message; None for a response, on which nothing depends.
Message = Call | Fault | Ended | None

CANCEL, CHANGE = "$/cancelRequest", "textDocument/didChange"


class Inbox:
    """A queue of messages; a request is cancelled by a later message, as long as it waits."""

    __slots__ = ("_cancelled", "_waiting")

    def __init__(self) -> None:
        self._waiting: deque[Message] = deque()
        self._cancelled: set[Id] = set()

    @property
    def is_empty(self) -> bool:
        """Return whether nothing waits."""
        return not self._waiting

    @property
    def asks_next(self) -> bool:
        """Return whether the message that has waited longest is a request about texts."""
        first = self._waiting[0] if self._waiting else None
        return isinstance(first, Call) and first.is_request and first.method != "shutdown"

    @property
    def changes_wait(self) -> bool:
        """Return whether a change of a text waits."""
        return any(isinstance(one, Call) and one.method == CHANGE for one in self._waiting)

    def put(self, message: Message) -> None:
        """Take a message."""
        if isinstance(message, Call) and message.method == CANCEL:
            params = message.params
            identity = params.get("id") if isinstance(params, dict) else None
            if isinstance(identity, int | str) and self._waits(identity):
                self._cancelled.add(identity)
        self._waiting.append(message)

    def next(self) -> tuple[Message, bool]:
        """Return the message that has waited longest, and whether it is a request that has been cancelled."""
        message = self._waiting.popleft()
        if isinstance(message, Call) and message.is_request and message.id in self._cancelled:
            self._cancelled.discard(message.id)
            return message, True
        return message, False

    def _waits(self, identity: Id) -> bool:
        return any(isinstance(one, Call) and one.is_request and one.id == identity for one in self._waiting)
