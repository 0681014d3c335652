"""A belt that moves on as long as its signal is on and no part is in its barrier."""

import math
from dataclasses import dataclass

from ropsim.model import BeltDrive
from ropsim.simulation.devices.axis_profile import AxisProfile, to_rest, to_speed
from ropsim.simulation.devices.device_run import Carried, DriveAction, Now

TOUCH = 1e-6
"""A part this near to the barrier is in it [m]."""


@dataclass(slots=True)
class Belt:
    """Running state; its variable data are in the profile."""

    drive: BeltDrive

    def act(self, profile: AxisProfile, now: Now) -> DriveAction:
        """Start, stop or go on, so that the front of the next part comes to rest at the barrier."""
        drive, barrier = self.drive, self.drive.barrier
        q, qd = profile.at(now.time)
        lost = tuple(one.name for one in now.carried if self._leaves(one) <= q + TOUCH)
        carried = [one for one in now.carried if one.name not in lost]
        blocked = barrier is not None and any(_covers(one, q, barrier.at) for one in carried)
        runs = not blocked and (not drive.run or now.signals(drive.run))
        brake = qd * qd / (2.0 * drive.acceleration)
        # the nearest part that can still be stopped there; one that cannot runs into the barrier and beyond
        ahead = (barrier.at - one.front for one in carried) if barrier is not None else ()
        target = min((one for one in ahead if one > q + TOUCH and one - q >= brake - TOUCH), default=math.inf)
        if not runs:
            profile.go(to_speed(now.time, q, qd, 0.0, drive.acceleration))
        elif target < math.inf:
            profile.go(to_rest(now.time, q, qd, max(target, q + brake), drive.speed, drive.acceleration))
        else:
            profile.go(to_speed(now.time, q, qd, drive.speed, drive.acceleration))
        levels = ((barrier.signal, blocked),) if barrier is not None else ()
        return DriveAction(levels, self._next(profile, now.time, carried), lost)

    def _leaves(self, part: Carried) -> float:
        """Return the coordinate at which the centre of a part is at the end of the belt [m]."""
        return self.drive.length - part.front + part.length / 2.0

    def _next(self, profile: AxisProfile, time: float, carried: list[Carried]) -> float:
        """Return when the belt comes to rest, loses a part, or one comes into the barrier or out [s]."""
        last, (q, _) = profile.segments[-1], profile.at(time)
        rest = last.time if last.qd == 0.0 and last.time > time else math.inf
        places = [self._leaves(one) for one in carried]
        if self.drive.barrier is not None:
            at = self.drive.barrier.at
            places += [place for one in carried for place in (at - one.front, at - one.front + one.length)]
        return min([rest, *(profile.time_of(place, time) for place in places if place > q + TOUCH)])


def _covers(part: Carried, q: float, at: float) -> bool:
    """Return whether a part is in the barrier."""
    front = part.front + q
    return front >= at - TOUCH and front - part.length < at - TOUCH
