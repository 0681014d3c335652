"""The verdict on the ways of a run: which bodies meet, when and how deep, and the least distance."""

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from ropsim.collision import NO_MESHES, ROUGH, TOUCH, Collisions, MeshPoints, Nearness, Pair
from ropsim.core import Diagnostic, Span, frozen_dataclass
from ropsim.flow import Recording
from ropsim.model import WORLD, Body, BodyKind, Cell
from ropsim.simulation.diagnostics import COLLISION
from ropsim.simulation.ways.approaches import Looked, Nearest, frames_at, looked_at, nearest
from ropsim.simulation.ways.intents import intended
from ropsim.simulation.ways.tracks import tracks
from ropsim.spatial import record

LEAST_ROWS = 2
LOOKS = 5
"""So many rows of what meets on a line are asked for the depth."""


@record
class Meeting:
    """Two bodies that are in each other.

    Attributes:
        time: when they met first [s].
        nearness: the deepest that was found.
        line: source line, from 1; 0 for none.
        station: whose line that is.
    """

    time: float
    nearness: Nearness
    line: int
    station: str


@frozen_dataclass
class Clearance:
    """How near two bodies came at the least in a run.

    Attributes:
        one: name of a body.
        other: name of the other one.
        distance: between them [m]; negative where they were in each other.
        time: when [s].
        station: whose arm it was; empty for none.
        line: its source line then, from 1; 0 for none.
    """

    one: str
    other: str
    distance: float
    time: float
    station: str = ""
    line: int = 0


@frozen_dataclass
class RunCollisions:
    """What met on the ways of a run.

    Attributes:
        findings: a warning S751 for each two bodies and line, in order of time.
        clearance: how near bodies came at the least, those of one robot against each other left out; None
            where nothing moved against anything.
        unseen: names of bodies that were not looked at: no shape of them is known.
        met: pairs that were not looked at, since they are in each other at the start.
    """

    findings: tuple[Diagnostic, ...] = ()
    clearance: Clearance | None = None
    unseen: tuple[str, ...] = ()
    met: tuple[Pair, ...] = ()


def run_collisions(recording: Recording, cell: Cell, meshes: MeshPoints = NO_MESHES) -> RunCollisions:
    """Return what met on the ways of a run, and how near bodies came at the least.

    Every body of the robots and devices, with what it holds, is looked at against everything else at all
    recorded rows at which the two may meet.

    Args:
        recording: of a run in the cell.
        cell: as it was simulated.
        meshes: points of its meshes; bodies with others are not looked at.
    """
    solids = Collisions(cell, meshes)
    met = tuple(one.pair for one in solids.meetings({}))
    made = tracks(solids.tree, recording.placements)
    intents = intended(cell, solids.tree.by_name(), recording, made)
    looked = looked_at(solids, made, intents, frozenset(met))
    if not len(looked.pairs) or len(recording.time) < LEAST_ROWS:
        return RunCollisions((), None, solids.unseen, met)
    seen = nearest(solids, looked, recording)
    findings = tuple(_finding(one, recording) for one in _meetings(solids, looked, seen, recording, cell))
    return RunCollisions(findings, _clearance(solids, looked, seen, recording), solids.unseen, met)


def _clearance(solids: Collisions, looked: Looked, seen: Nearest, recording: Recording) -> Clearance | None:
    """Return the least distance of the run; None where nothing counts."""
    gaps = np.where(looked.pairs[:, 4] > 0.0, seen.gaps, np.inf)
    pair = int(np.argmin(gaps))
    if not np.isfinite(gaps[pair]):
        return None
    row = int(seen.rows[pair])
    found = _at(solids, looked, recording, pair, row)
    time = float(recording.time[row])
    line, station = _line(looked, pair, time, recording, solids.tree.by_name())
    return Clearance(found.one, found.other, found.distance, time, station, line)


