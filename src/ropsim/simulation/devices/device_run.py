"""The running state of one device, and the common part of all kinds of drives."""

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import Protocol

from ropsim.core import frozen_dataclass
from ropsim.kinematics import frames_batch
from ropsim.model import Device
from ropsim.simulation.devices.axis_profile import AxisProfile
from ropsim.spatial import Pose

NEVER = -1
"""No tick at which something is due."""


@frozen_dataclass
class Carried:
    """A part that moves with a device.

    Attributes:
        name: of the part.
        front: how far its front is before the coordinate of the device: it is at `front` + coordinate [m].
        length: of the part along the axis [m].
    """

    name: str
    front: float
    length: float


@frozen_dataclass
class Now:
    """Input of a drive when it acts.

    Attributes:
        time: [s].
        signals: returns whether a signal is on.
        carried: parts that move with the device.
    """

    time: float
    signals: Callable[[str], bool]
    carried: tuple[Carried, ...]


@frozen_dataclass
class DriveAction:
    """Result of an action of a drive.

    Attributes:
        levels: inputs of the cell that it sets, by name.
        due: when it has to act again if nothing else happens [s]; inf for never.
        lost: names of the parts that have run off its end.
    """

    levels: tuple[tuple[str, bool], ...] = ()
    due: float = math.inf
    lost: tuple[str, ...] = ()


class Driving(Protocol):
    """The running state of one kind of drive."""

    def act(self, profile: AxisProfile, now: Now) -> DriveAction:
        """Read the signals, change the profile from now on, and return new levels and lost parts."""
        ...


@dataclass(slots=True)
class DeviceRun:
    """Running state.

    Attributes:
        device: static model.
        driving: the running state of its drive.
        profile: its coordinate over time.
        bodies: names of the bodies that it moves.
        scripted: ticks at which the cell changes a signal that it follows, ascending.
        due: tick of the cell's clock at which it acts next, `NEVER` for none.
        acted: tick at which it acted last.
        levels: last levels of the inputs that it sets.
    """

    device: Device
    driving: Driving
    bodies: tuple[str, ...]
    scripted: tuple[int, ...] = ()
    profile: AxisProfile = field(default_factory=AxisProfile)
    due: int = 0
    acted: int = -1
    levels: dict[str, bool] = field(default_factory=dict)

    def poses(self, time: float) -> dict[str, Pose]:
        """Return X_WB of each body that it moves at a time [s], by name."""
        frames = frames_batch(self.device.mechanism, [[self.profile.at(time)[0]]])[0, :-1]
        return {
            name: self.device.X_WB @ Pose.from_matrix(frame)
            for name, frame in zip(self.bodies, frames, strict=True)
        }

    def wake(self, tick: int) -> None:
        """Let it act at a tick at the latest, but once in a tick: devices in a circle let time pass."""
        soonest = max(tick, self.acted + 1)
        self.due = soonest if self.due == NEVER else min(self.due, soonest)

    def heard(self, levels: Iterable[tuple[str, bool]]) -> list[tuple[str, bool]]:
        """Return which of the levels that are new."""
        news = [(name, level) for name, level in levels if name and self.levels.get(name) is not level]
        self.levels.update(news)
        return news
