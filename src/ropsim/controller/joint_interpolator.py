"""The joint interpolator: joint samples along a path as one smooth path of the joints."""

from ropsim.core import frozen_dataclass
from ropsim.flow import JointSamples
from ropsim.motion import JointPath, Traced


@frozen_dataclass
class StandardJointInterpolator:
    """Goes through all samples; speed and acceleration along the path are continuous, see `motion.Traced`."""

    def refine(self, samples: JointSamples) -> JointPath:
        """Return the path of the joints through samples.

        Args:
            samples: at equally spaced places, two or more rows.
        """
        return Traced(samples.length, samples.q)
