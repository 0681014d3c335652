"""How far places are from a workspace."""

import numpy as np
import numpy.typing as npt

from ropsim.spatial import Array
from ropsim.workspace.ranges import TURN
from ropsim.workspace.volume.raster import Section, lattice_coordinates
from ropsim.workspace.volume.raster_kernel import FULL, MOST
from ropsim.workspace.volume.reachable import Reachable
from ropsim.workspace.volume.sweep import Sweep, SweepKind


def distances(workspace: Reachable, p: Array) -> Array:
    """Return how far places are from a workspace, exact to the spacing of its section [m], shape (k,).

    Args:
        workspace: of a point of an arm.
        p: places in the base frame [m], shape (k, 3).

    Returns:
        0 inside; inf where the arm reaches nothing at all.
    """
    section, sweep = workspace.section, workspace.sweep
    there = section.covered > 0.0
    places, intervals = section.places()[there], section.starts[there]
    if not len(places):
        return np.full(len(p), np.inf)
    local = (p - sweep.X_BS[:3, 3]) @ sweep.X_BS[:3, :3]
    found = np.array([_nearest(section, sweep, (places, intervals), one) for one in local])
    return np.where(found <= section.spacing, 0.0, found)


def reached_at(workspace: Reachable, u: Array, v: Array, w: Array) -> npt.NDArray[np.bool_]:
    """Return which points of a grid are reached, shape (len(u), len(v), len(w)).

    Args:
        workspace: of a point of an arm.
        u: first coordinates in the section [m].
        v: second ones [m].
        w: azimuths [rad] or lengths along the sweep [m].
    """
    section = workspace.section
    places = np.stack(np.meshgrid(u, v, indexing="ij"), axis=-1).reshape(-1, 2)
    index = np.round(lattice_coordinates(places, section.spacing) - section.corner).astype(int)
    last = np.array(section.covered.shape) - 1
    kept = np.clip(index, 0, last)
    intervals = section.starts[kept[:, 0], kept[:, 1]]
    covered = (index == kept).all(axis=1) & (section.covered[kept[:, 0], kept[:, 1]] > 0.0)
    there = np.stack([covered & (gaps(workspace.sweep, intervals, float(one)) == 0.0) for one in w], axis=-1)
    return there.reshape(len(u), len(v), len(w))


def gaps(sweep: Sweep, intervals: Array, value: float) -> Array:
    """Return how far a value of the third coordinate is from the range of the sweep, shape (k,) [rad | m].

    Args:
        sweep: of the first axis.
        intervals: of lattice points, as `Section.starts` has them, shape (k, 1 + 2·MOST).
        value: azimuth [rad] or length [m].
    """
    count = intervals[:, :1]
    low, high = intervals[:, 1::2] + sweep.lower, intervals[:, 2::2] + sweep.lower + sweep.reach
    off = np.full(low.shape, value)
    if sweep.kind is SweepKind.TURN:
        off += TURN * np.round((0.5 * (low + high) - value) / TURN)
    beyond = np.maximum(np.maximum(low - off, off - high), 0.0)
    beyond = np.where(np.arange(MOST) < count, beyond, np.inf).min(axis=1)
    return np.where(count[:, 0] == FULL, 0.0, beyond)


def _nearest(section: Section, sweep: Sweep, border: tuple[Array, Array], local: Array) -> float:
    x, y, z = local.tolist()
    if _within(section, sweep, local):
        return 0.0
    places, intervals = border
    if sweep.kind is SweepKind.FLAT:
        return float(np.hypot(np.hypot(places[:, 0] - x, places[:, 1] - y).min(), z))
    if sweep.kind is SweepKind.SLIDE:
        off = gaps(sweep, intervals, z)
        return float(np.sqrt((places[:, 0] - x) ** 2 + (places[:, 1] - y) ** 2 + off**2).min())
    radius, angle = np.hypot(x, y), gaps(sweep, intervals, float(np.arctan2(y, x)))
    angle = np.minimum(angle, np.pi)
    flat = places[:, 0] ** 2 + radius**2 - 2.0 * places[:, 0] * radius * np.cos(angle)
    return float(np.sqrt(np.maximum(flat, 0.0) + (places[:, 1] - z) ** 2).min())


def _within(section: Section, sweep: Sweep, local: Array) -> bool:
    """Return whether the lattice point next to a place in the frame of the sweep (3,) is reached there."""
    x, y, z = local.tolist()
    if sweep.kind is SweepKind.FLAT and abs(z) > section.spacing:
        return False
    turns = sweep.kind is SweepKind.TURN
    place, third = ((np.hypot(x, y), z), float(np.arctan2(y, x))) if turns else ((x, y), z)
    index = np.round(lattice_coordinates(np.array([place]), section.spacing)[0] - section.corner).astype(int)
    if (index < 0).any() or (index >= section.covered.shape).any() or not section.covered[tuple(index)]:
        return False
    return sweep.kind is SweepKind.FLAT or not gaps(sweep, section.starts[tuple(index)][np.newaxis], third)[0]
