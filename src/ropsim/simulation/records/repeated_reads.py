"""Places at which a program has read time-dependent data since time last advanced."""

from dataclasses import dataclass, field

from ropsim.icr import CodePlace


@dataclass(slots=True)
class RepeatedReads:
    """Detects that a program reads again before time has advanced.

    All readings of one pass are made at one instant and take no time. If the program comes to a place again
    at the same tick, it would read the same values: it pauses there, so time advances in every loop.

    Attributes:
        tick: control tick of the last reading.
        places: places of the program that have read at that tick.
    """

    tick: int = -1
    places: set[CodePlace] = field(default_factory=set)

    def comes_round(self, place: CodePlace, tick: int) -> bool:
        """Return whether the program has already read at a place at this tick."""
        return tick == self.tick and place in self.places

    def add(self, place: CodePlace, tick: int) -> None:
        """Take down that the program looks from a place at a tick."""
        if tick != self.tick:
            self.places.clear()
            self.tick = tick
        self.places.add(place)
