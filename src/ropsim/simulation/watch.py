"""What may look on while a program runs, hold it up, and give it inputs."""

from collections.abc import Mapping, Sequence
from typing import Protocol

from ropsim.flow import Event, Placement
from ropsim.model import Cell, Tool
from ropsim.simulation.move_span import MoveSpan
from ropsim.simulation.plant import Plant
from ropsim.simulation.scenery import Scenery
from ropsim.simulation.track import Track


class RunView(Protocol):
    """A run while it goes on; what is read here must not be changed."""

    @property
    def cell(self) -> Cell:
        """Return the static model."""
        ...

    @property
    def tick(self) -> int:
        """Return the control ticks done."""
        ...

    @property
    def time(self) -> float:
        """Return the simulated time [s]."""
        ...

    @property
    def plant(self) -> Plant:
        """Return what follows the references; its log goes up to `tick`."""
        ...

    @property
    def scenery(self) -> Scenery:
        """Return what stays as it is while parts are moved."""
        ...

    @property
    def placements(self) -> Sequence[Placement]:
        """Return where each body hung at the start, and every change since."""
        ...

    @property
    def tool(self) -> Tool | None:
        """Return the tool of the cell that is in force."""
        ...

    @property
    def moves(self) -> Sequence[MoveSpan]:
        """Return the moves done."""
        ...

    @property
    def events(self) -> Sequence[Event]:
        """Return what happened."""
        ...

    @property
    def tracks(self) -> Mapping[str, Track]:
        """Return the piecewise constant channels by name."""
        ...

    def press(self, signal: str, tick: int, value: float) -> None:
        """Let an input have a value from a tick on that the program has not looked at yet."""
        ...

    def stop(self) -> None:
        """End the run here; what was recorded stays."""
        ...


class Watch(Protocol):
    """Looks on. Every call may take its time, and may raise to give the run up."""

    def advanced(self, run: RunView) -> None:
        """Take notice: an instruction, or a slice of standing still, has been carried out."""
        ...

    def reading(self, run: RunView) -> None:
        """Take notice: the program is about to look at a channel at the present time."""
        ...

    def ended(self, run: RunView) -> None:
        """Take notice: nothing more will happen, the recording is about to be made."""
        ...


class NobodyWatches:
    """Looks away."""

    def advanced(self, run: RunView) -> None:
        """Do nothing."""

    def reading(self, run: RunView) -> None:
        """Do nothing."""

    def ended(self, run: RunView) -> None:
        """Do nothing."""
