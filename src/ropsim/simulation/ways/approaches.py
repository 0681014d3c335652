"""Checked pairs of tracks, and their distances."""

from collections.abc import Callable, Iterator, Mapping, Sequence

import numpy as np
import numpy.typing as npt

from ropsim.collision import (
    AS_AT_START,
    Collisions,
    LeftOut,
    Pair,
    carried,
    certified,
    left_out,
    owners,
)
from ropsim.model import WORLD, BodyKind
from ropsim.simulation.ways.carrier_motion import CarrierSet, Motion, carriers_of
from ropsim.simulation.ways.intents import Intents, Span
from ropsim.simulation.ways.tracks import Track
from ropsim.spatial import Array, record

Rows = npt.NDArray[np.intp]
"""Numbers of rows."""


@record
class TrackPairs:
    """Pairs of convex bodies on tracks.

    Attributes:
        tracks: all of them.
        items: convex bodies on carriers, see `certified`; behind those in the world those of one arm on
            carriers that are seen from another carrier.
        owner: number of the track of each item in the world.
        carriers: of the items.
        pairs: items in the world, times from and until [s], 1 where the least distance counts, the distance
            at which an episode begins [m], and the items by which they are followed; shape (p, 8).
    """

    tracks: tuple[Track, ...]
    items: Array
    owner: tuple[int, ...]
    carriers: CarrierSet
    pairs: Array


@record
class Nearest:
    """How near pairs come. Places are counted in rows; between two rows they are fractions.

    Attributes:
        gaps: least distance that was found of each pair [m], shape (p,); inf where another one was nearer.
        places: where that was, shape (p,).
        episodes: pair, begin and end of each span in which two may be nearer than they should, a place in it
            where they are, -1 where that cannot be told, and how far they may be off between rows [m]; shape
            (m, 5).
    """

    gaps: Array
    places: Array
    episodes: Array


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
    bodies = solids.tree.by_name()
    built = [name for name in solids.bodies.rows if bodies[name].kind is not BodyKind.PART]
    why = left_out(solids.tree, built, AS_AT_START)
    never = met | {*solids.at_rest} | {pair for pair in why if why[pair] is not LeftOut.FIXED}
    belongs = owners(solids.tree, bodies.keys())
    on = _OnCarriers(solids, seen)
    rows: list[Array] = []
    for one, other, span, counts in _pairs(seen, intents, never, belongs):
        a, b = on.own[one], on.own[other]
        block = np.empty((len(a) * len(b), 8))
        block[:, 0], block[:, 1] = np.repeat(a, len(b)), np.tile(b, len(a))
        block[:, 2:5], block[:, 5] = (*span, counts), clearance * counts
        block[:, 6:] = block[:, :2]
        if not counts:  # of one arm: it moves as a whole more than its links against each other
            first, second = on.seen_from_each_other(one, other)
            block[:, 6], block[:, 7] = np.repeat(first, len(b)), np.tile(second, len(a))
        rows.append(block)
    pairs = np.concatenate([np.empty((0, 8)), *rows])
    return TrackPairs(seen, on.table(), tuple(on.owner), on.carriers(), pairs)


