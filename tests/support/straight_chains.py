"""Chains of straight moves for tests of compression: made by formulas, and measured by plain searches."""

import math
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from scipy.spatial.transform import Rotation

from ropsim.motion import Compression, CurvePart, StraightPart
from ropsim.spatial import Array

SHARPEST, ODD = math.radians(35.0), math.radians(12.0)


class StraightChain(NamedTuple):
    """Arguments of `compressed`; zones of all points are the same. Lengths in m."""

    points: Array
    rotations: Array
    zones: Array
    longest: float


def chain(points: Array, zone: float, rotations: Array | None = None) -> StraightChain:
    """Return a chain through points; moves beyond 30 zones are long ones."""
    points = np.asarray(points, dtype=np.float64)
    if rotations is None:
        rotations = np.tile(np.diag([1.0, -1.0, -1.0]), (len(points), 1, 1))
    return StraightChain(points, rotations, np.full(len(points) - 2, zone), 30.0 * zone)


def wave(count: int, step: float, zone: float) -> StraightChain:
    """Return points of a flat sine curve of 20 mm over 60 mm, radius 115 mm or more."""
    along = np.arange(count) * step
    return chain(np.stack((0.35 + 0.02 * np.sin(along / 0.06), 0.8 * along, 0.45 + 0 * along), 1), zone)


def rounded_arc() -> StraightChain:
    """Return 1 mm steps on an arc of radius 40 mm, with coordinates rounded to 0.01 mm, zones of 1 mm."""
    angle = np.arange(200) / 40.0
    exact = 0.04 * np.stack((np.cos(angle), np.sin(angle), 0.0 * angle), axis=1)
    return chain(np.round(exact / 1e-5) * 1e-5, 1e-3)


def helix() -> StraightChain:
    """Return 3 mm steps on a helix of radius 50 mm whose tool tilts to and fro and yaws, zones of 1.5 mm."""
    t = np.arange(300) * 0.06
    points = 1e-3 * np.stack((50.0 * np.cos(t), 50.0 * np.sin(t), 3.0 * t), axis=1)
    turned = Rotation.from_euler("ZX", np.stack((0.3 * t, 0.5 * np.sin(t / 3.0)), axis=1))
    return chain(points, 1.5e-3, turned.as_matrix())


def uneven() -> StraightChain:
    """Return moves of 0.2 to 50 mm at random along a flat sine curve, zones of 2 mm."""
    steps = np.exp(np.random.default_rng(3).uniform(math.log(2e-4), math.log(0.05), 120))
    x = 0.95 * np.concatenate(([0.0], np.cumsum(steps)))
    return chain(np.stack((x, 0.03 * np.sin(x / 0.08), 0.0 * x), axis=1), 2e-3)


def drawn(moves: list[tuple[float, float]], step: float) -> Array:
    """Return points on lines (length in mm, 0), arcs (radius in mm, angle in °) and turns (0, angle in °)."""
    here, heading, points = np.zeros(2), 0.0, [np.zeros(2)]
    for millimetres, degrees in moves:
        size, turned = 1e-3 * millimetres, math.radians(degrees)
        if not size:
            heading += turned
            continue
        count = max(1, round((abs(size * turned) if degrees else size) / step))
        shares = np.arange(1, count + 1) / count
        if degrees:
            passed = heading + shares * turned
            around = np.stack(
                (np.sin(passed) - math.sin(heading), math.cos(heading) - np.cos(passed)), axis=1
            )
            added = here + math.copysign(size, turned) * around
            heading += turned
        else:
            added = here + np.outer(shares * size, [math.cos(heading), math.sin(heading)])
        points += list(added)
        here = added[-1]
    flat = np.array(points)
    return np.hstack((flat, np.zeros((len(flat), 1))))


def drawn_parts() -> StraightChain:
    """Return 2 mm steps of lines and arcs with four sharp turns between them, zones of 2 mm."""
    moves = [(40, 0), (0, 90), (60, 60), (0, -45), (30, 0), (40, -120), (0, 90), (40, 0), (0, 45), (80, 40)]
    return chain(drawn([(float(a), float(b)) for a, b in moves], 2e-3), 2e-3)


