"""Corners of a stretch: how the path goes from one move to the next where a zone is in force."""

from enum import Enum

import numpy as np

from ropsim.controller.entities import Refusal
from ropsim.controller.leg import Leg, trace
from ropsim.controller.motion_chain import MotionChain
from ropsim.flow import MoveInstruction
from ropsim.kinematics import forward_batch
from ropsim.motion import CornerFault, JointPath, ToolPath, corner, enter, leave
from ropsim.spatial import Array, record

_HALF = 0.5
"""Share of a move that a zone may take."""

_LEAST = 1e-6
"""Zones below this are none [m]: no arm shows them, and rounding would have a say in the way round them."""


class Stop(Enum):
    """Why the arm stops at a corner though a zone is in force."""

    TURNS_BACK = "the path turns back on itself there"
    STANDS = "the tool only turns on one side of it"
    TOO_SMALL = "it is smaller than a micrometre"
    NO_WAY = "there is no way between it and its neighbour"
    UNREACHABLE = "the arm cannot follow the rounded corner"
    NO_LOOK_AHEAD = "the controller does not look ahead"


@record
class Rounding:
    """A corner between two paths of the tool, rounded by a third one.

    Attributes:
        zone: distance of the TCP from the corner at which the path leaves and enters [m].
        leave: place on the path before, in its unit.
        enter: place on the path behind, in its unit.
        tool: the way between.
        joints: the same in joint space.
    """

    zone: float
    leave: float
    enter: float
    tool: ToolPath
    joints: JointPath


@record
class Overlap:
    """A corner at which the next move begins while the one before still ends: both motions are added.

    Attributes:
        zone: largest distance of the TCP from the corner while both last [m].
        leave: place on the path before from which on the next move may begin, in its unit.
        enter: place on the path behind up to which the one before may last, in its unit.
    """

    zone: float
    leave: float
    enter: float


Corner = Rounding | Overlap


def corner_between(chain: MotionChain, before: Leg, behind: Leg) -> Corner | Stop:
    """Return the corner between two moves, or why the arm must stop there.

    Two paths of one tool are joined by a path of the tool. Where a path in joint space takes part, or the
    tool changes, the motions overlap: nobody has said on which way the tool goes there.

    Args:
        chain: the entities.
        before: the move that ends at the corner, with a zone.
        behind: the move that begins there.
    """
    if chain.controller.look_ahead < 1:
        return Stop.NO_LOOK_AHEAD
    if before.joints is None or behind.joints is None:
        return Stop.NO_WAY
    one, other = _Way(chain, before, before.joints), _Way(chain, behind, behind.joints)
    halves, zone = (_HALF * one.length, _HALF * other.length), commanded_zone(chain, before.move)
    if zone < _LEAST:
        return Stop.TOO_SMALL
    tools = _tools(before, behind)
    if tools:
        zone = min(zone, one.distance(halves[0], one.length), other.distance(halves[1], 0.0))
        if zone < _LEAST:
            return Stop.STANDS
    s_leave = leave(one.positions, one.length, zone, halves[0])
    s_enter = enter(other.positions, other.length, zone, halves[1])
    flown = max(one.distance(s_leave, one.length), other.distance(s_enter, 0.0))
    if tools:
        between = corner(tools[0], s_leave, tools[1], s_enter)
        if between is CornerFault.TURNS_BACK:
            return Stop.TURNS_BACK
        if not isinstance(between, CornerFault):
            q = before.joints.joints(np.array([s_leave])).q[0]
            traced = trace(chain, between, q, before.move)
            if isinstance(traced, Refusal):
                return Stop.UNREACHABLE
            return Rounding(flown, s_leave, s_enter, between, traced[0])
    return Overlap(flown, s_leave, s_enter)


def commanded_zone(chain: MotionChain, move: MoveInstruction) -> float:
    """Return the zone of a move [m]: its own, or that of via points where it only passes by."""
    modal = move.modal
    return chain.controller.via_zone if modal.passes and modal.zone == 0.0 else modal.zone


def _tools(before: Leg, behind: Leg) -> tuple[ToolPath, ToolPath] | None:
    """Return the paths of the tool of two moves, where both have one and it is the same tool."""
    if before.tool is None or behind.tool is None or before.planned.X_MT != behind.planned.X_MT:
        return None
    return before.tool, behind.tool


class _Way:
    """Positions of the TCP along the path of a move."""

    def __init__(self, chain: MotionChain, leg: Leg, joints: JointPath) -> None:
        self._robot = chain.robot
        self._leg = leg
        self._joints = joints
        self.length = joints.length

    def positions(self, places: Array) -> Array:
        """Return TCP positions in the base frame [m] at places (k,), shape (k, 3)."""
        if self._leg.tool is not None:
            return self._leg.tool.positions(places)
        matrices = forward_batch(self._robot, self._joints.joints(places).q)
        return np.asarray((matrices @ self._leg.planned.X_MT.matrix())[:, :3, 3])

    def distance(self, place: float, other: float) -> float:
        """Return the distance of the TCP between two places [m]."""
        a, b = self.positions(np.array([place, other]))
        return float(np.linalg.norm(a - b))
