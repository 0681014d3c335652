"""Motion of carriers over the rows of a recording, with a bound of what lies between two rows.

A joint leaves the straight line between two rows by h²/8 times its greatest acceleration. A point leaves it
also because links turn: the second derivatives of its place are bounded by its distance from the axes.
"""

from collections.abc import Mapping, Sequence

import numpy as np

from ropsim.collision import Carriers, Collisions
from ropsim.core import frozen_dataclass
from ropsim.flow import Recording
from ropsim.kinematics import body_poses
from ropsim.model import WORLD, Body, BodyTree, JointType, Mover, coordinates, first_coordinates
from ropsim.spatial import Array

ALLOWANCE = 1.5
"""Greatest acceleration between two rows over what their speeds show, where a recording does not have it."""
UNKNOWN = 2.0
"""The same for bodies of closed chains and cylinders: their coordinates are known at the rows only."""
_ROWS = 4096
"""Rows of a block."""


@frozen_dataclass
class Motion:
    """Motion of the joints in a run.

    Attributes:
        time: of the recorded rows [s], shape (k,).
        Q: coordinates of each mechanism [rad | m], shape (k, n).
        bends: deviation of each from a straight line between two rows, at most [rad | m], shape (k - 1, n).
    """

    time: Array
    Q: Mapping[str, Array]
    bends: Mapping[str, Array]

    def rows(self, first: int, last: int) -> "Motion":
        """Return the rows from one to another one, both included."""
        Q = {name: q[first : last + 1] for name, q in self.Q.items()}
        bends = {name: one[first:last] for name, one in self.bends.items()}
        return Motion(self.time[first : last + 1], Q, bends)

    def at(self, places: Array) -> Mapping[str, Array]:
        """Return the coordinates of each mechanism at places, counted in rows, shape (k, n)."""
        below = np.clip(np.floor(places).astype(np.intp), 0, len(self.time) - 1)
        above = np.minimum(below + 1, len(self.time) - 1)
        share = (places - below)[:, np.newaxis]
        return {
            name: np.where(share > 0.0, q[below] + share * (q[above] - q[below]), q[below])
            for name, q in self.Q.items()
        }

    def time_at(self, place: float) -> float:
        """Return the time of a place, counted in rows [s]."""
        return float(np.interp(place, np.arange(len(self.time)), self.time))

    def blocks(self) -> list[tuple[int, int]]:
        """Return first and last row of blocks that follow each other; they share these rows."""
        last = len(self.time) - 1
        return [(first, min(first + _ROWS, last)) for first in range(0, max(last, 1), _ROWS)]


@frozen_dataclass
class CarrierSet:
    """Carriers whose frames are wanted.

    Attributes:
        names: of bodies that move.
        centres: point of each that stands for it, in its frame [m], shape (c, 3).
        seen: numbers of two carriers, of which the second one is expressed relative to the first, whose place
            is that of the world for -1.
    """

    names: tuple[str, ...]
    centres: Array
    seen: tuple[tuple[int, int], ...]


def joint_motion_of(tree: BodyTree, recording: Recording) -> Motion:
    """Return the motion of the joints of a recording.

    Args:
        tree: its bodies.
        recording: of the run.
    """
    time, facts = recording.time, recording.facts
    Q, bends = {}, {}
    for name in tree.mechanisms:
        q = recording.channels[facts.channel("q", name)].values.reshape(len(time), -1)
        Q[name], bends[name] = q, _bends(time, q)
    return Motion(time, Q, bends)


def _bends(time: Array, q: Array) -> Array:
    """Return how far coordinates may leave straight lines between rows [rad | m], shape (k - 1, n)."""
    if len(time) < 3:
        return np.zeros((max(len(time) - 1, 0), q.shape[1]))
    change = np.abs(np.diff(q, 2, axis=0))
    most = np.zeros((len(time) - 1, q.shape[1]))
    most[:-1] = change
    most[1:] = np.maximum(most[1:], change)
    return ALLOWANCE * most / 8.0


def frames_of(tree: BodyTree, wanted: CarrierSet, Q: Mapping[str, Array]) -> Array:
    """Return R_W by rows of the carriers and the place of their centres in W [m], shape (c, k, 12).

    Args:
        tree: the bodies.
        wanted: the carriers.
        Q: coordinates of each mechanism [rad | m], shape (k, n).
    """
    poses = body_poses(tree, Q, wanted.names)
    count = len(next(iter(Q.values())))
    frames = np.empty((len(wanted.names), count, 12))
    for k, name in enumerate(wanted.names):
        X = poses[name]
        frames[k, :, :9] = X[:, :3, :3].reshape(-1, 9)
        frames[k, :, 9:] = X[:, :3, 3] + X[:, :3, :3] @ wanted.centres[k]
    return frames


