"""The joint interpolator: joint samples along a path as one smooth path of the joints."""

from ropsim.core import frozen_dataclass
from ropsim.flow import JointSamples
from ropsim.motion import JointPath, SampledPath, sampled_with_error
from ropsim.spatial import Array


@frozen_dataclass
class StandardJointInterpolator:
    """Goes through all samples with continuous speed and acceleration, see `motion.SampledPath`."""

    def refine(self, samples: JointSamples) -> JointPath:
        """Return the path of the joints through samples.

        Args:
            samples: at equally spaced path parameters, or with their derivatives; two or more rows.
        """
        if samples.derivatives is None or samples.parameters is None:
            return SampledPath(samples.length, samples.q)
        return SampledPath(samples.length, samples.q, samples.derivatives, samples.parameters)

    def refine_with_roughness(self, samples: JointSamples) -> tuple[JointPath, Array | None]:
        """Return the same, and how far the path through every second sample passes the others [rad | m].

        Args:
            samples: at equally spaced path parameters, two or more rows.

        Returns:
            the path and that distance at each sample between, shape (m,) for 2·m + 1 samples; None for it
            where they are fewer than 17 or of even number.
        """
        return sampled_with_error(samples.length, samples.q)
