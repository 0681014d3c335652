"""How many parts are where they were to be when the run ended."""

from collections.abc import Mapping
from dataclasses import dataclass

from ropsim.flow import Recording
from ropsim.views.findings import plural


@dataclass(frozen=True, slots=True)
class Destinations:
    """The parts that have a destination.

    Attributes:
        wanted: how many there are.
        reached: how many of them are there at the end.
    """

    wanted: int
    reached: int

    @property
    def text(self) -> str:
        """Return it as a line, such as `12 of 12 parts at their destination`."""
        whose = "its" if self.wanted == 1 else "their"
        return f"{self.reached} of {plural(self.wanted, 'part')} at {whose} destination"


def destinations(recording: Recording) -> Destinations | None:
    """Return how many parts are at their destinations; None where the recording does not say."""
    entry = recording.header.get("destinations")
    if not isinstance(entry, Mapping):
        return None
    wanted, reached = entry.get("wanted"), entry.get("reached")
    if not isinstance(wanted, int) or not isinstance(reached, int):
        return None
    return Destinations(wanted, reached)
