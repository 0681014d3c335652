"""Contacts of a run: which bodies penetrate each other or are too near, from when until when, and where."""

from bisect import bisect_left
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from ropsim.collision import COARSE, Collisions, Nearness, Pair
from ropsim.core import frozen_dataclass
from ropsim.flow import Contact, Event, Recording, body_title
from ropsim.model import WORLD, Body, BodyKind, Cell, meant_depths
from ropsim.simulation.ways.approaches import Nearest, TrackPairs
from ropsim.simulation.ways.carrier_motion import Motion
from ropsim.simulation.ways.deep_rows import deep_rows, nearness_at
from ropsim.simulation.ways.episodes import PairRows, pair_rows, rows_at
from ropsim.spatial import Array

TOUCHING = 1e-4
"""Bodies that are no deeper in each other touch [m]: shapes are drawn no finer."""
MOST = 400
"""Maximum number of depths computed for one contact; the search usually ends much earlier."""

PARALLEL = 1e-9
"""A line whose direction is no more across a face is parallel to it."""

_RANK = (
    BodyKind.TOOL,
    BodyKind.FINGER,
    BodyKind.CYLINDER,
    BodyKind.LINK,
    BodyKind.PART,
    BodyKind.DEVICE,
    BodyKind.BASE,
    BodyKind.OBJECT,
)
"""Order of two bodies in a finding."""


@frozen_dataclass
class Contacts:
    """Contacts of a run.

    Attributes:
        deep: penetrations, in order of time.
        near: bodies nearer than the clearance of the cell, in order of time.
        undecided: bodies that may be deeper in each other than they may be, as far as rows tell, in order of
            time; their distance is minus the depth that cannot be excluded.
        drawn: pairs that are in each other all the time: they are drawn so.
    """

    deep: tuple[Contact, ...]
    near: tuple[Contact, ...]
    undecided: tuple[Contact, ...]
    drawn: tuple[Pair, ...]


def contacts_of(
    solids: Collisions,
    checked: TrackPairs,
    seen: Nearest,
    motion: Motion,
    recording: Recording,
    cell: Cell,
    at_start: frozenset[Pair],
) -> Contacts:
    """Return the contacts of a run.

    Args:
        solids: the bodies of the cell.
        checked: the checked pairs.
        seen: how near they come.
        motion: of the joints.
        recording: of the run.
        cell: simulated cell.
        at_start: pairs that are in each other at the start; one that never parts is drawn so.
    """
    bodies = solids.tree.by_name()
    meant = meant_depths(cell)
    limits = {
        pair: _allowed(bodies, _bodies_of(checked, pair), cell, meant)
        for pair in {*seen.episodes[:, 0].astype(int).tolist()}
    }
    deep: dict[Pair, list[PairRows]] = defaultdict(list)
    near: dict[Pair, list[PairRows]] = defaultdict(list)
    for one in pair_rows(solids, checked, seen, motion, limits.__getitem__):
        key = _ordered(checked, bodies, one.pair)
        inside = (one.gaps <= 0.0) & (one.most > limits[one.pair])
        if inside.any():
            deep[key].append(one.at(inside))
        close = np.isfinite(one.gaps) & (one.gaps <= checked.pairs[one.pair, 5])
        if checked.pairs[one.pair, 5] > 0.0 and close.any() and frozenset(key) not in meant:
            near[key].append(one.at(close))
    places = _Places(solids, checked, motion, recording, cell, bodies)
    last = len(recording.time) - 1
    found: list[Contact] = []
    drawn: list[Pair] = []
    spans: dict[Pair, list[tuple[float, float]]] = defaultdict(list)
    for key, some in deep.items():
        for begin, end, parts in _joined(some):
            is_known = key in at_start or key[::-1] in at_start
            if is_known and begin == 0 and end == last:
                drawn.append(key)
                continue
            allowed = limits[parts[0].pair]
            for first, until, deeper in _joined(deep_rows(solids, checked, parts, allowed)):
                deepest = _deepest(solids, checked, deeper, allowed)
                if deepest is not None:
                    spans[key].append((first, until))
                    found.append(places.contact(key, first, until, *deepest))
    approached = [
        places.contact(key, begin, end, *_nearest(solids, checked, parts))
        for key, some in near.items()
        for begin, end, parts in _joined(some)
        if key not in drawn and not any(first <= end and begin <= until for first, until in spans[key])
    ]
    undecided = []
    for pair, begin, end, _, off in seen.episodes.tolist():
        key, limit = _ordered(checked, bodies, int(pair)), limits[int(pair)]
        is_told = any(first - 1.0 <= end and begin <= until + 1.0 for first, until in spans[key])
        if off > limit and key not in drawn and not is_told:
            inside = np.arange(np.floor(begin), np.ceil(end) + 1.0)
            one = rows_at(solids, checked, motion, int(pair), np.union1d(inside, [0.5 * (begin + end)]))
            row = int(np.argmin(one.gaps))
            there = nearness_at(solids, checked, one, row)
            if off - there.distance > limit:
                worst = replace(there, distance=there.distance - off)
                undecided.append(places.contact(key, begin, end, one, row, worst))
    return Contacts(_in_order(found), _in_order(approached), _in_order(undecided), tuple(drawn))