def _meetings(
    solids: Collisions, looked: Looked, seen: Nearest, recording: Recording, cell: Cell
) -> Iterator[Meeting]:
    """Yield the deepest meeting of each two bodies on each line, in order of time."""
    bodies = solids.tree.by_name()
    groups: dict[tuple[str, str, str, int], list[tuple[int, int]]] = defaultdict(list)
    for pair, first, last in seen.episodes.tolist():
        one, other = (looked.tracks[looked.owner[int(item)]].body for item in looked.pairs[pair, :2])
        time = float(recording.time[first])
        line, station = _line(looked, pair, time, recording, bodies)
        groups[one, other, station, line] += [(pair, row) for row in range(first, last + 1)]
    found = []
    for (one, other, station, line), rows in groups.items():
        chosen = {rows[k] for k in np.linspace(0, len(rows) - 1, min(LOOKS, len(rows))).round().astype(int)}
        deepest = min(
            (_at(solids, looked, recording, *row) for row in sorted(chosen)), key=lambda near: near.distance
        )
        touching = any(bodies[name].kind is BodyKind.PART for name in (one, other))
        if -deepest.distance > (cell.supports.depth if touching else TOUCH):
            time = float(recording.time[min(row for _, row in rows)])
            found.append(Meeting(time, deepest, line, station))
    yield from sorted(found, key=lambda one: (one.time, one.nearness.pair))


def _at(solids: Collisions, looked: Looked, recording: Recording, pair: int, row: int) -> Nearness:
    """Return how near a pair is at a row of the recording."""
    channels, facts = recording.channels, recording.facts
    Q = {
        name: channels[facts.channel("q", name)].values[row].reshape(1, -1) for name in solids.tree.mechanisms
    }
    frames = frames_at(solids, looked, Q)[:, 0]
    poses = np.zeros((len(solids.bodies.convexes), 12))
    numbers = []
    for values in looked.items[looked.pairs[pair, :2].astype(int)]:
        number, carrier = int(values[0]), int(values[1])
        R, p = values[7:16].reshape(3, 3), values[16:19]
        if carrier >= 0:
            X = frames[carrier]
            R, p = X[:9].reshape(3, 3) @ R, X[:9].reshape(3, 3) @ p + X[9:]
        poses[number, :9], poses[number, 9:] = R.ravel(), p
        numbers.append(number)
    rows = np.array([numbers])
    found = solids.bodies.distances(poses, rows, np.zeros(1), (np.inf, np.inf))
    return solids.bodies.nearness(poses, numbers, found[0], ROUGH)


def _line(
    looked: Looked, pair: int, time: float, recording: Recording, bodies: dict[str, Body]
) -> tuple[int, str]:
    """Return source line and station of what moves in a pair, at a time."""
    facts = recording.facts
    for item in looked.pairs[pair, :2].astype(int):
        name = looked.tracks[looked.owner[int(item)]].carrier
        while name != WORLD:
            body = bodies[name]
            station = facts.station(body.mover.mechanism) if body.mover else None
            if station is not None:
                channel = facts.channel("line", station.name)
                if channel in recording.channels:
                    return int(recording.at(channel, time)), station.name
            name = body.parent
    return 0, ""


def _finding(one: Meeting, recording: Recording) -> Diagnostic:
    station = recording.facts.station(one.station)
    programs: Sequence[str] = [each.source for each in recording.facts.stations]
    source = station.source if station else ""
    shared = (f"at station `{one.station}`",) if programs.count(source) > 1 else ()
    first, second = one.nearness.pair
    return replace(
        COLLISION.at(
            Span.whole_line(source, one.line) if source and one.line else None,
            f"`{first}` is {-1e3 * one.nearness.distance:.1f} mm deep in `{second}`",
            label=f"from t = {one.time:.2f} s on",
            hint="lead the arm round it by a point on the way, or move what is in the way",
            data={
                "one": first,
                "other": second,
                "depth": -one.nearness.distance,
                "time_s": one.time,
                "station": one.station,
            },
        ),
        notes=shared,
    )
