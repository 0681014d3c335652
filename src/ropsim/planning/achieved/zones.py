"""Zones of a motion sequence: findings on them, and how much of each is achieved."""

import math
from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from ropsim.core import Diagnostic
from ropsim.flow import MoveInstruction
from ropsim.kinematics import tool_places
from ropsim.model import RobotModel
from ropsim.motion import ZONE_CLIPPED, ZONE_STOPS
from ropsim.planning.blends.blend import Blend, JointSpaceBlend, Stop
from ropsim.planning.moves.planned_move import PlannedMove
from ropsim.planning.records.wording import passes
from ropsim.planning.trajectory.trajectory import Trajectory

NEXT_IS_SKIPPED = "the next move is left out"
"""Why the arm stops before a move that cannot be planned."""

_SAME = 1e-6
"""Share by which the zone that is flown may be smaller than the commanded one without a word."""


def clipped(move: MoveInstruction, blend: Blend) -> tuple[Diagnostic, ...]:
    """Return M562 where less than the commanded zone is flown.

    Args:
        move: that commands the zone.
        blend: that is flown; where motions overlap, its zone is the most that may be flown.
    """
    wanted, zone = move.modal.zone, blend.zone
    if zone >= wanted * (1.0 - _SAME):
        return ()
    shown = f"{zone * 1e3:.3g} mm, half of the shorter one of the two moves that meet here"
    if isinstance(blend, JointSpaceBlend):
        shorter = f" and {blend.shorter * 1e3:.3g} mm" if blend.shorter < zone * (1.0 - _SAME) else ""
        shown = f"at most {zone * 1e3:.3g} mm{shorter}, half of each of the two moves that meet here"
    finding = ZONE_CLIPPED.at(
        move.origin.span,
        f"the zone of {wanted * 1e3:g} mm is reduced to {shown}",
        label=passes(move.origin),
        hint=_clipped_hint(move, zone),
        data={"zone_m": wanted, "flown_m": zone, **move.origin.data},
    )
    return (finding,)


def _clipped_hint(move: MoveInstruction, zone: float) -> str:
    """Return what helps: one zone is in force for all points of a list, which may need more elsewhere."""
    if move.origin.point:
        return "put the points further apart, or leave some of them out; at the other points the zone stays"
    shown = math.floor(zone * 1e6) * 1e-3  # a zone of this size is flown whole
    return f"give `blend {shown:.6g} mm`, or put the points further apart"


def stopped(move: MoveInstruction, why: Stop) -> tuple[Diagnostic, ...]:
    """Return M560 for a blend at which the arm stops though a zone is in force."""
    hint = "give a larger zone" if why in (Stop.QUICKER, Stop.SLOWED) else "shift the point"
    if why in (Stop.NO_WAY_TO, Stop.NO_WAY_ON):
        hint = "leave the point out"
    or_fine = ", or give the move `fine`" if move.modal.zone > 0.0 and not move.origin.point else ""
    return _stops(move, why.value, f"{hint}{or_fine}")


def stopped_by(move: MoveInstruction, what: str) -> tuple[Diagnostic, ...]:
    """Return M560 for the last move of a sequence where its zone becomes a stop.

    Args:
        move: the last one before the arm has to stand.
        what: the reason, such as `the gripper closes next`.
    """
    hint = "give the move `fine`, or do that elsewhere"
    if what == NEXT_IS_SKIPPED:
        hint = "mend the next move: its error says what is wrong"
    elif move.origin.point:
        hint = "nothing, if the stop is meant; else do that on the way (`at 5 mm before end do …`)"
    return _stops(move, what, hint)


def _stops(move: MoveInstruction, why: str, hint: str) -> tuple[Diagnostic, ...]:
    zone = move.modal.zone
    if not (zone > 0.0 or move.modal.passes):
        return ()
    what = f"its zone of {zone * 1e3:g} mm is not flown" if zone > 0.0 else "the via point is not passed by"
    finding = ZONE_STOPS.at(
        move.origin.span,
        f"the arm stops here, {what}: {why}",
        label=passes(move.origin),
        hint=hint,
        data={"zone_m": zone, "cause": why, **move.origin.data},
    )
    return (finding,)


def achieved_zones(
    robot: RobotModel, moves: Sequence[PlannedMove], blends: Sequence[Blend | None], motion: Trajectory
) -> list[float]:
    """Return the distance from the target of each move at which the path leaves it [m]; 0 where it stops.

    A rounded blend is left at its zone. Where motions overlap, both are added only as long as the shorter
    of their two parts within the zone lasts, so the other move is left nearer to the blend: it is where
    the TCP is when the next motion begins that counts.

    Args:
        robot: the arm with its external axes.
        moves: the moves.
        blends: between each two of them; None where the arm stops.
        motion: their timing.
    """
    zones = [one.zone if one else 0.0 for one in blends] + [0.0]
    sections = [
        (section, behind.start)
        for section, behind in pairwise(motion.timing.sections)
        if section.part.over is not None
    ]
    if not sections:
        return zones
    numbers = [section.part.path_segments[-1].last_move for section, _ in sections]
    q = motion.at(np.array([start for _, start in sections])).q
    tools = [moves[number].planned.X_MT for number in numbers]
    q = np.concatenate((q.reshape(-1), *(moves[number].q_end for number in numbers)))
    leaves, targets = tool_places(robot, q, tools + tools).reshape(2, -1, 3)
    for number, (x, y, z) in zip(numbers, (leaves - targets).tolist(), strict=True):
        zones[number] = math.sqrt(x * x + y * y + z * z)
    return zones