def carriers_of(solids: Collisions, wanted: CarrierSet, motion: Motion) -> Carriers:
    """Return the carriers over rows, then those that are seen from others.

    Args:
        solids: the bodies of the cell.
        wanted: the carriers.
        motion: of the joints at these rows.
    """
    tree = solids.tree
    frames = frames_of(tree, wanted, motion.Q)
    links = _Links(tree, motion)
    ways = [links.above(name) for name in wanted.names]
    deviation = [links.deviation(way, frames[k, :, 9:]) for k, way in enumerate(ways)]
    seen = []
    for one, other in wanted.seen:
        seen.append(_as_seen(frames, one, other, wanted.centres)[np.newaxis])
        between = {*ways[other]} ^ ({*ways[one]} if one >= 0 else set())
        deviation.append(links.deviation(sorted(between), frames[other, :, 9:]))
    shape = (len(deviation), max(len(motion.time) - 1, 0), 2)
    return Carriers(np.concatenate([frames, *seen]), np.array(deviation).reshape(shape))


def _as_seen(frames: Array, one: int, other: int, centres: Array) -> Array:
    """Return the frame of a carrier in that of another one by rows, shape (k, 12); -1 is the world."""
    R, p = frames[other, :, :9].reshape(-1, 3, 3), frames[other, :, 9:]
    if one >= 0:
        R_W = frames[one, :, :9].reshape(-1, 3, 3)
        origin = frames[one, :, 9:] - R_W @ centres[one]
        R, p = np.einsum("kji,kjl->kil", R_W, R), np.einsum("kji,kj->ki", R_W, p - origin)
    return np.hstack([R.reshape(-1, 9), p])


class _Links:
    """Bodies that joints move: how far each turns and slides between two rows, and leaves a straight line."""

    def __init__(self, tree: BodyTree, motion: Motion) -> None:
        self._bodies, self._tree, self._motion = tree.by_name(), tree, motion
        moved = [body.name for body in tree.bodies if body.mover is not None]
        self._poses = body_poses(tree, motion.Q, moved) if len(motion.time) > 1 else {}
        self._known: dict[str, tuple[Array, Array, Array, Array]] = {}

    def above(self, name: str) -> list[str]:
        """Return a body and those above it that joints move."""
        found = []
        while name != WORLD:
            if self._bodies[name].mover is not None:
                found.append(name)
            name = self._bodies[name].parent
        return found

    def deviation(self, links: Sequence[str], place: Array) -> Array:
        """Return how far a point and its axes leave straight lines between rows, shape (k - 1, 2).

        Args:
            links: joints that move it.
            place: of the point at the rows [m], shape (k, 3).
        """
        count = max(len(self._motion.time) - 1, 0)
        turned, slid, away, tilted = (np.zeros(count) for _ in range(4))
        farthest = 0.0
        for name in links if count else ():
            turn, slide, bend, shift = self._of(name)
            radius = float(np.linalg.norm(place - self._poses[name][:, :3, 3], axis=1).max())
            farthest = max(farthest, radius)
            turned, slid, tilted = turned + turn, slid + slide, tilted + bend
            away = away + radius * bend + shift
        curved = turned**2 / 8.0
        return np.column_stack([away + farthest * curved + turned * slid / 4.0, tilted + curved])

    def _of(self, name: str) -> tuple[Array, Array, Array, Array]:
        """Return turn [rad] and slide [m] of a link from row to row, and deviations of both."""
        if name not in self._known:
            body = self._bodies[name]
            driven = self._driven(body.mover) if isinstance(body.mover, Mover) else None
            self._known[name] = driven or self._seen(body)
        return self._known[name]

    def _driven(self, mover: Mover) -> tuple[Array, Array, Array, Array] | None:
        """Return the motion of a link by the coordinate of its joint; None where that does not tell all."""
        mechanism = self._tree.mechanisms[mover.mechanism]
        kind = mechanism.joints[mover.joint].type
        if mechanism.cuts or kind not in (JointType.REVOLUTE, JointType.PRISMATIC):
            return None
        T = coordinates(mechanism).T[first_coordinates(mechanism.joints)[mover.joint]]
        gone = np.abs(np.diff(self._motion.Q[mover.mechanism], axis=0) @ T)
        bend, none = self._motion.bends[mover.mechanism] @ np.abs(T), np.zeros(len(gone))
        return (gone, none, bend, none) if kind is JointType.REVOLUTE else (none, gone, none, bend)

    def _seen(self, body: Body) -> tuple[Array, Array, Array, Array]:
        """Return the motion of a link by its frame in that of its parent at the rows."""
        X = self._poses[body.name]
        above = self.above(body.parent)
        if above:
            X = np.linalg.inv(self._poses[above[0]]) @ X
        R, p = X[:, :3, :3], X[:, :3, 3]
        turn = np.linalg.norm(np.diff(R, axis=0).reshape(-1, 9), axis=1) / np.sqrt(2.0)
        slide = np.linalg.norm(np.diff(p, axis=0), axis=1)
        return 1.05 * turn, slide, _changes(R.reshape(-1, 9)) / np.sqrt(2.0), _changes(p)


def _changes(values: Array) -> Array:
    """Return by how much values may leave straight lines between rows, shape (k - 1,)."""
    found = np.zeros(len(values) - 1)
    if len(values) > 2:
        change = np.linalg.norm(np.diff(values, 2, axis=0), axis=1)
        found[:-1] = change
        found[1:] = np.maximum(found[1:], change)
    return UNKNOWN * found / 8.0
