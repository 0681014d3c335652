"""Path segments of a sequence: parts of the paths of moves, blends between them, and curves of many moves."""

from collections.abc import Sequence

from ropsim.core import maker
from ropsim.motion import (
    JointPath,
    JointSection,
    PathLimits,
    ToolPath,
    ToolSection,
    own_law_of,
)
from ropsim.planning.blends.blend import Blend, CartesianBlend, JointSpaceBlend, PassedPoint
from ropsim.planning.moves.move_curve import MoveCurve
from ropsim.planning.moves.planned_move import PlannedMove
from ropsim.planning.path_limits.path_limits import (
    Bend,
    along_with,
    fastest_bounds,
    joint_path_limits,
    lesser_limits,
    tool_path_limit_choices,
)
from ropsim.planning.records.coordination import Coordination
from ropsim.spatial import Pose, record

_NOTHING = 1e-9
"""Share of a path below which nothing is left of it between two blends."""
_NO_LIMITS = PathLimits.of(())


@record
class PathSegment:
    """A part of the timing.

    Attributes:
        move_number: number of the move on which it begins; a blend belongs to the move before it.
        joints: its path in joint space.
        tool: its path of the tool, in the base frame or that of the coordination; None without one.
        X_MT: the tool.
        path_limits: bounds along it, part by part; none where it has a time law of its own.
        blend: that it leads round; None for a part of the path of a move.
        coordination: external axes that go along with the path of the tool; None where they stand.
        begin: path parameter at which it begins on the path of its move, in the unit of that; 0 for a blend.
        gentler: other bounds along it, with less speed and more acceleration in its bends.
        ends: path parameters before its end at which moves end, from `move_number` on.
        bend: its path of the tool where that is bent so that its speed matters; None where it is not.
    """

    move_number: int
    joints: JointPath
    tool: ToolPath | None
    X_MT: Pose
    path_limits: PathLimits
    blend: CartesianBlend | None = None
    coordination: Coordination | None = None
    begin: float = 0.0
    gentler: tuple[PathLimits, ...] = ()
    ends: tuple[float, ...] = ()
    bend: Bend | None = None

    @property
    def last_move(self) -> int:
        """Return the number of the move on which it ends."""
        return self.move_number + len(self.ends)

    @property
    def is_even(self) -> bool:
        """Return whether the same bounds hold all along it, and no others can be chosen."""
        return len(self.path_limits.rows) == 1 and not self.gentler


_path_segment, _section = maker(PathSegment), maker(JointSection)

JoinedSegments = tuple[list[PathSegment], JointSpaceBlend | None]
"""Segments traversed together, and their blend into the next ones; None for a stop."""


def segments_of(moves: Sequence[PlannedMove], blends: Sequence[Blend | None]) -> list[JoinedSegments]:
    """Return the path segments of a sequence in order.

    Args:
        moves: the moves.
        blends: between each two of them; None where the arm stops there, or where one has no length.
    """
    sections: list[JoinedSegments] = []
    path_segments: list[PathSegment] = []
    enters = 0.0
    for number, (move, blend) in enumerate(zip(moves, (*blends, None), strict=True)):
        if move.joints is None or (move.on_curve and not move.on_curve.is_last):
            continue
        curve = move.on_curve.curve if move.on_curve else None
        length = curve.length if curve else move.joints.length
        leaves = length if blend is None or isinstance(blend, JointSpaceBlend) else blend.leave
        if leaves - enters > _NOTHING * length:
            path_segments.append(
                _along_curve(number, move, curve, enters, leaves)
                if curve
                else _straight(number, move, enters, leaves)
            )
        enters = 0.0 if blend is None or isinstance(blend, JointSpaceBlend) else blend.enter
        if isinstance(blend, CartesianBlend):
            path_segments.append(_round(number, move, moves[number + 1], blend))
        elif not isinstance(blend, PassedPoint):
            sections.append((path_segments, blend))
            path_segments = []
    return sections


def _straight(number: int, move: PlannedMove, first: float, last: float) -> PathSegment:
    """Return a part of the path of a move with the bounds along it."""
    planned, joints = move.planned, move.joints
    assert joints is not None
    tool, coordination, whole = planned.tool, planned.coordination, first == 0.0 and last == joints.length
    if not whole:
        joints = _section(joints, first, last)
    if tool is None:
        path_limits = _NO_LIMITS if own_law_of(joints) else joint_path_limits(joints, planned.limits.joints)
        return _path_segment(number, joints, None, planned.X_MT, path_limits, None, None, first, (), (), None)
    if not whole:
        tool = ToolSection(tool, first, last)
        coordination = coordination.part(first, last) if coordination else None
    choices, bend = tool_path_limit_choices(tool, planned.limits.tool)
    path_limits, *gentler = (along_with(one, coordination) for one in choices)
    return _path_segment(
        number,
        joints,
        tool,
        planned.X_MT,
        path_limits,
        None,
        coordination,
        first,
        tuple(gentler),
        (),
        bend,
    )


def _round(number: int, before: PlannedMove, behind: PlannedMove, blend: CartesianBlend) -> PathSegment:
    X_MT = before.planned.X_MT
    least = lesser_limits(before.planned.limits.tool, behind.planned.limits.tool)
    (path_limits,), bend = fastest_bounds(blend.tool, least)
    path_limits = along_with(path_limits, blend.coordination)
    return _path_segment(
        number,
        blend.joints,
        blend.tool,
        X_MT,
        path_limits,
        blend,
        blend.coordination,
        0.0,
        (),
        (0.5 * blend.joints.length,),
        bend,
    )


def _along_curve(number: int, move: PlannedMove, curve: MoveCurve, first: float, last: float) -> PathSegment:
    """Return a part of a curve of moves with the bounds along it.

    Args:
        number: of its last move.
        move: that.
        curve: the curve.
        first: path parameter at which the part begins [m].
        last: path parameter at which it ends [m].
    """
    joints, tool = JointSection(curve.joints, first, last), ToolSection(curve.tool, first, last)
    (path_limits, *gentler), bend = tool_path_limit_choices(tool, move.planned.limits.tool)
    parameters = curve.parameters if curve.before else curve.parameters[1:]
    ends = tuple((parameters[parameters < curve.length] - first).tolist())
    begins_on = number + 1 - len(parameters)
    return _path_segment(
        begins_on,
        joints,
        tool,
        move.planned.X_MT,
        path_limits,
        None,
        None,
        first,
        tuple(gentler),
        ends,
        bend,
    )
