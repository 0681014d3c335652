"""Time-synchronised PTP: all joints start and end together, each by a profile of its own."""

from dataclasses import field

import numpy as np

from ropsim.motion.curves.path import JointPoints
from ropsim.motion.diagnostics import WRONG_PROFILE_REQUEST
from ropsim.motion.joint_paths.path_rows import SYNCHRONISED, PathRows
from ropsim.motion.motion_limits import JointMotionLimits
from ropsim.motion.time_law import synchronised_kernel
from ropsim.motion.time_law.durations import ZERO_LENGTH
from ropsim.motion.time_law.piecewise_law import PiecewiseLaw
from ropsim.motion.time_law.profile import ProfileError
from ropsim.motion.time_law.time_law_kernel import LEAST, MOST
from ropsim.spatial import Array, frozen, record


@record
class SynchronisedJoints:
    """A path of the joints whose parameter is the time: it is traversed at speed 1.

    Each joint has the fastest profile from rest to rest that its own limits allow. The slowest joint
    determines the time; the profiles of the others are stretched to it, so that all their derivatives get
    smaller. The path is no straight line in joint space.

    Attributes:
        q_start: joint coordinates at time 0 [rad | m], shape (n,).
        q_end: at the end [rad | m], shape (n,).
        limits: of every joint.
        length: the time from start to end [s]; 0 where no joint moves by more than `ZERO_LENGTH`.
        shapes: of the profiles in rows: signed jerk at the start [rad/s³ | m/s³], for how long it lasts [s],
            and for how long the acceleration lasts that follows [s]; of shape (3, n).

    Raises:
        ProfileError: M540, where a limit is not from 1e-50 to 1e50, a distance is not finite or longer, or
            the numbers of joints differ.
    """

    q_start: Array
    q_end: Array
    limits: JointMotionLimits
    length: float = field(init=False)
    shapes: Array = field(init=False)

    def __post_init__(self) -> None:
        q_start, q_end, limits = frozen(self.q_start), frozen(self.q_end), self.limits
        each = (q_start, q_end, limits.speed, limits.acceleration, limits.jerk)
        counts = [one.size for one in each]
        if min(counts) != max(counts):
            message = f"starts, ends and limits are of {counts} joints, allowed is one number of them"
            raise ProfileError(WRONG_PROFILE_REQUEST.at(None, message))
        distances, bounds = q_end - q_start, np.array(each[2:])
        shapes, result = np.empty((3, len(distances))), np.empty(2)
        synchronised_kernel.plan_together(distances, bounds, shapes, result)
        length, wrong = result.tolist()
        if length < 0.0:
            raise ProfileError(WRONG_PROFILE_REQUEST.at(None, _wrong_words(int(wrong), distances, bounds)))
        if not (abs(distances) > ZERO_LENGTH).any():
            length = 0.0
        shapes.flags.writeable = False
        made = {"q_start": q_start, "q_end": q_end, "length": length, "shapes": shapes}
        for name, value in made.items():
            object.__setattr__(self, name, value)

    @property
    def own_law(self) -> PiecewiseLaw:
        """Return the time law that traverses the path at speed 1: the profiles start and end at rest."""
        segment = np.array([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, self.length, self.length])
        return PiecewiseLaw(segment[:, np.newaxis], np.array([self.length]))

    def joints(self, s: Array) -> JointPoints:
        """Return the joints, their speeds and accelerations at times s [s], shape (k,); ends are exact."""
        requested = np.ascontiguousarray(s, dtype=np.float64)
        out = np.empty((3, len(requested), len(self.q_start)))
        synchronised_kernel.joint_rows(self.q_start, self.q_end, self.shapes, self.length, requested, out)
        return JointPoints(out[0], out[1], out[2])

    def path_rows(self, begin: float) -> PathRows:
        """Return the data of the path for compiled loops, from a path parameter on."""
        rows = self.q_start, self.q_end, self.shapes.reshape(-1)
        return PathRows(SYNCHRONISED, begin, self.length, 5, rows, None, None)


def _wrong_words(joint: int, distances: Array, bounds: Array) -> str:
    """Return the fault in the distance or the limits of a joint."""
    speed, acceleration, jerk = bounds[:, joint].tolist()
    return (
        f"joint {joint} has distance {distances[joint]:g}, speed {speed:g}, acceleration {acceleration:g}, "
        f"jerk {jerk:g}; allowed are finite distances and limits from {LEAST:g} to {MOST:g}"
    )
