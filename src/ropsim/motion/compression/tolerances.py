"""Tolerances: how far a curve may be from the points of a chain, and which moves and points it leaves out."""

from enum import IntEnum

import numpy as np
import numpy.typing as npt

from ropsim.motion.blends.blend_curve import SWING
from ropsim.motion.compression.chain import Chain
from ropsim.spatial import Array, cross, record

Flags = npt.NDArray[np.bool_]
Numbers = npt.NDArray[np.int64]
SHARPEST = 0.6108652381980153
"""Turns beyond it, 35°, keep their own blend [rad]."""
ODD_TURN, ODD_RATIO = 0.20943951023931953, 3.0
"""Turns beyond 12° [rad] also keep it if per length they exceed those next to them by this ratio."""
LEAST = 0.01
"""Of the zone: least tolerance."""
TURN_BY_ZONE = 1.7453292519943295
"""Tolerance of the orientation by the zone, 0.1° per mm [rad/m]."""
LEAST_TURN = 1e-6
"""Least tolerance of the orientation [rad]."""
_WIDEST_TURN = 1.0
"""Turns within a zone count up to this angle [rad]."""
_BELOW = 1.0 - 1e-9
"""So that a zone that ends at a point ends in front of it."""
_BOW = 24.0
"""A curve with turns θ at both ends of a move of length L bows by at most L·θ/16; a third of it in hand."""


class Sharp(IntEnum):
    """Why a point keeps its own blend before any curve is tried."""

    NOT = 0
    TURN = 1
    ODD = 2


@record
class Tolerances:
    """Bounds of a curve, and moves that no curve passes.

    Attributes:
        position: at the points [m], shape (k + 1,).
        orientation: at the points [rad], shape (k + 1,).
        straight: moves that stay straight lines, shape (k,).
        wide: points whose bound is the straight path through the zone, shape (k + 1,).
    """

    position: Array
    orientation: Array
    straight: Flags
    wide: Flags


def sharp_points(chain: Chain) -> Numbers:
    """Return for the points between moves whether they are sharp (`Sharp`), shape (k - 1,)."""
    turns = chain.turns
    per_length = turns / (0.5 * (chain.lengths[:-1] + chain.lengths[1:]))
    others = _shifted(per_length, (-2, -1, 1, 2)).max(axis=0)
    odd = (turns > ODD_TURN) & (per_length > ODD_RATIO * others)
    return np.where(turns > SHARPEST, Sharp.TURN, np.where(odd, Sharp.ODD, Sharp.NOT)).astype(np.int64)


def tolerances(chain: Chain, sharp: Flags, wide: Flags, longest: float) -> Tolerances:
    """Return the tolerances of a chain.

    That of a point is the deviation of its own blend, with the zone taken over several moves: as programmed,
    up to the next sharp point. The largest one of two neighbours on each side counts, and half of that of
    the third. Where a move bows by more than that, and where it is requested, the distance of the point from
    the straight path through the zone takes its place. A move whose curve would still bow by more, or whose
    orientation would, stays straight.

    Args:
        chain: of straight moves.
        sharp: points between moves that keep their own blend, shape (k - 1,).
        wide: points with the wider bound, shape (k + 1,).
        longest: moves that are longer stay straight [m].
    """
    if len(chain.lengths) < 2:
        return Tolerances(np.zeros(2), np.zeros(2), np.ones(1, np.bool_), wide)
    zones, turns = _over_moves(chain, sharp)
    of_blend = np.where(sharp, 0.0, _blend_deviation(zones, turns))
    of_zone = np.where(sharp, 0.0, zones * np.sin(0.5 * turns))
    bow = _bows(chain, np.where(sharp, 0.0, chain.turns))
    narrow = _window(of_blend, zones)
    wide = wide.copy()
    too_far = bow > np.maximum(narrow[:-1], narrow[1:])
    wide[:-1] |= too_far
    wide[1:] |= too_far
    position = _window(np.where(wide[1:-1], of_zone, of_blend), zones)
    orientation = np.maximum(TURN_BY_ZONE * _with_ends(chain.cut_zones), LEAST_TURN)
    straight = (chain.lengths > longest) | (bow > np.maximum(position[:-1], position[1:]))
    turn_bow = _bows(chain, np.where(sharp, 0.0, chain.turn_changes))
    straight |= turn_bow > np.maximum(orientation[:-1], orientation[1:])
    return Tolerances(position, orientation, straight, wide)


def _over_moves(chain: Chain, sharp: Flags) -> tuple[Array, Array]:
    """Return zones that reach over several moves [m], and the turns from where they begin to their ends."""
    at, cut = chain.ends[1:-1], chain.cut_zones
    stops = np.concatenate(([0.0], at[sharp], chain.ends[-1:]))
    behind = np.searchsorted(stops, at, side="right")
    margin = np.minimum(at - stops[behind - 1], stops[np.minimum(behind, len(stops) - 1)] - at)
    zones = np.where(sharp, cut, np.maximum(cut, _BELOW * np.minimum(chain.zones, margin)))
    last = len(chain.lengths) - 1
    first = np.clip(np.searchsorted(chain.ends, at - zones, side="right") - 1, 0, last)
    behind = np.clip(np.searchsorted(chain.ends, at + zones, side="left") - 1, 0, last)
    one, two = chain.directions[first], chain.directions[behind]
    sines = np.linalg.norm(cross(one, two), axis=1)
    over = np.arctan2(sines, np.einsum("ij,ij->i", one, two))
    return zones, np.maximum(chain.turns, np.where(sharp, 0.0, np.minimum(over, _WIDEST_TURN)))


def _blend_deviation(zones: Array, turns: Array) -> Array:
    """Return how far the blend of two straight lines (`blend_curve`) is from their common point [m]."""
    scale = SWING * np.sqrt(np.cos(np.minimum(0.5 * turns, 0.5 * np.pi)))
    return np.asarray(2.0 * zones * np.sin(0.5 * turns) * (0.5 - 5.0 / 32.0 * scale))


def _bows(chain: Chain, changes: Array) -> Array:
    """Return how far the curve that the changes at both ends of the moves suggest is from them, (k,).

    Args:
        chain: of straight moves.
        changes: of the direction [rad] or of the turn of the tool by the length [rad/m], shape (k - 1,); the
            result is in m or rad.
    """
    padded = np.concatenate(([0.0], changes, [0.0]))
    return np.asarray(chain.lengths * (padded[:-1] + padded[1:]) / _BOW)


def _window(values: Array, zones: Array) -> Array:
    """Return the largest of five neighbours, half of the third ones and the least tolerance, (k + 1,)."""
    near = _shifted(values, (-2, -1, 0, 1, 2)).max(axis=0)
    far = 0.5 * _shifted(values, (-3, 3)).max(axis=0)
    return _with_ends(np.maximum(np.maximum(near, far), LEAST * zones))


def _shifted(values: Array, offsets: tuple[int, ...]) -> Array:
    """Return an array moved by each offset, with 0 beyond its ends, shape (offsets, values)."""
    padded = np.concatenate((np.zeros(3), values, np.zeros(3)))
    return np.stack([padded[3 + offset : 3 + offset + len(values)] for offset in offsets])


def _with_ends(values: Array) -> Array:
    """Return values of the points between moves, the first and the last one again for the end points."""
    return np.concatenate((values[:1], values, values[-1:]))
