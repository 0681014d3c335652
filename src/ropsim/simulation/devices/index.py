"""An axis that moves on by one step at a time."""

from dataclasses import dataclass

from ropsim.model import IndexDrive
from ropsim.simulation.devices.axis_profile import AxisProfile, to_rest
from ropsim.simulation.devices.device_run import DriveAction, Now


@dataclass(slots=True)
class Index:
    """Running state.

    Attributes:
        drive: static model.
        steps: made or begun.
        was_on: level of the signal at the last reading.
    """

    drive: IndexDrive
    steps: int = 0
    was_on: bool = False

    def act(self, profile: AxisProfile, now: Now) -> DriveAction:
        """Begin a step where the signal has come on while it stood."""
        drive, is_on = self.drive, now.signals(self.drive.signal)
        if is_on and not self.was_on and profile.segments[-1].time <= now.time:
            self.steps += 1
            q, qd = profile.at(now.time)
            target = self.steps * drive.step
            profile.go(to_rest(now.time, q, qd, target, drive.speed, drive.acceleration))
        self.was_on = is_on
        there = profile.segments[-1].time
        stands = there <= now.time
        levels = ((drive.in_place, stands),)
        return DriveAction(levels) if stands else DriveAction(levels, there)