class _OnCarriers:
    """Convex bodies of tracks as items on carriers."""

    def __init__(self, solids: Collisions, seen: Sequence[Track]) -> None:
        self._solids, self._seen = solids, seen
        self._names = tuple(dict.fromkeys(track.carrier for track in seen if track.carrier != WORLD))
        self._number = {WORLD: -1} | {name: k for k, name in enumerate(self._names)}
        self._items: list[Array] = []
        self._centres = self._middles()
        self._between: dict[tuple[int, int], int] = {}
        self._known: dict[tuple[int, int], Rows] = {}
        self.own: list[Rows] = []
        self.owner: list[int] = []
        for k, track in enumerate(seen):
            self.own.append(self._entered(k, self._number[track.carrier]))
            self.owner += [k] * len(self.own[k])

    def seen_from_each_other(self, one: int, other: int) -> tuple[Rows, Rows]:
        """Return the items of two tracks in the frame of the carrier of the first one."""
        both = self._number[self._seen[one].carrier], self._number[self._seen[other].carrier]
        row = len(self._names) + self._between.setdefault(both, len(self._between))
        return self._entered(one, -1), self._entered(other, row)

    def carriers(self) -> CarrierSet:
        """Return the carriers of the items; the middle of what hangs on each stands for it."""
        return CarrierSet(self._names, self._centres, tuple(self._between))

    def table(self) -> Array:
        """Return the rows of all items, shape (t, 22)."""
        return np.array(self._items).reshape(-1, 22)

    def _middles(self) -> Array:
        """Return the middle of what hangs on each carrier, in its frame [m], shape (c, 3)."""
        bodies = self._solids.bodies
        sums = np.zeros((len(self._names), 4))
        for one in self._seen:
            for k in bodies.rows[one.body] if one.carrier != WORLD else ():
                X_CV = one.X_CB @ bodies.convexes[k].X_BC.matrix()
                sums[self._number[one.carrier]] += X_CV @ np.append(bodies.box(k)[0], 1.0)
        return np.asarray(sums[:, :3] / np.maximum(sums[:, 3:], 1.0))

    def _entered(self, track: int, carrier: int) -> Rows:
        """Return the numbers of the convex bodies of a track on a carrier, or, for -1, in its frame."""
        if (track, carrier) not in self._known:
            one, X_CB = self._seen[track], self._seen[track].X_CB.copy()
            if carrier >= 0:
                X_CB[:3, 3] -= self._centres[self._number[one.carrier]]
            numbers, first = self._solids.bodies.rows[one.body], len(self._items)
            self._items += [carried(self._solids.bodies, k, carrier, X_CB) for k in numbers]
            self._known[track, carrier] = np.arange(first, first + len(numbers))
        return self._known[track, carrier]


def nearest(
    solids: Collisions, checked: TrackPairs, motion: Motion, progress: Callable[[float], None]
) -> Nearest:
    """Return how near pairs come, between the recorded rows as well.

    Args:
        solids: the bodies of the cell.
        checked: the checked pairs.
        motion: of the joints.
        progress: called with the share of the paths that has been checked.
    """
    pairs = checked.pairs[:, [6, 7, 2, 3, 4, 5]].copy()
    rows = np.arange(float(len(motion.time)))
    pairs[:, 2:4] = np.interp(pairs[:, 2:4], motion.time, rows)
    least, blocks = np.inf, motion.blocks()
    gaps, places = np.full(len(pairs), np.inf), np.zeros(len(pairs))
    episodes = [np.empty((0, 5))]
    for k, (first, last) in enumerate(blocks):
        here = pairs.copy()
        here[:, 2:4] = np.clip(here[:, 2:4] - first, 0.0, last - first)
        if len(rows) > 1:
            here[here[:, 2] >= here[:, 3], 3] = -1.0
        carriers = carriers_of(solids.tree, checked.carriers, motion.rows(first, last))
        found = certified(
            solids.bodies,
            checked.items,
            here,
            carriers,
            least,
            _share(progress, k, len(blocks)),
        )
        least, is_nearer = found.least, found.gaps < gaps
        gaps = np.where(is_nearer, found.gaps, gaps)
        places = np.where(is_nearer, found.places + first, places)
        moved = found.episodes + np.array([0.0, first, first, 0.0, 0.0])
        moved[moved[:, 3] >= 0.0, 3] += first
        episodes.append(moved)
    return Nearest(gaps, places, np.concatenate(episodes))


def _share(progress: Callable[[float], None], number: int, count: int) -> Callable[[float], None]:
    """Return the progress of one of some equal parts."""
    return lambda done: progress((number + done) / count)


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
