"""Where two paths of one tool meet: both seen from one frame, with the external axes that go along."""

from ropsim.motion import Seen, ToolPath
from ropsim.planning.moves.planned_move import PlannedMove
from ropsim.planning.records.coordination import Coordination, coordination_along
from ropsim.spatial import Array, record


@record
class Meeting:
    """Two paths of one tool, one after the other.

    Attributes:
        before: the path that ends at the blend, in the frame of the meeting.
        behind: the path that begins there, in the same frame.
        axes: external axes along the two, both seen from that frame; None where all of them stand on both.
    """

    before: ToolPath
    behind: ToolPath
    axes: tuple[Coordination, Coordination] | None


def meeting_of(before: PlannedMove, behind: PlannedMove) -> Meeting | None:
    """Return where the paths of two moves meet; None if they use different tools, or have no common frame.

    None also where the orientation counts on one of them only. The frame is that of the path on which
    external axes move; where they stand, a path is as good in any frame. Two paths on which they move have to
    be given in frames of one link, or both in the base frame.

    Args:
        before: the move that ends there.
        behind: the move that begins there.
    """
    if before.tool is None or behind.tool is None or before.planned.X_MT != behind.planned.X_MT:
        return None
    if before.planned.counts is not behind.planned.counts:
        return None
    one, other = before.planned.coordination, behind.planned.coordination
    if one is None and other is None:
        return Meeting(before.tool, behind.tool, None)
    if one is None:
        assert other is not None
        still = _standing(before.tool, other, before.q_end)
        return Meeting(_from_base(before.tool, still, before.q_end), behind.tool, (still, other))
    if other is None:
        still = _standing(behind.tool, one, before.q_end)
        return Meeting(before.tool, _from_base(behind.tool, still, before.q_end), (one, still))
    if one.frame is None or other.frame is None:
        return Meeting(before.tool, behind.tool, (one, other)) if one.frame is other.frame else None
    if one.frame.link != other.frame.link:
        return None
    if one.frame.X_LK == other.frame.X_LK:
        return Meeting(before.tool, behind.tool, (one, other))
    seen = Seen(behind.tool, one.frame.X_LK.inverse() @ other.frame.X_LK)
    return Meeting(before.tool, seen, (one, other))


def _standing(path: ToolPath, like: Coordination, q: Array) -> Coordination:
    """Return the external axes at rest at q (n,) along a path, to meet a path on which they move."""
    return coordination_along(path, like.robot, q, q, like.frame, 1.0)


def _from_base(path: ToolPath, standing: Coordination, q: Array) -> ToolPath:
    """Return a path of the base frame expressed in the frame of the axes at rest at q."""
    return path if standing.frame is None else Seen(path, standing.frame.pose(q).inverse())
