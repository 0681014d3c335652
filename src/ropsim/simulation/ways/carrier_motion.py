"""Motion of carriers over the rows of a recording, with a bound of what lies between two rows.

A joint leaves the straight line between two rows by h²/8 times its greatest acceleration. A point leaves it
also because links turn: the second derivatives of its place are bounded by its distance from the axes.
"""

from collections.abc import Mapping, Sequence

import numpy as np

from ropsim.collision import Carriers
from ropsim.core import frozen_dataclass
from ropsim.flow import Recording
from ropsim.kinematics import body_poses
from ropsim.model import WORLD, Body, BodyTree, JointType, Mover, coordinates, first_coordinates
from ropsim.simulation.ways.frames_kernel import write_farthest, write_seen
from ropsim.spatial import Array

ALLOWANCE = 1.5
"""Greatest acceleration between two rows over what their speeds show, where a recording does not have it."""
UNKNOWN = 2.0
"""The same for bodies of closed chains and cylinders: their coordinates are known at the rows only."""
DENSE = 5e-3
"""Between rows farther apart [s] a joint may start and stop: its largest acceleration counts there."""
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
    Q = {
        name: recording.channels[facts.channel("q", name)].values.reshape(len(time), -1)
        for name in tree.mechanisms
    }
    bends = bends_of(time, Q)
    if len(time) > 1 and time[1] - time[0] > DENSE:
        least = (time[1] - time[0]) ** 2 / 8.0
        limits = {name: one.max_accelerations for name, one in tree.mechanisms.items()}
        bends = {
            name: np.maximum(one, least * np.where(np.isfinite(limits[name]), limits[name], 0.0))
            for name, one in bends.items()
        }
    return Motion(time, Q, bends)


def bends_of(time: Array, Q: Mapping[str, Array]) -> Mapping[str, Array]:
    """Return how far coordinates may leave straight lines between rows [rad | m], shape (k - 1, n).

    Args:
        time: of the rows [s], shape (k,).
        Q: coordinates of each mechanism [rad | m], shape (k, n).
    """
    found = {}
    for name, q in Q.items():
        most = np.zeros((max(len(time) - 1, 0), q.shape[1]))
        if len(time) > 2:
            change = np.abs(np.diff(q, 2, axis=0))
            most[:-1] = change
            most[1:] = np.maximum(most[1:], change)
        found[name] = ALLOWANCE * most / 8.0
    return found


def frames_of(tree: BodyTree, wanted: CarrierSet, Q: Mapping[str, Array]) -> Array:
    """Return R_W by rows of the carriers and the place of their centres in W [m], shape (c, k, 12).

    Args:
        tree: the bodies.
        wanted: the carriers.
        Q: coordinates of each mechanism [rad | m], shape (k, n).
    """
    frames = np.empty((len(wanted.names), len(next(iter(Q.values()))), 12))
    _write_frames(wanted, body_poses(tree, Q, wanted.names), frames)
    return frames


def carriers_of(tree: BodyTree, wanted: CarrierSet, motion: Motion) -> Carriers:
    """Return the carriers over rows, then those that are seen from others.

    Args:
        tree: the bodies.
        wanted: the carriers.
        motion: of the joints at these rows.
    """
    links = _Links(tree, motion)
    count = len(wanted.names)
    frames = np.empty((count + len(wanted.seen), len(motion.time), 12))
    _write_frames(wanted, links.poses, frames)
    write_seen(frames, wanted.centres, np.array(wanted.seen, dtype=np.float64).reshape(-1, 2), count)
    ways = [links.above(name) for name in wanted.names]
    moved = [(k, way) for k, way in enumerate(ways)]
    for one, other in wanted.seen:
        above = {*ways[one]} if one >= 0 else set()
        moved.append((other, sorted({*ways[other]} ^ above)))
    return Carriers(frames, links.deviations(moved, frames))


def _write_frames(wanted: CarrierSet, poses: Mapping[str, Array], frames: Array) -> None:
    """Write the frames of carriers, shape (c, k, 12)."""
    for k, name in enumerate(wanted.names):
        X = poses[name]
        frames[k, :, :9] = X[:, :3, :3].reshape(-1, 9)
        frames[k, :, 9:] = X[:, :3, 3] + X[:, :3, :3] @ wanted.centres[k]


class _Links:
    """Bodies that joints move: how far each turns and slides between two rows, and leaves a straight line.

    Attributes:
        poses: X_WB of each by rows, shape (k, 4, 4).
    """

    def __init__(self, tree: BodyTree, motion: Motion) -> None:
        self._bodies, self._tree, self._motion = tree.by_name(), tree, motion
        self._moved = [body.name for body in tree.bodies if body.mover is not None]
        self.poses = body_poses(tree, motion.Q, self._moved)
        self._known: dict[str, tuple[Array, Array, Array, Array]] = {}

    def above(self, name: str) -> list[str]:
        """Return a body and those above it that joints move."""
        found = []
        while name != WORLD:
            if self._bodies[name].mover is not None:
                found.append(name)
            name = self._bodies[name].parent
        return found

    def deviations(self, moved: Sequence[tuple[int, Sequence[str]]], frames: Array) -> Array:
        """Return how far carriers and their axes leave straight lines between rows, shape (c, k - 1, 2).

        Args:
            moved: number of each in the frames, and the joints that move it.
            frames: by rows, shape (c, k, 12).
        """
        number = {name: k for k, name in enumerate(self._moved)}
        origins = np.array([self.poses[name][:, :3, 3] for name in self._moved])
        wanted = np.array([(k, number[name], 0.0) for k, links in moved for name in links]).reshape(-1, 3)
        write_farthest(frames, origins.reshape(len(self._moved), -1, 3), wanted)
        radii = iter(wanted[:, 2].tolist())
        count = max(len(self._motion.time) - 1, 0)
        found = np.zeros((len(moved), count, 2))
        for row, (_, links) in zip(found, moved, strict=True):
            turned, slid, farthest = np.zeros(count), np.zeros(count), 0.0
            for name, radius in zip(links, radii, strict=False):
                turn, slide, bend, shift = self._of(name)
                farthest, turned, slid = max(farthest, radius), turned + turn, slid + slide
                row[:, 0] += radius * bend + shift
                row[:, 1] += bend
            row[:, 0] += farthest * turned**2 / 8.0 + turned * slid / 4.0
            row[:, 1] += turned**2 / 8.0
        return found

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
        X = self.poses[body.name]
        above = self.above(body.parent)
        if above:
            X = np.linalg.inv(self.poses[above[0]]) @ X
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
