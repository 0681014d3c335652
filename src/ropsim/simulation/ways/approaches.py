"""Checked pairs of tracks, and their distances."""

from collections.abc import Callable, Iterator, Mapping, Sequence

import numpy as np
import numpy.typing as npt

from ropsim.collision import (
    AS_AT_START,
    Approach,
    Carriers,
    Collisions,
    LeftOut,
    Pair,
    carried,
    closest,
    left_out,
    owners,
)
from ropsim.core import frozen_dataclass
from ropsim.flow import Recording
from ropsim.kinematics import body_poses
from ropsim.model import WORLD, BodyKind
from ropsim.simulation.ways.intents import Intents, Span
from ropsim.simulation.ways.tracks import Track
from ropsim.spatial import Array, record

Rows = npt.NDArray[np.intp]
"""Numbers of rows."""

COARSE = 0.02
"""Interval of the rows that are checked first [s]; where bodies may be near, all rows are."""
GLANCE = 16
"""Every this many of these rows are checked at the very first: they show the least distance approximately."""
GLANCED, SEEN = 0.15, 0.85
"""Shares of the whole: the first look, and that at all rows that are far apart."""
SLACK = 1.1
"""Allowance for motion between two rows beyond a straight line."""


@record
class TrackPairs:
    """Pairs of convex bodies on tracks.

    Attributes:
        tracks: all of them.
        items: convex bodies on carriers, see `closest`.
        owner: number of the track of each item, shape (t,).
        carriers: names of carriers, by number.
        seen: numbers of two carriers, of which the second one is expressed relative to the first.
        pairs: items, times from and until [s], 1 where the least distance counts, the row of `travel`, and
            the distance at which an episode begins [m]; shape (p, 7).
    """

    tracks: tuple[Track, ...]
    items: Array
    owner: tuple[int, ...]
    carriers: tuple[str, ...]
    seen: tuple[tuple[int, int], ...]
    pairs: Array


@frozen_dataclass
class Motion:
    """Motion of the joints in a run.

    Attributes:
        time: of the recorded rows [s], shape (k,).
        Q: coordinates of each mechanism [rad | m], shape (k, n).
        steps: how far each joint goes from row to row [rad | m], shape (k - 1, n).
    """

    time: Array
    Q: Mapping[str, Array]
    steps: Mapping[str, Array]


@record
class Nearest:
    """How near pairs come.

    Attributes:
        gaps: least distance that was found of each pair [m], shape (p,); inf where another one was nearer.
        rows: of the recording where that was, shape (p,).
        episodes: pair, first and last row of the recording in which two are near enough, shape (m, 3).
        step: rows of the recording between two that were checked, at most.
    """

    gaps: Array
    rows: Rows
    episodes: Rows
    step: int


def pairs_on_tracks(
    solids: Collisions,
    made: Sequence[Track],
    intents: Intents,
    met: frozenset[Pair],
    clearance: float,
) -> TrackPairs:
    """Return the pairs that are checked.

    Omitted are the pairs of `left_out` of `ropsim.collision`, pairs that overlap at the start, and gripped
    parts during the grip. Distances within one robot, its tool and held parts do not count as the least one:
    they are nearly constant. The same holds for distances between a part and the body that it is taken from
    or put on.

    Args:
        solids: the bodies of the cell.
        made: tracks of all bodies.
        intents: when bodies touch on purpose.
        met: pairs that are not checked.
        clearance: distance of pairs that count at which an episode begins [m].
    """
    seen = tuple(track for track in made if track.body in solids.bodies.rows)
    carriers = tuple(dict.fromkeys(track.carrier for track in seen if track.carrier != WORLD))
    number = {WORLD: -1} | {name: k for k, name in enumerate(carriers)}
    items: list[Array] = []
    owner: list[int] = []
    own: list[Rows] = []
    for k, track in enumerate(seen):
        solid = solids.bodies.rows[track.body]
        own.append(np.arange(len(items), len(items) + len(solid)))
        owner += [k] * len(solid)
        items += [carried(solids.bodies, one, number[track.carrier], track.X_CB) for one in solid]
    bodies = solids.tree.by_name()
    built = [name for name in solids.bodies.rows if bodies[name].kind is not BodyKind.PART]
    why = left_out(solids.tree, built, AS_AT_START)
    never = met | {*solids.at_rest} | {pair for pair in why if why[pair] is not LeftOut.FIXED}
    belongs = owners(solids.tree, bodies.keys())
    rows: list[Array] = []
    between: dict[tuple[int, int], int] = {}
    for one, other, span, counts in _pairs(seen, intents, never, belongs):
        a, b = own[one], own[other]
        block = np.empty((len(a) * len(b), 7))
        block[:, 0], block[:, 1] = np.repeat(a, len(b)), np.tile(b, len(a))
        block[:, 2:5], block[:, 5], block[:, 6] = (*span, counts), -1.0, clearance * counts
        if not counts:  # of one arm: it moves as a whole more than its links against each other
            both = number[seen[one].carrier], number[seen[other].carrier]
            block[:, 5] = len(carriers) + between.setdefault(both, len(between))
        rows.append(block)
    pairs = np.concatenate([np.empty((0, 7)), *rows])
    return TrackPairs(seen, np.array(items).reshape(-1, 22), tuple(owner), carriers, tuple(between), pairs)


