"""Corners of a stretch: where a zone lets the path leave one move and enter the next, and the way between."""

from enum import Enum

import numpy as np

from ropsim.controller.entities import Refusal
from ropsim.controller.leg import Leg, trace
from ropsim.controller.motion_chain import MotionChain
from ropsim.kinematics import forward_batch
from ropsim.motion import CornerFault, JointPath, ToolPath, corner, enter, joint_blend, leave
from ropsim.spatial import Array, record

_HALF = 0.5
"""Share of a move that a zone may take."""


class Stop(Enum):
    """Why the arm stops at a corner though a zone is in force."""

    TURNS_BACK = "the path turns back on itself there"
    STANDS = "the tool only turns on one side of it"
    NO_WAY = "there is no way between it and its neighbour"
    UNREACHABLE = "the arm cannot follow the rounded corner"


@record
class Rounding:
    """A rounded corner.

    Attributes:
        zone: distance of the TCP from the corner at which the path leaves and enters [m].
        leave: place on the path before, in its unit.
        enter: place on the path behind, in its unit.
        joints: the way between, in joint space.
        tool: the way of the tool; None where the corner is rounded in joint space.
        before: ds/du of the way between by that of the path before, at their joint.
        behind: ds/du of the path behind by that of the way between, at their joint.
    """

    zone: float
    leave: float
    enter: float
    joints: JointPath
    tool: ToolPath | None
    before: float = 1.0
    behind: float = 1.0


def rounding(chain: MotionChain, before: Leg, behind: Leg, zone: float) -> Rounding | Stop:
    """Return the rounded corner between two moves, or why the arm must stop there.

    Two paths of one tool are joined by a path of the tool, all others by one in joint space.

    Args:
        chain: the entities.
        before: the move that ends at the corner.
        behind: the move that begins there.
        zone: commanded distance from the corner [m], above 0.
    """
    assert before.joints is not None
    assert behind.joints is not None
    in_tool = (
        before.tool is not None and behind.tool is not None and before.planned.X_MT == behind.planned.X_MT
    )
    ends = _Way(chain, before), _Way(chain, behind)
    halves = [_HALF * way.length for way in ends]
    widest = min(ends[0].distance(halves[0], ends[0].length), ends[1].distance(halves[1], 0.0))
    flown = min(zone, widest)
    if flown <= 0.0:
        return Stop.STANDS
    s_leave = leave(ends[0].positions, ends[0].length, flown, halves[0])
    s_enter = enter(ends[1].positions, ends[1].length, flown, halves[1])
    if in_tool and before.tool is not None and behind.tool is not None:
        between = corner(before.tool, s_leave, behind.tool, s_enter)
        if between is CornerFault.TURNS_BACK:
            return Stop.TURNS_BACK
        if not isinstance(between, CornerFault):
            q = before.joints.joints(np.array([s_leave])).q[0]
            traced = trace(chain, between, q, before.move)
            if isinstance(traced, Refusal):
                return Stop.UNREACHABLE
            return Rounding(flown, s_leave, s_enter, traced[0], between)
    c_in, c_out = 2.0 * (ends[0].length - s_leave), 2.0 * s_enter
    joints = joint_blend(before.joints, s_leave, c_in, behind.joints, s_enter, c_out)
    return Rounding(flown, s_leave, s_enter, joints, None, 1.0 / c_in, c_out)


class _Way:
    """Positions of the TCP along the path of a move."""

    def __init__(self, chain: MotionChain, leg: Leg) -> None:
        self._chain = chain
        self._leg = leg
        assert leg.joints is not None
        self._joints = leg.joints
        self.length = leg.joints.length

    def positions(self, places: Array) -> Array:
        """Return TCP positions in the base frame [m] at places (k,), shape (k, 3)."""
        if self._leg.tool is not None:
            return self._leg.tool.positions(places)
        matrices = forward_batch(self._chain.robot, self._joints.joints(places).q)
        return np.asarray((matrices @ self._leg.planned.X_MT.matrix())[:, :3, 3])

    def distance(self, place: float, other: float) -> float:
        """Return the distance of the TCP between two places [m]."""
        a, b = self.positions(np.array([place, other]))
        return float(np.linalg.norm(a - b))
