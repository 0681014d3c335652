"""How far a moving box or capsule is from a box that stands still.

Boxes are compared by the separating axis theorem (Gottschalk, Lin & Manocha 1996): the greatest gap along
the 15 axes is never more than the distance, so that what is found here errs on the safe side, as it does for
capsules, whose middle line is looked at in points.
"""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from ropsim.spatial import Array
from support.arm_capsules import Block

Mask = npt.NDArray[np.bool_]
FAR = 0.08
"""What is farther apart than this by the ball around the moving one is not looked at more closely [m]."""
PARALLEL = 1e-6
"""Sine of the angle below which two edges span no plane."""
NEXT = np.array([1, 2, 0])
"""The axis behind each one."""


@dataclass(frozen=True, slots=True)
class Track:
    """A moving box, or with a radius a capsule along z.

    Attributes:
        name: of the body.
        poses: of its middle, shape (k, 4, 4).
        half: half edges [m], shape (3,); a capsule has a third one only.
        radius: around it [m].
        active: whether it is there, shape (k,).
    """

    name: str
    poses: Array
    half: Array
    radius: float
    active: Mask


def least_gap(track: Track, block: Block, when: Mask) -> tuple[float, int]:
    """Return the least gap [m] at the rows of `when` (k,), and its row; infinite where it is beyond `FAR`."""
    rows = np.flatnonzero(when)
    if not len(rows):
        return np.inf, 0
    ball = float(np.linalg.norm(track.half)) + track.radius
    offset = (track.poses[rows, :3, 3] - block.centre.position) @ block.centre.rotation()
    rows = rows[_greatest(np.abs(offset) - block.half) - ball < FAR]
    if not len(rows):
        return np.inf, 0
    gap = _from_line if track.radius else _separation
    gaps = gap(track.poses[rows], track.half, block) - track.radius
    least = int(np.argmin(gaps))
    return float(gaps[least]), int(rows[least])


def _from_line(poses: Array, half: Array, block: Block) -> Array:
    """Return how far the middle line of a capsule is from a block at each pose (k, 4, 4) [m].

    A point between two samples is at most half their distance nearer than the nearest of them.
    """
    heights = np.linspace(-half[2], half[2], 33)
    points = poses[:, np.newaxis, :3, 3] + heights[:, np.newaxis] * poses[:, np.newaxis, :3, 2]
    local = np.abs((points - block.centre.position) @ block.centre.rotation()) - block.half
    beyond = np.maximum(local, 0.0)
    nearest = np.sqrt(np.einsum("khi,khi->kh", beyond, beyond).min(axis=1))
    return np.asarray(nearest - (heights[1] - heights[0]) / 2.0)


def _separation(poses: Array, half: Array, block: Block) -> Array:
    """Return the greatest gap along the separating axes of each pose (k, 4, 4); negative: they meet [m]."""
    R = block.centre.rotation().T @ poses[:, :3, :3]  # axes of the moving box in those of the block
    t = (poses[:, :3, 3] - block.centre.position) @ block.centre.rotation()
    spread = np.abs(R)
    own = np.abs(t) - block.half - spread @ half
    theirs = np.abs(np.einsum("kij,ki->kj", R, t)) - half - np.einsum("kij,i->kj", spread, block.half)
    best = np.maximum(_greatest(own), _greatest(theirs))
    near = np.flatnonzero(best < FAR)
    best[near] = np.maximum(best[near], _across(R[near], t[near], half, block.half))
    return np.asarray(best)


def _across(R: Array, t: Array, half: Array, fixed: Array) -> Array:
    """Return the greatest gap along the axes at right angles to an edge of each box [m], shape (k,).

    Args:
        R: axes of the moving box in those of the fixed one, shape (k, 3, 3).
        t: middle of the moving box there [m], shape (k, 3).
        half: half edges of the moving box [m], shape (3,).
        fixed: those of the fixed one [m], shape (3,).
    """
    spread, one, two = np.abs(R), NEXT, NEXT[NEXT]
    gap = np.abs(t[:, two, np.newaxis] * R[:, one] - t[:, one, np.newaxis] * R[:, two])
    gap -= fixed[one, np.newaxis] * spread[:, two] + fixed[two, np.newaxis] * spread[:, one]
    gap -= half[one] * spread[:, :, two] + half[two] * spread[:, :, one]
    length = np.hypot(R[:, one], R[:, two])
    crossed = length > PARALLEL
    gap = np.where(crossed, gap / np.where(crossed, length, 1.0), -np.inf)
    return _greatest(_greatest(gap))


def _greatest(three: Array) -> Array:
    """Return the greatest along the last axis of three: numpy is slow where an axis is that short."""
    return np.asarray(np.maximum(np.maximum(three[..., 0], three[..., 1]), three[..., 2]))
