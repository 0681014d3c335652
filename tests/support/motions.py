"""Planned motions over motion time and torques of bodies that are none, for the keeping of limits."""

import numpy as np

from ropsim.motion import Effort, JointPoints, PathMotion, no_path_motion
from ropsim.spatial import Array


class Waves:
    """Sums of sines of a way that goes from rest to rest with jerk 0 at both ends, n joints.

    Args:
        random: where sizes, frequencies and phases come from.
        n: joints.
        duration: [s].
        size: of the sines [rad].
        most: highest frequency [1/s].
    """

    def __init__(
        self, random: np.random.Generator, n: int, duration: float, size: float, most: float
    ) -> None:
        self.duration = duration
        self._size = random.normal(size=(4, n)) * size
        self._circular = random.uniform(most / 10.0, most, size=(4, n)) * 2.0 * np.pi
        self._phase = random.uniform(0.0, 2.0 * np.pi, size=(4, n))

    def at(self, phi: Array) -> JointPoints:
        r, r1, r2 = rest_to_rest(phi, self.duration)
        angle = self._circular * r[:, :, None] + self._phase
        q = (self._size * np.sin(angle)).sum(axis=1)
        d = (self._size * self._circular * np.cos(angle)).sum(axis=1)
        dd = -(self._size * self._circular**2 * np.sin(angle)).sum(axis=1)
        return JointPoints(q, d * r1, dd * r1**2 + d * r2)

    def path_motion(self, phi: Array) -> PathMotion:
        return no_path_motion(len(phi))


class Passing:
    """One joint goes at 0.5 rad/s; the other turns by half a turn within a short way when that is midway."""

    def __init__(self, duration: float, width: float) -> None:
        self.duration, self._width = duration, width

    def at(self, phi: Array) -> JointPoints:
        r, r1, r2 = rest_to_rest(phi, self.duration)
        y, b = (r - self.duration / 2.0) / self._width, self._width
        q = np.hstack((0.5 * r, np.arctan(y)))
        d = np.hstack((np.full_like(r, 0.5), 1.0 / (b * (1.0 + y**2))))
        dd = np.hstack((np.zeros_like(r), -2.0 * y / (b * (1.0 + y**2)) ** 2))
        return JointPoints(q, d * r1, dd * r1**2 + d * r2)

    def path_motion(self, phi: Array) -> PathMotion:
        return no_path_motion(len(phi))


def rest_to_rest(phi: Array, duration: float) -> tuple[Array, Array, Array]:
    """Return a way from 0 to `duration` that begins and ends without jerk, and two derivatives, (k, 1)."""
    z = np.clip(phi / duration, 0.0, 1.0)[:, None]
    return (
        duration * z**4 * (35.0 - 84.0 * z + 70.0 * z**2 - 20.0 * z**3),
        140.0 * (z * (1.0 - z)) ** 3,
        420.0 * (z * (1.0 - z)) ** 2 * (1.0 - 2.0 * z) / duration,
    )


def body(random: np.random.Generator, n: int) -> Effort:
    """Return torques like those of a rigid body: M(q)·qdd + products of speeds + gravity + friction."""
    coupling = random.normal(size=(n, n)) * 0.3
    products = random.normal(size=(n, n, n)) * 0.1
    gravity, phase = random.normal(size=n) * 2.0, random.uniform(0.0, 6.0, size=n)
    viscous, coulomb = random.uniform(0.5, 2.0, size=n), random.uniform(0.2, 1.0, size=n)
    inertia = np.diag(np.sqrt(random.uniform(1.0, 3.0, size=n)))

    def effort(q: Array, qd: Array, qdd: Array) -> Array:
        root = inertia + coupling * np.cos(q.sum(axis=1))[:, None, None]
        mass = root @ root.transpose(0, 2, 1)
        inner = np.einsum("kij,kj->ki", mass, qdd) + np.einsum("ijl,kj,kl->ki", products, qd, qd) * np.sin(q)
        return np.asarray(inner + gravity * np.sin(q + phase) + viscous * qd + coulomb * np.tanh(qd / 5e-3))

    return effort


def most_of(motion: Waves) -> tuple[Array, Array, Array]:
    """Return the greatest speeds, accelerations and jerks of a motion, each (n,)."""
    t = np.linspace(0.0, motion.duration, 2001)
    points = motion.at(t)
    jerk = np.abs(np.diff(points.d2, axis=0)).max(axis=0) / t[1]
    return np.abs(points.d1).max(axis=0), np.abs(points.d2).max(axis=0), jerk