def _in_order(some: Iterable[Contact]) -> tuple[Contact, ...]:
    return tuple(sorted(some, key=_in_time))


def _in_time(one: Contact) -> tuple[float, str, str]:
    return one.begin, one.one, one.other


def _bodies_of(checked: TrackPairs, pair: int) -> Pair:
    """Return the names of the bodies of a pair of convex bodies."""
    one, other = (checked.tracks[checked.owner[int(item)]].body for item in checked.pairs[pair, :2])
    return one, other


def _ordered(checked: TrackPairs, bodies: Mapping[str, Body], pair: int) -> Pair:
    """Return the names of the bodies of a pair: moving ones first, tools before arms, arms before parts."""
    tracks = [checked.tracks[checked.owner[int(item)]] for item in checked.pairs[pair, :2]]
    tracks.sort(key=lambda one: (one.carrier == WORLD, _RANK.index(bodies[one.body].kind), one.body))
    return tracks[0].body, tracks[1].body


def _allowed(
    bodies: Mapping[str, Body], pair: Pair, cell: Cell, meant: Mapping[frozenset[str], float]
) -> float:
    """Return how deep two bodies may be in each other [m]; `meant` has the depths of meant contacts."""
    if frozenset(pair) in meant:
        return meant[frozenset(pair)]
    with_part = any(bodies[name].kind is BodyKind.PART for name in pair)
    return max(cell.supports.depth, TOUCHING) if with_part else TOUCHING


def _joined(some: Sequence[PairRows]) -> Iterator[tuple[float, float, list[PairRows]]]:
    """Yield first and last row of each contact of two bodies, with the convex bodies that are part of it."""
    if not some:
        return
    rows = np.unique(np.concatenate([one.rows for one in some]))
    breaks = np.flatnonzero(np.diff(rows) > 1.0)
    for first, last in zip([0, *(breaks + 1)], [*breaks, len(rows) - 1], strict=True):
        begin, end = float(rows[first]), float(rows[last])
        cut = [one.at((one.rows >= begin) & (one.rows <= end)) for one in some]
        yield begin, end, [one for one in cut if len(one.rows)]


def _deepest(
    solids: Collisions, checked: TrackPairs, parts: Sequence[PairRows], allowed: float
) -> tuple[PairRows, int, Nearness] | None:
    """Return where a contact is the deepest: its convex bodies, a row of them, how near they are there.

    Branch and bound: bounds of the depth determine the next row to compute, and a depth bounds the depths of
    nearby rows by the distance moved. The result is the greatest one to `COARSE`; None where no depth is more
    than allowed.
    """
    most = [one.most.copy() for one in parts]
    best: tuple[PairRows, int, Nearness] | None = None
    depth = allowed - COARSE
    for _ in range(MOST):
        number = max(range(len(parts)), key=lambda k: (float(most[k].max()), -k))
        row = int(np.argmax(most[number]))
        if most[number][row] <= depth + COARSE:
            break
        one = parts[number]
        near = nearness_at(solids, checked, one, row)
        if -near.distance > depth:
            depth, best = -near.distance, (one, row, near)
        np.minimum(most[number], np.abs(one.moved - one.moved[row]) - near.distance, out=most[number])
    return best if depth > allowed else None


