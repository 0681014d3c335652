"""Chains of moves: lines with zones one after the other that may be flown as curves."""

from collections.abc import Sequence

import numpy as np

from ropsim.motion import SHORTEST_MOVE, Line, constant_derivatives
from ropsim.planning.blends.blend import LEAST_ZONE, commanded_zone
from ropsim.planning.moves.planned_move import PlannedMove
from ropsim.planning.records.motion_chain import MotionChain
from ropsim.spatial import Array

FEWEST = 3
"""Moves of a chain: two lines have one zone between them, which is no run."""

MoveRange = tuple[int, int]
"""Number of the first move, and that behind the last one."""


def chains_of(chain: MotionChain, moves: Sequence[PlannedMove]) -> list[MoveRange]:
    """Return which moves one after the other may be flown as curves.

    They are lines of one tool with the same limits, on which neither external axes move nor a sensor acts,
    all but the last have a zone, and none of these has to stop at its end. At least one of them is so short
    that the tool cannot speed up and slow down on it.

    Args:
        chain: the entities.
        moves: the moves.
    """
    found, first = list[MoveRange](), 0
    for number in range(1, len(moves) + 1):
        if number == len(moves) or not _go_on(chain, moves[number - 1], moves[number]):
            if number - first >= FEWEST and _has_short_moves(moves[first:number]):
                found.append((first, number))
            first = number
    return found


def longest_on_curve(moves: Sequence[PlannedMove]) -> float:
    """Return the length of moves of a chain [m] beyond which they stay lines: they have room to stop and go.

    Args:
        moves: with the same limits.
    """
    limits = moves[0].planned.limits.tool
    speed, acceleration, jerk = limits.speed, limits.acceleration, limits.jerk
    ramp = speed / acceleration + acceleration / jerk
    if speed * jerk < acceleration**2:
        ramp = 2.0 * (speed / jerk) ** 0.5
    return speed * ramp


def points_of(chain: MotionChain, moves: Sequence[PlannedMove]) -> tuple[Array, Array, Array]:
    """Return points, orientations and zones of a chain, as `motion.compressed` takes them.

    Args:
        chain: the entities.
        moves: of the chain.
    """
    lines = [move.tool for move in moves if isinstance(move.tool, Line)]
    poses = [lines[0].X_start, *(line.X_end for line in lines)]
    points = np.array([pose.position for pose in poses])
    rotations = np.array([pose.rotation() for pose in poses])
    return points, rotations, np.array([commanded_zone(chain, move.move) for move in moves[:-1]])


def _go_on(chain: MotionChain, before: PlannedMove, behind: PlannedMove) -> bool:
    """Return whether a chain goes on from one move to the next."""
    one, other = before.planned, behind.planned
    return (
        _is_line(before)
        and _is_line(behind)
        and (one.limits is other.limits or one.limits == other.limits)
        and one.X_MT == other.X_MT
        and one.counts is other.counts
        and not one.stops
        and commanded_zone(chain, before.move) >= LEAST_ZONE
    )


def _is_line(move: PlannedMove) -> bool:
    """Return whether a move is a plain line of the tool: long enough, and turning evenly."""
    planned, path = move.planned, move.planned.tool
    return (
        type(path) is Line
        and path.moves
        and path.length >= SHORTEST_MOVE
        and planned.joints is None
        and planned.coordination is None
        and move.move.tracking is None
        and constant_derivatives(path) is not None
    )


def _has_short_moves(moves: Sequence[PlannedMove]) -> bool:
    longest = longest_on_curve(moves)
    return any(move.tool is not None and move.tool.length <= longest for move in moves)
