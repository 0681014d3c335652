"""The verdict on the ways of a run: which bodies meet, when and how deep, and the least distance."""

from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from ropsim.collision import NO_MESHES, ROUGH, TOUCH, Collisions, MeshPoints, Nearness
from ropsim.core import Diagnostic, Span, frozen_dataclass
from ropsim.flow import BodyPair, Clearance, Recording, WayFacts
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
        deepest_at: when they were the deepest, as far as was looked [s].
        nearness: how near they were then.
        line: source line, from 1; 0 for none.
        station: whose line that is.
        counts: whether they may be the nearest of the run: they are not both of one robot.
    """

    time: float
    deepest_at: float
    nearness: Nearness
    line: int
    station: str
    counts: bool


@frozen_dataclass
class RunCollisions:
    """What met on the ways of a run.

    Attributes:
        findings: a warning S751 for each two bodies and line, in order of time.
        facts: how near bodies came at the least, and what was not looked at.
    """

    findings: tuple[Diagnostic, ...] = ()
    facts: WayFacts = WayFacts()


def with_collisions(recording: Recording, found: RunCollisions) -> Recording:
    """Return a recording that says what met on its ways, behind what was found in the run.

    Args:
        recording: of a run.
        found: on its ways.
    """
    checked = tuple(dict.fromkeys((*recording.facts.checked, "collisions")))
    facts = replace(recording.facts, checked=checked, ways=found.facts)
    return replace(recording, findings=(*recording.findings, *found.findings), facts=facts)


def run_collisions(
    recording: Recording,
    cell: Cell,
    meshes: MeshPoints = NO_MESHES,
    progress: Callable[[float], None] = lambda _: None,
) -> RunCollisions:
    """Return what met on the ways of a run, and how near bodies came at the least.

    Every body of the robots and devices, with what it holds, is looked at against everything else at all
    recorded rows at which the two may meet.

    Args:
        recording: of a run in the cell.
        cell: as it was simulated.
        meshes: points of its meshes; bodies with others are not looked at.
        progress: told which share has been looked at, from 0 to 1; an exception of it ends the look.
    """
    progress(0.0)
    solids = Collisions(cell, meshes)
    met = tuple(dict.fromkeys((*(one.pair for one in solids.meetings({})), *solids.at_rest)))
    made = tracks(solids.tree, recording.placements)
    bodies = solids.tree.by_name()
    intents = intended(cell, solids.tree, recording, made)
    looked = looked_at(solids, made, intents, frozenset(met))
    there = {one.body for one in made}
    facts = WayFacts(
        None, tuple(name for name in solids.shapeless if name in there), tuple(BodyPair(*one) for one in met)
    )
    if not len(looked.pairs) or len(recording.time) < LEAST_ROWS:
        return RunCollisions((), facts)
    seen = nearest(solids, looked, recording, progress)
    met_on_ways = sorted(
        _meetings(solids, looked, seen, recording), key=lambda one: (one.time, one.nearness.pair)
    )
    findings = [
        _finding(one, recording)
        for one in met_on_ways
        if -one.nearness.distance > _allowed(one, bodies, cell)
    ]
    clearance = _clearance(solids, looked, seen, recording, met_on_ways)
    return RunCollisions(tuple(findings), replace(facts, clearance=clearance))


def _allowed(one: Meeting, bodies: Mapping[str, Body], cell: Cell) -> float:
    """Return how deep two bodies may be in each other [m]."""
    touching = any(bodies[name].kind is BodyKind.PART for name in one.nearness.pair)
    return cell.supports.depth if touching else TOUCH


def _clearance(
    solids: Collisions, looked: Looked, seen: Nearest, recording: Recording, met: Iterable[Meeting]
) -> Clearance | None:
    """Return the least distance of the run; None where nothing counts."""
    if counted := [one for one in met if one.counts]:
        deepest = min(counted, key=lambda one: one.nearness.distance)
        near = deepest.nearness
        return Clearance(
            near.one, near.other, near.distance, deepest.deepest_at, deepest.station, deepest.line
        )
    gaps = np.where(looked.pairs[:, 4] > 0.0, seen.gaps, np.inf)
    pair = int(np.argmin(gaps))
    if not np.isfinite(gaps[pair]):
        return None
    row = int(seen.rows[pair])
    found = _at(solids, looked, recording, pair, row)
    time = float(recording.time[row])
    line, station = _line(looked, pair, time, recording, solids.tree.by_name())
    return Clearance(found.one, found.other, found.distance, time, station, line)


def _meetings(solids: Collisions, looked: Looked, seen: Nearest, recording: Recording) -> Iterator[Meeting]:
    """Yield the deepest meeting of each two bodies on each line."""
    bodies = solids.tree.by_name()
    groups: dict[tuple[str, str, str, int], list[tuple[int, int]]] = defaultdict(list)
    for pair, first, last in seen.episodes.tolist():
        one, other = (looked.tracks[looked.owner[int(item)]].body for item in looked.pairs[pair, :2])
        time = float(recording.time[first])
        line, station = _line(looked, pair, time, recording, bodies)
        groups[one, other, station, line] += [(pair, row) for row in range(first, last + 1)]
    for (_, _, station, line), rows in groups.items():
        chosen = {rows[k] for k in np.linspace(0, len(rows) - 1, min(LOOKS, len(rows))).round().astype(int)}
        near = {row: _at(solids, looked, recording, *row) for row in sorted(chosen)}
        pair, row = min(near, key=lambda place: near[place].distance)
        first, deepest = (float(recording.time[k]) for k in (min(k for _, k in rows), row))
        counts = bool(looked.pairs[pair, 4])
        yield Meeting(first, deepest, near[pair, row], line, station, counts)


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
    looked: Looked, pair: int, time: float, recording: Recording, bodies: Mapping[str, Body]
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