def nearest(
    solids: Collisions, checked: TrackPairs, recording: Recording, progress: Callable[[float], None]
) -> Nearest:
    """Return how near pairs come: at rows far apart first, then at all rows where anything may be near.

    Args:
        solids: the bodies of the cell.
        checked: the checked pairs.
        recording: of the run.
        progress: called with the share of the paths that has been checked.
    """
    time = recording.time
    Q = {
        name: recording.channels[recording.facts.channel("q", name)].values.reshape(len(time), -1)
        for name in solids.tree.mechanisms
    }
    motion = Motion(time, Q, {name: np.abs(np.diff(q, axis=0)) for name, q in Q.items()})
    step = max(1, round(COARSE / (time[1] - time[0]))) if len(time) > 1 else 1
    ends = np.searchsorted(time, [one for track in checked.tracks for one in (track.start, track.end)])
    edges = np.concatenate([ends, ends - 1, [0, len(time) - 1]])
    rows = np.unique(np.concatenate([np.arange(0, len(time), step), edges.clip(0, len(time) - 1)]))
    part = _part_of(progress, (0.0, GLANCED))
    least = _over(solids, checked, motion, rows[::GLANCE], np.inf, part).least
    found = _over(solids, checked, motion, rows, least, _part_of(progress, (GLANCED, SEEN)))
    whole = Nearest(found.gaps, rows[found.rows], _in_rows(found.episodes, rows), step)
    last = len(rows) - 1
    ahead = [np.arange(rows[k], rows[min(k + 1, last)] + 1) for k in found.near.tolist()]
    if not ahead:
        return whole
    dense = np.unique(np.concatenate(ahead))
    more = _over(solids, checked, motion, dense, found.least, _part_of(progress, (SEEN, 1.0)))
    better = more.gaps < whole.gaps
    return Nearest(
        np.where(better, more.gaps, whole.gaps),
        np.where(better, dense[more.rows], whole.rows),
        np.concatenate([whole.episodes, _in_rows(more.episodes, dense)]),
        step,
    )


def frames_at(solids: Collisions, checked: TrackPairs, Q: Mapping[str, Array]) -> Array:
    """Return R_W by rows and p_W [m] of the carriers at joint coordinates, shape (c, k, 12)."""
    poses = body_poses(solids.tree, Q, checked.carriers)
    count = len(next(iter(Q.values())))
    frames = np.empty((len(checked.carriers), count, 12))
    for k, name in enumerate(checked.carriers):
        frames[k, :, :9] = poses[name][:, :3, :3].reshape(-1, 9)
        frames[k, :, 9:] = poses[name][:, :3, 3]
    return frames


def _part_of(progress: Callable[[float], None], share: Span) -> Callable[[float], None]:
    """Return a progress of a part of the whole."""
    return lambda done: progress(share[0] + done * (share[1] - share[0]))


