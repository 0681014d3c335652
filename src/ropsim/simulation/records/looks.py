"""Where a program has looked at what depends on time since time passed last."""

from dataclasses import dataclass, field

from ropsim.icr import CodePlace


@dataclass(slots=True)
class Looks:
    """Tells where a program looks again without that time has passed.

    All that it looks at in one pass it sees at one instant, and that takes no time. Where it comes to a place
    once more at the same tick, it would see the same: it stands there, so time passes in every loop.

    Attributes:
        tick: control tick at which it looked last.
        places: of the program from which it has looked at that tick.
    """

    tick: int = -1
    places: set[CodePlace] = field(default_factory=set)

    def comes_round(self, place: CodePlace, tick: int) -> bool:
        """Return whether the program has looked from a place at this tick already."""
        return tick == self.tick and place in self.places

    def add(self, place: CodePlace, tick: int) -> None:
        """Take down that the program looks from a place at a tick."""
        if tick != self.tick:
            self.places.clear()
            self.tick = tick
        self.places.add(place)
