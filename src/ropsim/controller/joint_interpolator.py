"""The joint interpolator: refines joint samples to the control tick by a cubic spline."""

from dataclasses import dataclass

import numpy as np

from ropsim.flow import JointReference, JointSamples
from ropsim.spatial import Array


@dataclass(frozen=True, slots=True)
class SplineJointInterpolator:
    """The cubic spline through all samples of a move: C2, at rest at both ends, exact at the samples."""

    def refine(self, samples: JointSamples, q_start: Array, ticks_per_sample: int) -> JointReference:
        """Return references for every control tick.

        Args:
            samples: joint coordinates at the interpolation tick, k rows.
            q_start: joint coordinates at the start of the move [rad | m], shape (n,).
            ticks_per_sample: control ticks per interpolation tick.

        Returns:
            q, qd and qdd, each of shape (k·ticks_per_sample, n); the first row is one control period after
            `q_start`, the last is the last sample, at rest.
        """
        q = np.concatenate((q_start[None, :], samples.q))  # (k + 1, n)
        slopes = _slopes(q)
        u = np.arange(1, ticks_per_sample + 1) / ticks_per_sample
        pieces = np.stack((np.diff(q, axis=0), slopes[:-1], slopes[1:]), axis=1)  # (k, 3, n)
        ways = _values(u) @ pieces  # from the sample before, (k, ticks, n)
        values = q[:-1, None] + ways
        values[:, -1] = q[1:]  # exact, without the rounding of the sum
        shape = (len(samples.q) * ticks_per_sample, len(q_start))
        h = samples.period
        return JointReference(
            values.reshape(shape),
            (_first_derivatives(u) @ pieces).reshape(shape) / h,
            (_second_derivatives(u) @ pieces).reshape(shape) / (h * h),
        )


def _slopes(q: Array) -> Array:
    """Return the derivatives by the sample number at the knots, shape (k + 1, n), 0 at both ends.

    C2 continuity asks m[i-1] + 4·m[i] + m[i+1] = 3·(q[i+1] - q[i-1]) at the inner knots (de Boor 1978, A
    Practical Guide to Splines, chapter IV). With m = 0 at both ends the matrix is diagonal in sines:
    extended to an odd sequence of period 2k, the system is a circular convolution with (1, 4, 1), solved by
    the FFT.
    """
    slopes = np.zeros_like(q)
    k = len(q) - 1
    if k < 2:
        return slopes
    right = 3.0 * (q[2:] - q[:-2])  # (k - 1, n)
    odd = np.zeros((2 * k, q.shape[1]))
    odd[1:k] = right
    odd[k + 1 :] = -right[::-1]
    spectrum = np.fft.rfft(odd, axis=0)
    spectrum /= 4.0 + 2.0 * np.cos(np.pi / k * np.arange(k + 1))[:, None]
    slopes[1:k] = np.fft.irfft(spectrum, 2 * k, axis=0)[1:k]
    return slopes


def _values(u: Array) -> Array:
    """Return the cubic Hermite basis at `u` in [0, 1] for (q1 - q0, m0, m1), shape (ticks, 3)."""
    return np.stack((u * u * (3.0 - 2.0 * u), u * (1.0 - u) ** 2, u * u * (u - 1.0)), axis=1)


def _first_derivatives(u: Array) -> Array:
    """Return the first derivatives of the basis by u, shape (ticks, 3)."""
    return np.stack((6.0 * u * (1.0 - u), (1.0 - u) * (1.0 - 3.0 * u), u * (3.0 * u - 2.0)), axis=1)


def _second_derivatives(u: Array) -> Array:
    """Return the second derivatives of the basis by u, shape (ticks, 3)."""
    return np.stack((6.0 - 12.0 * u, 6.0 * u - 4.0, 6.0 * u - 2.0), axis=1)
