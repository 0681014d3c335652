"""Bodies that touch on purpose: a hand and the part that it grips, a part and its support."""

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence

import numpy as np

from ropsim.collision import Pair, owners
from ropsim.core import frozen_dataclass
from ropsim.flow import MoveEvent, Recording
from ropsim.model import WORLD, BodyKind, BodyTree, Cell, tool_body
from ropsim.simulation.ways.tracks import Track

Span = tuple[float, float]
"""From and until when [s]."""


@frozen_dataclass
class Intents:
    """When bodies touch on purpose, by pair in either order.

    Attributes:
        gripped: when one grips the other: the pair is not checked then.
        carried: when one is taken from the other or put on it: the approach is intended, so only penetrations
            count then.
    """

    gripped: Mapping[Pair, Sequence[Span]]
    carried: Mapping[Pair, Sequence[Span]]


def intended(cell: Cell, tree: BodyTree, recording: Recording, made: Sequence[Track]) -> Intents:
    """Return when bodies touch on purpose.

    That is from the beginning of the last move before a part is gripped or released until the end of the
    first move after it. The part may be in the hand and its fingers then, and in fingers as long as their
    tool holds it; it comes near to the body that it is taken from or put on. Parts that come out of a supply
    while another one is lifted out of its place, or follow it on a belt, may be in that one and the hand
    until then.

    Args:
        cell: simulated cell.
        tree: of its bodies.
        recording: of the run.
        made: tracks of all bodies.
    """
    bodies = tree.by_name()
    belongs = owners(tree, bodies.keys())
    hands = {
        tool_body(name, station.name): station.name
        for station in cell.stations.values()
        for name in station.tools
    }
    fingers: dict[str, list[str]] = defaultdict(list)
    for body in bodies.values():
        if body.kind is BodyKind.FINGER:
            fingers[body.parent].append(body.name)
    moves: dict[str, list[MoveEvent]] = defaultdict(list)
    for event in recording.events_of(MoveEvent):
        moves[event.station].append(event)
    found: dict[Pair, list[Span]] = defaultdict(list)
    carried: dict[Pair, list[Span]] = defaultdict(list)
    comes = _first(made)
    standing = [name for name, body in bodies.items() if body.kind in (BodyKind.OBJECT, BodyKind.DEVICE)]
    for before, held, after in _journeys(made):
        if held.hand not in hands or bodies[held.body].kind is not BodyKind.PART:
            continue
        own = moves[hands[held.hand]]
        taken = _around(own, held.start)
        left = _around(own, held.end) if np.isfinite(held.end) else (held.end, held.end)
        for one in (held.hand, *fingers[held.hand]):
            found[one, held.body] += [(taken[0], held.start), (held.start, held.end), (held.end, left[1])]
        for new in _neighbours(held, before, taken[1], made, comes):
            for one in (held.hand, *fingers[held.hand], held.body):
                found[one, new].append((held.start, taken[1]))
        if before is not None:
            for one in _device_of(before.hand, belongs):  # a part on a belt also lies on its frame
                carried[one, held.body].append(taken)
        if after is not None and after.hand in hands:
            found[after.hand, held.body].append(left)
        if after is not None:
            carried[after.hand, held.body].append(left)
        else:  # it leaves by a sink: the hollow of a chute counts as solid
            for one in standing:
                found[one, held.body].append(left)
    return Intents(_both_ways(found), _both_ways(carried))


def _both_ways(found: Mapping[Pair, Sequence[Span]]) -> Mapping[Pair, Sequence[Span]]:
    """Return spans by pair in either order."""
    return {**found, **{(other, one): spans for (one, other), spans in found.items()}}


def _device_of(hand: str, belongs: Mapping[str, str]) -> list[str]:
    """Return the bodies of the mechanism that something hangs on; the one itself where it is of none."""
    owner = belongs.get(hand, "")
    return [name for name, one in belongs.items() if one == owner] if owner else [hand]


def _neighbours(
    held: Track, before: Track | None, until: float, made: Iterable[Track], first: Iterable[Track]
) -> Iterator[str]:
    """Yield the parts that come while one is lifted, and parts on the same moving body."""
    yield from (one.body for one in first if 0.0 < held.start <= one.start < until)
    if before is not None and before.carrier != WORLD:
        for one in made:
            if one.carrier == before.carrier and one.start < until and one.end > held.start:
                yield one.body


def _first(made: Iterable[Track]) -> list[Track]:
    """Return the first track of each body."""
    first: dict[str, Track] = {}
    for one in made:
        first.setdefault(one.body, one)
    return list(first.values())


def _journeys(made: Iterable[Track]) -> list[tuple[Track | None, Track, Track | None]]:
    """Return each track with the one before it and the one after it, of the same body, without a gap."""
    every = list(made)
    around = zip([None, *every[:-1]], every, [*every[1:], None], strict=True)
    return [
        (
            before if before is not None and (before.body, before.end) == (one.body, one.start) else None,
            one,
            after if after is not None and (after.body, after.start) == (one.body, one.end) else None,
        )
        for before, one, after in around
    ]


def _around(moves: Sequence[MoveEvent], time: float) -> Span:
    """Return when the last move before a time begins, and the first one after it ends [s]."""
    begin = max((one.time for one in moves if one.time < time), default=0.0)
    end = min((one.end for one in moves if one.time >= time), default=float("inf"))
    return begin, end
