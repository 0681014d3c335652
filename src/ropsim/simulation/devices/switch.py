"""An axis with two positions."""

from dataclasses import dataclass, field

from ropsim.model import SwitchDrive
from ropsim.simulation.devices.axis_profile import AxisProfile, to_rest
from ropsim.simulation.devices.device_run import DriveAction, Now


@dataclass(slots=True)
class Switch:
    """Running state.

    Attributes:
        drive: static model.
        target: where it goes to or stands [rad | m].
    """

    drive: SwitchDrive
    target: float = field(init=False)

    def __post_init__(self) -> None:
        self.target = self.drive.off

    def act(self, profile: AxisProfile, now: Now) -> DriveAction:
        """Go to the position that the signal selects; also from the middle of the way to the other one."""
        drive = self.drive
        wanted = drive.on if now.signals(drive.signal) else drive.off
        if wanted != self.target:
            self.target = wanted
            q, qd = profile.at(now.time)
            profile.go(to_rest(now.time, q, qd, wanted, drive.speed, drive.acceleration))
        there = profile.segments[-1].time
        stands = there <= now.time
        levels = (
            (drive.is_off, stands and self.target == drive.off),
            (drive.is_on, stands and self.target == drive.on),
        )
        return DriveAction(levels) if stands else DriveAction(levels, there)