def _nearest(
    solids: Collisions, checked: TrackPairs, parts: Sequence[PairRows]
) -> tuple[PairRows, int, Nearness]:
    """Return where two bodies that are too near are the nearest."""
    one = min(parts, key=lambda each: float(each.gaps.min()))
    row = int(np.argmin(one.gaps))
    return one, row, nearness_at(solids, checked, one, row)


def _place(solids: Collisions, checked: TrackPairs, one: PairRows, row: int, near: Nearness) -> Array:
    """Return a point in both bodies, or half way between two that are apart, in W [m], shape (3,).

    It is the middle of the common part of both bounding boxes on the line along which they are parted.
    """
    start, gap = near.point_one, near.point_other - near.point_one
    length = float(np.linalg.norm(gap))
    if near.distance >= 0.0 or length == 0.0:
        return np.asarray(start + 0.5 * gap)
    least, most = -np.inf, np.inf
    for item, pose in zip(checked.pairs[one.pair, :2], (one.first[row], one.second[row]), strict=True):
        middle, halves = solids.bodies.box(int(checked.items[int(item), 0]))
        R = pose[:9].reshape(3, 3)
        at, along = R.T @ (start - pose[9:]) - middle, R.T @ gap / length
        for k in range(3):
            if abs(along[k]) > PARALLEL:
                ends = sorted(((-halves[k] - at[k]) / along[k], (halves[k] - at[k]) / along[k]))
                least, most = max(least, ends[0]), min(most, ends[1])
    return np.asarray(start + 0.5 * (least + most) * gap / length)


class _Places:
    """Finds lines, passes and names of contacts."""

    def __init__(
        self,
        solids: Collisions,
        checked: TrackPairs,
        motion: Motion,
        recording: Recording,
        cell: Cell,
        bodies: Mapping[str, Body],
    ) -> None:
        self._solids = solids
        self._checked, self._recording, self._bodies, self._motion = checked, recording, bodies, motion
        self._supplies = {part.name: part.supply for part in cell.parts if part.supply}
        self._passes = _passes(recording.events)

    def contact(
        self, key: Pair, begin: float, end: float, one: PairRows, row: int, near: Nearness
    ) -> Contact:
        """Return the record of a contact."""
        time_at = self._motion.time_at
        start = time_at(begin)
        line, station = line_of(self._checked, one.pair, start, self._recording, self._bodies)
        return Contact(
            *key,
            start,
            time_at(end),
            near.distance,
            time_at(float(one.rows[row])),
            tuple(_place(self._solids, self._checked, one, row, near).tolist()),
            " – ".join(body_title(self._supplies.get(name, name)) for name in key),
            station,
            line,
            self._pass(station, line, start),
        )

    def _pass(self, station: str, line: int, time: float) -> int:
        """Return the loop pass of a line that was carried out at a time; 0 where unknown.

        As with the line, a row at which a pass begins still belongs to the pass before.
        """
        times, visits = self._passes.get((station, line), ((), ()))
        return visits[max(bisect_left(times, time) - 1, 0)] if visits else 0


def _passes(events: Iterable[Event]) -> Mapping[tuple[str, int], tuple[list[float], list[int]]]:
    """Return when each line of each station was carried out, and the loop pass, in order of time."""
    found: dict[tuple[str, int], tuple[list[float], list[int]]] = defaultdict(lambda: ([], []))
    for event in sorted(events, key=lambda one: one.time):
        if event.line and event.visit:
            times, visits = found[event.station, event.line]
            times.append(event.time)
            visits.append(event.visit)
    return found


def line_of(
    checked: TrackPairs, pair: int, time: float, recording: Recording, bodies: Mapping[str, Body]
) -> tuple[int, str]:
    """Return source line and station of the moving body of a pair, at a time."""
    facts = recording.facts
    for item in checked.pairs[pair, :2].astype(int):
        name = checked.tracks[checked.owner[int(item)]].carrier
        while name != WORLD:
            body = bodies[name]
            station = facts.station(body.mover.mechanism) if body.mover else None
            if station is not None:
                channel = facts.channel("line", station.name)
                if channel in recording.channels:
                    return int(recording.at(channel, time)), station.name
            name = body.parent
    return 0, ""
