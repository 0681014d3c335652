"""The border of a workspace in space as triangles."""

import numpy as np
import numpy.typing as npt

from ropsim.spatial import Array
from ropsim.workspace.ranges import TURN
from ropsim.workspace.volume.nearness import reached_at
from ropsim.workspace.volume.reachable import Reachable
from ropsim.workspace.volume.sweep import SweepKind

Faces = npt.NDArray[np.int64]
CELLS, AROUND = 90, 96
"""Cells along the longer side of the section, and around the first axis or along it."""


def surface(workspace: Reachable) -> tuple[Array, Faces]:
    """Return the border of a workspace as triangles that look outwards.

    Naive surface nets (Gibson 1998) on cells of the section times the sweep: a vertex in each cell that the
    border passes, in the middle of where it crosses the edges of the cell; so the border is off by less than
    half a cell.

    Args:
        workspace: that is swept; one in a plane has no surface.

    Returns:
        Vertices in the base frame [m], shape (k, 3), and triangles, shape (t, 3).
    """
    if workspace.sweep.kind is SweepKind.FLAT:
        return np.empty((0, 3)), np.empty((0, 3), dtype=np.int64)
    grids, there = _grid(workspace)
    vertex = np.full(np.array(there.shape) - 1, -1)
    total, count = np.zeros((*vertex.shape, 3)), np.zeros(vertex.shape)
    for axis in range(3):
        for corner in np.ndindex(2, 2):
            low = list(corner)
            low.insert(axis, 0)
            high = list(corner)
            high.insert(axis, 1)
            crossed = _shifted(there, low) != _shifted(there, high)
            middle = np.array(low, dtype=np.float64)
            middle[axis] = 0.5
            total += crossed[..., np.newaxis] * middle
            count += crossed
    used = count > 0
    vertex[used] = np.arange(used.sum())
    at = np.argwhere(used) + total[used] / count[used][:, np.newaxis]
    if workspace.sweep.kind is SweepKind.TURN:
        vertex[:, :, -1] = vertex[:, :, 0]
        there = there.copy()
        there[:, :, 0] = there[:, :, 1]  # the first cell repeats the last one, whose faces exist
    points = np.column_stack([np.interp(at[:, k], np.arange(len(g)), g) for k, g in enumerate(grids)])
    return _in_space(workspace, points), _faces(there, vertex)


def _grid(workspace: Reachable) -> tuple[tuple[Array, Array, Array], npt.NDArray[np.bool_]]:
    """Return coordinates of a grid along the section and the sweep, and which of its points are reached."""
    sweep, ends = workspace.sweep, [one.value for one in workspace.extremes]
    size = max(ends[1] - ends[0], ends[3] - ends[2]) / CELLS
    turns = sweep.kind is SweepKind.TURN
    first = -0.5 * size if turns and ends[0] < 2.0 * size else ends[0] - 1.5 * size
    u = first + size * np.arange(np.ceil((ends[1] - first) / size) + 2)
    v = ends[2] + size * (np.arange(np.ceil((ends[3] - ends[2]) / size) + 4) - 1.5)
    if turns:
        w = -np.pi + TURN / AROUND * np.arange(-1.0, AROUND + 1)  # the first cell is also the last one
    else:
        starts = workspace.section.starts
        low, high = float(starts[:, :, 1].min()), float(starts[:, :, 2].max())
        step = (high - low + sweep.reach) / AROUND
        w = low + sweep.lower + step * np.arange(-1.5, AROUND + 2.5)
    there = reached_at(workspace, np.abs(u) if turns else u, v, w)
    return (u, v, w), there


def _shifted(there: npt.NDArray[np.bool_], by: list[int]) -> npt.NDArray[np.bool_]:
    a, b, c = (slice(k, k - 1 or None) for k in by)
    return there[a, b, c]


def _faces(there: npt.NDArray[np.bool_], vertex: Faces) -> Faces:
    """Return two triangles for each edge of the grid that the border crosses."""
    found = []
    for axis in range(3):
        one, other = [k for k in range(3) if k != axis]
        size = [n - 1 if k == axis else n for k, n in enumerate(there.shape)]
        cut = tuple(slice(0, n) for n in size)
        a = there[cut]
        b = np.roll(there, -1, axis)[cut]
        for leaving in (True, False):
            edges = np.argwhere((a != b) & (a == leaving))
            inner = (edges[:, one] > 0) & (edges[:, other] > 0)
            inner &= (edges[:, one] < there.shape[one] - 1) & (edges[:, other] < there.shape[other] - 1)
            edges = edges[inner]
            quad = []
            for i, j in ((0, 0), (1, 0), (1, 1), (0, 1)):
                cell = edges.copy()
                cell[:, one] -= 1 - i
                cell[:, other] -= 1 - j
                quad.append(vertex[tuple(cell.T)])
            flipped = leaving != (axis == 1)
            order = (0, 3, 2, 1) if flipped else (0, 1, 2, 3)
            p, q, r, s = (quad[k] for k in order)
            found += [np.column_stack((p, q, r)), np.column_stack((p, r, s))]
    return np.concatenate(found)


def _in_space(workspace: Reachable, at: Array) -> Array:
    """Return places of the base frame for coordinates of section and sweep, shape (k, 3)."""
    u, v, w = at.T
    if workspace.sweep.kind is SweepKind.TURN:
        local = np.column_stack((np.maximum(u, 0.0) * np.cos(w), np.maximum(u, 0.0) * np.sin(w), v))
    else:
        local = np.column_stack((u, v, w))
    X = workspace.sweep.X_BS
    return np.asarray(local @ X[:3, :3].T + X[:3, 3])