def contour(count: int) -> StraightChain:
    """Return 0.5 mm steps of letters with arcs of 3 to 12 mm and sharp turns, zones of 0.2 mm."""
    one = [(18, 0), (6, -180), (4, 0), (0, 120), (14, 0), (0, -60), (6, 0), (0, 100), (8, 130), (3, -150)]
    two = [(10, 0), (0, -90), (5, 0), (0, 90), (12, 90), (5, -200), (8, 0), (0, 60)]
    letters = [(float(a), float(b)) for a, b in one + two]
    return chain(drawn(letters * (count // 240 + 2), 5e-4)[:count], 2e-4)


def random_chain(rng: np.random.Generator) -> StraightChain:
    """Return a winding chain of 2 to 120 moves of uneven length, with noise, whose tool often turns."""
    moves = int(rng.integers(2, 121))
    step = math.exp(rng.uniform(math.log(3e-4), math.log(0.01)))
    steps = step * np.exp(rng.uniform(0.0, 1.5) * rng.normal(size=moves))
    t = np.concatenate(([0.0], np.cumsum(np.maximum(steps, 1e-5))))
    radius = math.exp(rng.uniform(math.log(0.01), math.log(0.4)))
    winding = (np.sin(t / radius), np.cos(t / radius * rng.uniform(0.5, 1.0)), 0.3 * np.sin(0.7 * t / radius))
    noise = rng.normal(size=(moves + 1, 3)) * step * math.exp(rng.uniform(math.log(1e-4), math.log(0.05)))
    axis = rng.normal(size=3) * math.exp(rng.uniform(-1.0, 4.0)) * float(rng.random() < 0.6)
    swing = 0.1 * rng.normal(size=3) * float(rng.random() < 0.5)
    turned = Rotation.from_rotvec(t[:, None] * axis + np.sin(t / radius)[:, None] * swing)
    zone = step * math.exp(rng.uniform(math.log(0.1), math.log(3.0)))
    return chain(
        radius * np.stack(winding, axis=1) + noise, zone, (turned * Rotation.random(rng=rng)).as_matrix()
    )


def curves(found: Compression) -> list[CurvePart]:
    """Return the curves."""
    return [part for part in found.parts if isinstance(part, CurvePart)]


def lines(found: Compression) -> list[StraightPart]:
    """Return the straight parts."""
    return [part for part in found.parts if isinstance(part, StraightPart)]


def distances_from(points: Array, positions: Array) -> Array:
    """Return the least distances of positions (m, 3) from all segments of a polyline, shape (m,)."""
    least = np.full(len(positions), np.inf)
    for one, two in pairwise(points):
        step = two - one
        shares = np.clip((positions - one) @ step / (step @ step), 0.0, 1.0)
        least = np.minimum(least, np.linalg.norm(one + shares[:, None] * step - positions, axis=1))
    return least


def samples_of(part: CurvePart, each: int = 37) -> tuple[Array, Array]:
    """Return arc lengths and the numbers of the moves on which they lie, many on each move."""
    ends = part.parameters
    bounds = [0.0] if ends[0] > 0.0 else []
    behind = [part.curve.length] if ends[-1] < part.curve.length else []
    edges = np.concatenate((bounds, ends, behind))
    first = part.first - len(bounds)
    shares = (np.arange(each) + 0.5) / each
    s = (edges[:-1, None] + np.diff(edges)[:, None] * shares).ravel()
    return s, np.repeat(np.arange(first, first + len(edges) - 1), each)


def bent_of(part: CurvePart) -> float:
    """Return the greatest curvature at many places [1/m]."""
    s, _ = samples_of(part)
    return float(np.linalg.norm(part.curve.tool(s).d2[:, :3], axis=1).max())


def is_sharp(points: Array) -> list[bool]:
    """Return which points between moves turn by more than 35°, or stand out, by loops over the definition."""
    steps = np.diff(points, axis=0)
    lengths = np.linalg.norm(steps, axis=1)
    turns = [angle(steps[k], steps[k + 1]) for k in range(len(steps) - 1)]
    dense = [turn / (0.5 * (lengths[k] + lengths[k + 1])) for k, turn in enumerate(turns)]
    found = []
    for k, turn in enumerate(turns):
        others = [dense[j] for j in (k - 2, k - 1, k + 1, k + 2) if 0 <= j < len(dense)]
        found.append(turn > SHARPEST or (turn > ODD and dense[k] > 3.0 * max(others, default=0.0)))
    return found


def widest_tolerances(given: StraightChain) -> Array:
    """Return the widest tolerance of every point, by loops over the definition, shape (k + 1,) [m].

    It is the distance of a point from the straight path through its zone, which reaches over moves up to the
    next sharp point, or that of one of two neighbours on each side, or half of that of the third.
    """
    points, sharp = given.points, is_sharp(given.points)
    steps = np.diff(points, axis=0)
    lengths = np.linalg.norm(steps, axis=1)
    along = np.concatenate(([0.0], np.cumsum(lengths)))
    stops = [0.0, *(along[k + 1] for k, is_one in enumerate(sharp) if is_one), along[-1]]
    own, least = [], []
    for k, zone in enumerate(given.zones):
        here, reach = along[k + 1], min(zone, 0.5 * lengths[k], 0.5 * lengths[k + 1])
        if not sharp[k]:
            room = min(abs(here - stop) for stop in stops)
            reach = max(reach, min(zone, room) * (1.0 - 1e-9))
        before = steps[max(np.searchsorted(along, here - reach, side="right") - 1, 0)]
        behind = steps[min(np.searchsorted(along, here + reach, side="left"), len(steps)) - 1]
        turn = max(angle(steps[k], steps[k + 1]), min(angle(before, behind), 1.0))
        own.append(0.0 if sharp[k] else reach * math.sin(0.5 * turn))
        least.append(0.01 * reach)
    found = []
    for k, bound in enumerate(least):
        near = [own[j] for j in range(k - 2, k + 3) if 0 <= j < len(own)]
        third = [0.5 * own[j] for j in (k - 3, k + 3) if 0 <= j < len(own)]
        found.append(max(*near, *third, bound))
    return np.array([found[0], *found, found[-1]])


def angle(one: Array, two: Array) -> float:
    """Return the angle between two vectors [rad]."""
    return float(math.atan2(np.linalg.norm(np.cross(one, two)), one @ two))
