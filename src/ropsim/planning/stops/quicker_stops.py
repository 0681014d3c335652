"""Sharp blends at which the arm is quicker when it stops: zones are left there."""

import math
from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise

from ropsim.planning.blends.blend import Blend, CartesianBlend, JointSpaceBlend
from ropsim.spatial import record

_FURTHEST = 4
"""Maximum number of examined blends that a motion between two stops may pass, in addition to the present
motion."""
_WORTH = 1e-6
"""Share of the time from stop to stop that other stops have to save: rounding saves less."""

_RIGHT_ANGLE = 0.5 * math.pi + 1e-6
"""With some rounding [rad]."""

Stretch = tuple[int, int]
"""Number of the first move, and that behind the last one."""


@record
class Times:
    """Times of moves from rest to rest, with all blends between them rounded.

    Attributes:
        least: of some moves, no more than the time they take [s].
        exact: the time they take [s].
    """

    least: Callable[[Stretch], float]
    exact: Callable[[Stretch], float]


def quicker_stops(
    blends: Sequence[Blend | None], ends: Sequence[float], alone: Sequence[float], times: Times
) -> tuple[int, ...]:
    """Return the numbers of the rounded blends at which to stop, so that the motion takes the least time.

    A move that flows takes no longer from the middle of its first blend to that of its last one than it
    would from rest to rest; while all do, the whole takes less time than with a stop at each point. Where one
    takes longer, the adjacent blends are examined, and if the whole between two stops takes longer, all its
    blends. Stops at some of them are the path with the least sum of times: a shortest path, of which an edge
    is planned only where nothing shorter is known to be left.

    Args:
        blends: between each two moves; None where the arm stops already.
        ends: times at which the moves end in the present motion [s].
        alone: lower bounds of the times of the moves from rest to rest [s].
        times: of the moves between two stops.

    References:
        Dellin and Srinivasa 2016, A unifying formalism for shortest path problems with expensive edge
        evaluations via lazy best-first search over paths with edge selectors, ICAPS.
    """
    found: list[int] = []
    for first, last in _runs(blends):
        begin = ends[first - 1] if first else 0.0
        taken = [end - start for start, end in pairwise((begin, *ends[first:last]))]
        slow = [one > other for one, other in zip(taken, alone[first:last], strict=True)]
        if not any(slow):
            continue
        whole = sum(taken) > sum(alone[first:last])
        indices = [
            number + 1
            for number in range(last - first - 1)
            if (whole or slow[number] or slow[number + 1]) and can_stop(blends[first + number])
        ]
        stops = _shortest([first, *(first + index for index in indices), last], sum(taken), times)
        found += (stop - 1 for stop in stops)
    return tuple(found)


def can_stop(blend: Blend | None) -> bool:
    """Return whether a blend may become a stop where that is quicker.

    No controller stops at a corner of up to a right angle that has a zone, however small: it passes slowly.
    Amid a curve there is no way through the point itself.
    """
    if isinstance(blend, CartesianBlend):
        return blend.turn > _RIGHT_ANGLE
    return isinstance(blend, JointSpaceBlend)


def _runs(blends: Sequence[Blend | None]) -> Iterator[Stretch]:
    """Yield the moves between each two stops that pass a blend."""
    stops = [0, *(number + 1 for number, blend in enumerate(blends) if blend is None), len(blends) + 1]
    yield from ((first, last) for first, last in pairwise(stops) if last - first > 1)


def _shortest(nodes: Sequence[int], present: float, times: Times) -> list[int]:
    """Return where to stop between the first node and the last one, so that it takes the least time.

    Args:
        nodes: numbers of moves before which the arm may stop, those at the ends included.
        present: time without a stop [s].
        times: of the moves between two nodes.
    """
    whole = (nodes[0], nodes[-1])
    known = {whole: present * (1.0 - _WORTH)}
    exact = {whole}
    while True:
        path = _least_path(nodes, known, times)
        unknown = [edge for edge in path if edge not in exact]
        if not unknown:
            return [last for _, last in path[:-1]]
        known |= {edge: times.exact(edge) for edge in unknown}
        exact.update(unknown)


def _least_path(nodes: Sequence[int], known: dict[Stretch, float], times: Times) -> list[Stretch]:
    """Return the edges of the shortest path by known times; lower bounds count for the others."""
    costs, before = [0.0], [0]
    for index, node in enumerate(nodes[1:], 1):
        begins = set(range(max(index - _FURTHEST, 0), index)) | ({0} if index == len(nodes) - 1 else set())
        for begin in begins:
            edge = (nodes[begin], node)
            if edge not in known:
                known[edge] = times.least(edge)
        cost, best = min((costs[begin] + known[nodes[begin], node], begin) for begin in sorted(begins))
        costs.append(cost)
        before.append(best)
    path, index = [], len(nodes) - 1
    while index:
        path.append((nodes[before[index]], nodes[index]))
        index = before[index]
    return path[::-1]


def without(blends: Sequence[Blend | None], stops: Sequence[int]) -> list[Blend | None]:
    """Return blends with stops at some of them.

    Args:
        blends: between each two moves.
        stops: numbers of those at which the arm stops.
    """
    return [None if number in stops else blend for number, blend in enumerate(blends)]
