"""The path corrector with an integral: it takes up a steady slope."""

from dataclasses import replace

from ropsim.flow import PathTracking
from ropsim.model import CorrectionLimits
from ropsim.planning.records.entities import Sample
from ropsim.planning.records.motion_chain import MotionChain
from ropsim.spatial import Pose


class ProportionalIntegralCorrector:
    """Takes up a steady slope: dc/dt = k·e + (k²/4)·∫e dt, with e = measured - requested.

    Where the surface runs away with a constant speed along the direction, no difference remains; the loop
    comes there without swinging (both poles at k/2). The integral begins anew with each move, and stands
    still while the speed is clipped. It counts a whole interpolation period at each reading.

    Args:
        limits: limits of the controller.
        period: of interpolation [s].
    """

    __slots__ = ("_integral", "_most", "_period", "_speed", "_tracking")

    def __init__(self, limits: CorrectionLimits, period: float) -> None:
        self._most, self._speed, self._period = limits.acceleration, limits.speed, period
        self._integral, self._tracking = 0.0, None  # type: tuple[float, PathTracking | None]

    def correct(self, measured: Sample, tracking: PathTracking, X_BT: Pose, correction: float) -> float:
        """Return the speed at which the shift is to change [m/s]; 0 while nothing is measured.

        Args:
            measured: present reading of the sensor.
            tracking: settings of the move.
            X_BT: pose of the tool on the planned path.
            correction: shift now [m].
        """
        del X_BT
        if tracking is not self._tracking or correction == 0.0:
            self._tracking, self._integral = tracking, 0.0
        if not measured.valid:
            return 0.0
        most, gain = min(self._most / tracking.gain, self._speed), tracking.gain
        difference = float(measured.value) - tracking.value
        speed = gain * difference + self._integral
        if abs(speed) < most or speed * difference < 0.0:
            self._integral += 0.25 * gain * gain * difference * self._period
        return min(max(speed, -most), most)


def proportional_integral(chain: MotionChain) -> MotionChain:
    """Return a chain with this path corrector.

    Args:
        chain: with limits of the correction and interpolation period in its controller.
    """
    controller = chain.controller
    period = controller.rates.interpolation_period
    return replace(chain, corrector=ProportionalIntegralCorrector(controller.correction, period))
