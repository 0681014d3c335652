"""The wait of a program that looks again and again: one event, however many ticks it stands."""

from ropsim.core import frozen_dataclass
from ropsim.flow import WaitEvent


@frozen_dataclass
class PollingWait:
    """A wait that may go on.

    Attributes:
        event: its event, with its present duration.
        since: control tick at which it began.
        until: control tick up to which it has lasted.
    """

    event: WaitEvent
    since: int
    until: int

    def goes_on_in(self, event: WaitEvent, since: int) -> bool:
        """Return whether the program stands on in a wait that began at a tick: on its line, for the same."""
        own, other = self.event.origin, event.origin
        places = [(one.span, one.calls, one.call_serials) for one in (own, other) if one is not None]
        return since == self.until and places[:1] == places[1:] and self.event.looked == event.looked
