"""The correction of a path: how far it is shifted, and its next step within limits."""

import math

from ropsim.core import frozen_dataclass

_GENTLE = 0.7
"""Share of the acceleration with which a correction comes to a stop that is known before."""


@frozen_dataclass
class Correction:
    """A shift of the path along a direction of the tool, over motion time.

    Attributes:
        value: [m].
        speed: its derivative [m/s].
    """

    value: float = 0.0
    speed: float = 0.0


@frozen_dataclass
class CorrectionRange:
    """Limits of a correction in its next step.

    Attributes:
        lower: least shift [m].
        upper: greatest shift [m].
        speed: greatest speed to either side [m/s].
        acceleration: greatest change of that [m/s²].
    """

    lower: float
    upper: float
    speed: float
    acceleration: float


def next_correction(
    now: Correction, speed: float, allowed: CorrectionRange, left: float, period: float
) -> Correction:
    """Return the correction one step on; in between its speed changes evenly.

    It takes up the speed that is requested, as quickly as allowed, and no more of it than lets it stand at
    the bounds of the shift and at the end of the move: from speed v it stands after v²/(2·a). It brakes in
    time for less than the acceleration that is allowed, as that may become less on the way.

    Args:
        now: at the beginning of the step.
        speed: requested at its end [m/s].
        allowed: limits.
        left: motion time behind the step, at whose end the correction stands [s].
        period: motion time of the step [s]; 0 where the motion is held, and so is the correction.
    """
    if period <= 0.0:
        return now
    a = allowed.acceleration
    top = min(allowed.speed, _GENTLE * a * left)
    requested = min(max(speed, -top), top)
    coasted = now.value + now.speed * period / 2.0
    margin = a * period * period / 8.0  # the last step of a braking may be a part of one
    gentle = _GENTLE * a
    requested = min(requested, _braking(allowed.upper - margin - coasted, gentle, period))
    requested = max(requested, -_braking(coasted - margin - allowed.lower, gentle, period))
    requested = min(max(requested, -allowed.speed), allowed.speed)
    after = min(max(requested, now.speed - a * period), now.speed + a * period)
    if left <= 0.0:
        after = 0.0
    return Correction(now.value + (now.speed + after) / 2.0 * period, after)


def _braking(distance: float, a: float, period: float) -> float:
    """Return the speed v after a step with v·T/2 + v²/(2·a) = way, negative where there is none left."""
    step = a * period / 2.0
    speed = math.sqrt(step * step + 2.0 * a * abs(distance)) - step
    return math.copysign(speed, distance)
