"""Run: moves of a chain that may become one curve, with their polyline and tolerances."""

import math

import numpy as np

from ropsim.motion.compression.chain import Chain
from ropsim.motion.compression.quaternion_rows import between
from ropsim.motion.compression.tolerances import Flags, Tolerances
from ropsim.spatial import Array, record

_SHARE_OF_LINE = 0.45
"""Greatest share of a line that belongs to the curve at each of its ends."""
_SMALL = 1e-12
"""Quaternions that differ by less are the same orientation."""


@record
class Run:
    """Moves first .. last - 1 of a chain, and the ends on the lines before and behind.

    Attributes:
        first: number of its first point.
        last: number of its last point.
        before: length on the line before [m], 0 where it begins at the first point.
        behind: length on the line behind [m], 0 where it ends at the last point.
    """

    first: int
    last: int
    before: float
    behind: float


@record
class Polyline:
    """The n moves of a run, with its ends on lines before and behind, and their tolerances.

    Attributes:
        run: moves of the chain.
        points: shape (n + 1, 3) [m].
        quaternions: orientations there, shape (n + 1, 4).
        position: tolerances at the points [m], shape (n + 1,).
        orientation: tolerances of the moves [rad], shape (n,).
        unit: mean length of the moves [m].
        ends: lengths up to the points by the unit, shape (n + 1,).
    """

    run: Run
    points: Array
    quaternions: Array
    position: Array
    orientation: Array
    unit: float
    ends: Array

    @property
    def turns(self) -> bool:
        """Return whether the orientation changes."""
        return bool(np.ptp(self.quaternions, axis=0).max() > _SMALL)


def run_of(chain: Chain, straight: Flags, broken: Flags, first: int, last: int) -> Run:
    """Return the run of moves first .. last - 1 with its ends on straight moves next to it.

    Args:
        chain: of all moves.
        straight: whether a move stays straight, shape (k,).
        broken: whether a point keeps its own blend, shape (k + 1,).
        first: number of the first point.
        last: number of the last point.
    """
    before = behind = 0.0
    if joins_line(straight, broken, first, first - 1):
        before = _reach(chain, first - 1, first, first)
    if joins_line(straight, broken, last, last):
        behind = _reach(chain, last, last - 1, last)
    return Run(first, last, before, behind)


def joins_line(straight: Flags, broken: Flags, point: int, move: int) -> bool:
    """Return whether a curve that ends at a point goes on to a straight move there."""
    return 0 <= move < len(straight) and bool(straight[move] and not broken[point])


def _reach(chain: Chain, line: int, move: int, point: int) -> float:
    """Return how far the curve of a move reaches beyond a point on a line [m]."""
    reach = max(chain.zones[point - 1], chain.lengths[move])
    return float(min(_SHARE_OF_LINE * chain.lengths[line], reach))


def polyline_of(chain: Chain, allowed: Tolerances, run: Run) -> Polyline:
    """Return the polyline of a run; on lines the tool turns evenly."""
    first, last = run.first, run.last
    points, quaternions = chain.points[first : last + 1], chain.quaternions[first : last + 1]
    position, orientation = allowed.position[first : last + 1], allowed.orientation[first : last + 1]
    if run.before:
        end = points[:1] - run.before * chain.directions[first - 1]
        points = np.concatenate((end, points))
        on_line = _on_line(chain, first - 1, 1.0 - run.before / chain.lengths[first - 1])
        quaternions = np.concatenate((on_line, quaternions))
        position = np.concatenate((position[:1], position))
        orientation = np.concatenate((orientation[:1], orientation))
    if run.behind:
        end = points[-1:] + run.behind * chain.directions[last]
        points = np.concatenate((points, end))
        quaternions = np.concatenate((quaternions, _on_line(chain, last, run.behind / chain.lengths[last])))
        position = np.concatenate((position, position[-1:]))
        orientation = np.concatenate((orientation, orientation[-1:]))
    steps = np.diff(points, axis=0)
    lengths = np.sqrt(np.einsum("ij,ij->i", steps, steps))
    unit = math.fsum(lengths) / len(lengths)
    ends = np.concatenate(([0.0], np.cumsum(lengths / unit)))
    of_moves = np.minimum(orientation[:-1], orientation[1:])
    return Polyline(run, points, quaternions, position, of_moves, unit, ends)


def _on_line(chain: Chain, move: int, share: float) -> Array:
    """Return the orientation at a share of a move, shape (1, 4)."""
    one, two = chain.quaternions[move : move + 1], chain.quaternions[move + 1 : move + 2]
    return between(one, two, np.array([share]))
