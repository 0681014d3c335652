"""Observer of a running program, which may hold it and press inputs."""

from collections.abc import Mapping, Sequence
from typing import Protocol

from ropsim.flow import Event, Placement
from ropsim.model import Cell
from ropsim.simulation.devices.device_run import DeviceRun
from ropsim.simulation.parts.scenery import Scenery
from ropsim.simulation.records.track import Track
from ropsim.simulation.state.station_run import StationRun


class RunView(Protocol):
    """View of a running program; its data must not be changed."""

    @property
    def cell(self) -> Cell:
        """Return the static model."""
        ...

    @property
    def tick(self) -> int:
        """Return the tick of the cell's clock up to which all stations at work have come."""
        ...

    @property
    def farthest(self) -> int:
        """Return the tick of the cell's clock to which the station at work has come that is farthest."""
        ...

    @property
    def time(self) -> float:
        """Return the same as a time [s]."""
        ...

    @property
    def hz(self) -> int:
        """Return the ticks of the cell's clock per second."""
        ...

    @property
    def stations(self) -> Mapping[str, StationRun]:
        """Return the running states of the stations by name; their logs go at least up to `tick`."""
        ...

    @property
    def devices(self) -> Mapping[str, DeviceRun]:
        """Return the running states of the devices by name."""
        ...

    @property
    def scenery(self) -> Scenery:
        """Return the fixed data while parts are moved."""
        ...

    @property
    def placements(self) -> Sequence[Placement]:
        """Return where each body hung at the start, and every change since."""
        ...

    @property
    def events(self) -> Sequence[Event]:
        """Return the events so far."""
        ...

    @property
    def tracks(self) -> Mapping[str, Track]:
        """Return the signals by the name of their channel, over ticks of the cell's clock."""
        ...

    def press(self, signal: str, tick: int, value: float) -> None:
        """Let an input have a value from a tick on that the program has not read yet."""
        ...

    def set_override(self, value: float) -> int:
        """Let the speed override be a value from 0 (hold) to 1 from the next tick on; return that tick.

        It is the first one that no station has reached: within an interpolation tick after `tick`.
        """
        ...

    def stop(self) -> int:
        """End the run at the next tick, which is returned; the recording so far stays.

        Arms that move are braked on their paths.
        """
        ...


class Watch(Protocol):
    """An observer. Every call may block, and may raise to abandon the run."""

    @property
    def may_press(self) -> bool:
        """Return whether it may press inputs of the run: then no wait for a signal is endless."""
        ...

    def advanced(self, run: RunView) -> None:
        """Take notice: an instruction, or a slice of standing still, has been carried out."""
        ...

    def reading(self, run: RunView) -> None:
        """Notification: the program is about to read a channel at the present time."""
        ...

    def ended(self, run: RunView) -> None:
        """Take notice: nothing more will happen, the recording is about to be made."""
        ...


class NobodyWatches:
    """Looks away."""

    @property
    def may_press(self) -> bool:
        """Return False."""
        return False

    def advanced(self, run: RunView) -> None:
        """Do nothing."""

    def reading(self, run: RunView) -> None:
        """Do nothing."""

    def ended(self, run: RunView) -> None:
        """Do nothing."""
