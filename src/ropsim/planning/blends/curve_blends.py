"""Blends of moves that are flown as one curve: passed smoothly within it, and rounded at its ends."""

from dataclasses import replace

from ropsim.motion import JointSection, ToolSection
from ropsim.planning.blends.blend import HALF, Blend, PassedPoint, Stop, blend_between, commanded_zone
from ropsim.planning.moves.planned_move import PlannedMove
from ropsim.planning.records.motion_chain import MotionChain


def blend_at(chain: MotionChain, before: PlannedMove, behind: PlannedMove) -> Blend | Stop:
    """Return the blend between two moves, on curves or not, or why the arm must stop there.

    Where a curve ends at a point, the point has the blend that it would have between two moves: half of the
    last move on the curve at most.

    Args:
        chain: the entities.
        before: the move that ends at the blend, with a zone.
        behind: the move that begins there.
    """
    one, other = before.on_curve, behind.on_curve
    if before.joints is not None and (one or other):
        length = before.joints.length
        zone = min(commanded_zone(chain, before.move), HALF * length)
        if one and other and one.curve is other.curve:
            return PassedPoint(zone, one.end, other.begin)
        if one and one.curve.behind:
            return PassedPoint(zone, one.curve.length, one.curve.behind)
        if other and other.curve.before:
            return PassedPoint(zone, length - other.curve.before, 0.0)
    found = blend_between(chain, _alone(before), _alone(behind))
    return found if one is None or isinstance(found, Stop) else replace(found, leave=found.leave + one.begin)


def _alone(move: PlannedMove) -> PlannedMove:
    """Return a move on a curve with its part of the curve as its path."""
    if move.on_curve is None:
        return move
    curve, begin, end = move.on_curve.curve, move.on_curve.begin, move.on_curve.end
    planned = replace(move.planned, tool=ToolSection(curve.tool, begin, end))
    return replace(move, planned=planned, joints=JointSection(curve.joints, begin, end), on_curve=None)