def _over(
    solids: Collisions,
    checked: TrackPairs,
    motion: Motion,
    rows: Rows,
    least: float,
    progress: Callable[[float], None],
) -> Approach:
    """Return how near pairs come at some rows of a recording."""
    frames = frames_at(solids, checked, {name: q[rows] for name, q in motion.Q.items()})
    seen = [_as_seen(frames, *pair)[np.newaxis] for pair in checked.seen]
    carriers = Carriers(frames, _travel(np.concatenate([frames, *seen]), _wiggle(motion, rows)))
    pairs = checked.pairs.copy()
    pairs[:, 2:4] = np.searchsorted(motion.time[rows], pairs[:, 2:4])
    return closest(solids.bodies, checked.items, pairs, carriers, least, progress)


def _in_rows(episodes: Rows, rows: Rows) -> Rows:
    """Return episodes by rows of the recording."""
    return np.column_stack([episodes[:, 0], rows[episodes[:, 1:]]]).astype(np.intp)


def _wiggle(motion: Motion, rows: Rows) -> Array:
    """Return the travel of joints back and forth between rows [rad | m], shape (k - 1,)."""
    total = np.zeros(len(rows) - 1)
    for name, q in motion.Q.items():
        gone = np.add.reduceat(motion.steps[name], rows[:-1], axis=0) if len(rows) > 1 else q[:0]
        total += np.sum(gone - np.abs(np.diff(q[rows], axis=0)), axis=1)
    return np.maximum(total, 0.0)


def _as_seen(frames: Array, one: int, other: int) -> Array:
    """Return the frame of a carrier in that of another one by rows, shape (k, 12); -1 is the world."""
    R, p = frames[other, :, :9].reshape(-1, 3, 3), frames[other, :, 9:]
    if one >= 0:
        R_W = frames[one, :, :9].reshape(-1, 3, 3)
        R, p = np.einsum("kji,kjl->kil", R_W, R), np.einsum("kji,kj->ki", R_W, p - frames[one, :, 9:])
    return np.hstack([R.reshape(-1, 9), p])


def _travel(frames: Array, wiggle: Array) -> Array:
    """Return how far each carrier has moved and turned at each row at most, see `Carriers`."""
    travel = np.zeros((len(frames), 2, frames.shape[1]))
    reach = max(1.0, 2.0 * float(np.abs(frames[:, :, 9:]).max(initial=0.0)))
    moved = np.diff(frames, axis=1)
    travel[:, 0, 1:] = SLACK * np.linalg.norm(moved[:, :, 9:], axis=2) + reach * wiggle
    travel[:, 1, 1:] = SLACK * np.linalg.norm(moved[:, :, :9], axis=2) / np.sqrt(2.0) + wiggle
    return np.cumsum(travel, axis=2)


def _pairs(
    made: Sequence[Track],
    intents: Intents,
    never: frozenset[Pair],
    belongs: Mapping[str, str],
) -> Iterator[tuple[int, int, Span, float]]:
    """Yield two tracks, when they are checked, and 1 where their distance counts."""
    owner = [belongs.get(one.body if one.carrier == WORLD else one.carrier, "") for one in made]
    starts, ends = np.array([one.start for one in made]), np.array([one.end for one in made])
    for k, one in enumerate(made):
        if one.carrier == WORLD:
            continue
        for m in np.flatnonzero((starts < one.end) & (ends > one.start)).tolist():
            other = made[m]
            is_done = m <= k and other.carrier != WORLD
            if is_done or other.carrier == one.carrier or not never.isdisjoint(_both(one, other)):
                continue
            span = max(one.start, other.start), min(one.end, other.end)
            counts = 0.0 if owner[k] and owner[k] == owner[m] else 1.0
            first, second = (k, m) if other.carrier != WORLD else (m, k)
            near = intents.carried.get((one.body, other.body), ())
            for left in _without(span, intents.gripped.get((one.body, other.body), ())):
                apart = list(_without(left, near))
                for some in apart:
                    yield first, second, some, counts
                for some in _without(left, apart):
                    yield first, second, some, 0.0


def _both(one: Track, other: Track) -> tuple[Pair, Pair]:
    """Return the pair of their bodies in either order."""
    return (one.body, other.body), (other.body, one.body)


def _without(span: Span, gone: Sequence[Span]) -> Iterator[Span]:
    """Yield the remaining parts of a span."""
    start, end = span
    for first, last in sorted(gone):
        if first > start and min(first, end) > start:
            yield start, min(first, end)
        start = max(start, last)
    if end > start:
        yield start, end
