"""The standard path corrector: a sensor shifts the path until it reads its set value."""

from dataclasses import field

from ropsim.core import frozen_dataclass
from ropsim.flow import PathTracking
from ropsim.model import CorrectionLimits
from ropsim.planning.records.entities import Sample
from ropsim.spatial import Pose


@frozen_dataclass
class StandardPathCorrector:
    """Integrates the difference: dc/dt = k·(measured - requested); none remains in steady state.

    Where the surface runs away with speed v along the direction, a difference of v/k remains. The speed of
    the correction is at the most a/k, so that its acceleration limit a always lets it come to rest without
    swinging past.

    Attributes:
        limits: limits of the controller.
    """

    limits: CorrectionLimits = field(default_factory=CorrectionLimits)

    def correct(self, measured: Sample, tracking: PathTracking, X_BT: Pose, correction: float) -> float:
        """Return the speed at which the shift is to change [m/s]; 0 while nothing is measured.

        Args:
            measured: present reading of the sensor.
            tracking: settings of the move.
            X_BT: pose of the tool on the planned path.
            correction: shift now [m].
        """
        del X_BT, correction
        if not measured.valid:
            return 0.0
        most = self.limits.acceleration / tracking.gain
        speed = tracking.gain * (float(measured.value) - tracking.value)
        return min(max(speed, -most), most)
