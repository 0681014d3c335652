"""Interventions in a live run: hold, resume, single step, override, end."""

from dataclasses import dataclass
from typing import Literal

from ropsim.flow import Event
from ropsim.simulation import RunView
from ropsim.studio.wire.jobs import LiveBegin
from ropsim.studio.wire.orders import LiveControl, LiveOverride


@dataclass(slots=True)
class Hand:
    """Turns orders into the override of a run, which brakes and goes on along its paths.

    A step ends with the next instruction that takes time. An instruction without duration, such as an output,
    belongs to the step of the instruction behind it; a move that passes its target by ends on its path, just
    behind it.

    Attributes:
        override: share of the planned speed that is requested.
        is_held: whether the run is held, for any override.
        is_stepping: whether it is to be held when the step is done.
        is_over: whether the run has been ended.
        in_force: override that the run was given last.
        seen: number of events already processed.
    """

    override: float = 1.0
    is_held: bool = False
    is_stepping: bool = False
    is_over: bool = False
    in_force: float = 1.0
    seen: int = 0

    @classmethod
    def at_start(cls, begin: LiveBegin) -> "Hand":
        """Return the hand of a run that begins running, or held by an override of 0."""
        return cls(is_held=True, in_force=0.0) if begin == "held" else cls()

    @property
    def state(self) -> Literal["running", "held"]:
        """Return how the run stands, for the page."""
        return "held" if self.is_held else "running"

    def obey(self, run: RunView, order: LiveControl | LiveOverride) -> None:
        """Apply an order to a run, from the next tick on to which no station has come."""
        match order:
            case LiveOverride(value):
                self.override = value
            case LiveControl("hold"):
                self.is_held, self.is_stepping = True, False
            case LiveControl("continue"):
                self.is_held = self.is_stepping = False
            case LiveControl("step"):
                self.is_held, self.is_stepping = False, True
                self.seen = len(run.events)
            case LiveControl("stop"):
                run.stop()
                self.is_over = True
        self._put_in_force(run)

    def look(self, run: RunView) -> Event | None:
        """Hold a run that has come to the end of its step; return the event that ended it, or None."""
        if not self.is_stepping:
            return None
        ended = next((event for event in run.events[self.seen :] if event.duration > 0.0), None)
        if ended is not None:
            self.is_held, self.is_stepping = True, False
            self._put_in_force(run)
        return ended

    def _put_in_force(self, run: RunView) -> None:
        wanted = 0.0 if self.is_held else self.override
        if wanted != self.in_force and not self.is_over:
            run.set_override(wanted)
            self.in_force = wanted
