"""Blends of a sequence: how the path goes from one move to the next where a zone is in force."""

import math
from enum import Enum

import numpy as np

from ropsim.core import maker
from ropsim.flow import MoveInstruction
from ropsim.motion import BlendFault, JointPath, ToolPath, blend_curve
from ropsim.planning.blends.joined_ends import joined_to
from ropsim.planning.blends.meeting import meeting_of
from ropsim.planning.blends.wrist_blend import are_led, wrist_blend_of
from ropsim.planning.blends.zone_search import Crossing, tcp_path_of
from ropsim.planning.moves.path_following import follow_path
from ropsim.planning.moves.planned_move import PlannedMove
from ropsim.planning.records.coordination import Coordination, coordination_round
from ropsim.planning.records.entities import Refusal
from ropsim.planning.records.motion_chain import MotionChain
from ropsim.spatial import record

HALF = 0.5
"""Share of a move that a zone may take."""

LEAST_ZONE = 1e-6
"""Zones below this are none [m]: no arm shows them, and rounding would decide their path."""


class Stop(Enum):
    """Why the arm stops at a blend though a zone is in force."""

    TURNS_BACK = "the path turns back on itself there"
    STANDS = "the tool only turns on one side of it"
    TOO_SMALL = "it is smaller than a micrometre"
    NO_WAY_TO = "the arm is at its target already"
    NO_WAY_ON = "the next move has the same target"
    UNREACHABLE = "the arm cannot follow the rounded corner"
    QUICKER = "a stop takes less time than to slow down for the bend of this zone"
    SLOWED = "a stop takes less time than to slow down for the joints in this zone"
    NO_LOOK_AHEAD = "the controller does not look ahead"


@record
class CartesianBlend:
    """A blend between two paths of the tool, rounded by a third one.

    Attributes:
        zone: distance of the TCP from the blend at which the path leaves and enters [m].
        leave: path parameter on the path before, in its unit.
        enter: path parameter on the path behind, in its unit.
        tool: the path between, in the base frame or that of the coordination.
        joints: the same in joint space.
        coordination: external axes that go along; None where they stand on both sides.
    """

    zone: float
    leave: float
    enter: float
    tool: ToolPath
    joints: JointPath
    coordination: Coordination | None

    @property
    def turn(self) -> float:
        """Return the angle between the directions in which it is entered and left, in [0, pi] [rad]."""
        one, other = self.tool.tool(np.array((0.0, self.tool.length))).d1[:, :3]
        sine = np.linalg.norm(np.cross(one, other))
        return math.atan2(float(sine), float(one @ other))


@record
class JointSpaceBlend:
    """A blend at which the next move begins while the one before still ends: both motions are added.

    Attributes:
        zone: distance of the TCP from the blend within which both may last, on the longer of the paths [m].
        shorter: the same on the shorter one [m].
        leave: path parameter on the path before from which on the next move may begin, in its unit.
        enter: path parameter on the path behind up to which the one before may last, in its unit.
    """

    zone: float
    shorter: float
    leave: float
    enter: float


_overlap = maker(JointSpaceBlend)


@record
class PassedPoint:
    """A point that a curve of moves passes, or a place at which it goes over into a line.

    Attributes:
        zone: distance of the TCP from the point within which the path may leave the lines [m].
        leave: path parameter on the path before, in its unit.
        enter: path parameter on the path behind, in its unit.
    """

    zone: float
    leave: float
    enter: float


Blend = CartesianBlend | JointSpaceBlend | PassedPoint


def blend_between(chain: MotionChain, before: PlannedMove, behind: PlannedMove) -> Blend | Stop:
    """Return the blend between two moves, or why the arm must stop there.

    Two paths of one tool are joined by a path of the tool, seen from a frame in which both are given. Where
    there is none, a path in joint space takes part, or the tool changes, the motions overlap: the path of the
    tool is unspecified there.

    Args:
        chain: the entities.
        before: the move that ends at the blend, with a zone.
        behind: the move that begins there.
    """
    if chain.controller.look_ahead.moves < 1:
        return Stop.NO_LOOK_AHEAD
    if before.joints is None:
        return Stop.NO_WAY_TO
    if behind.joints is None:
        return Stop.NO_WAY_ON
    meeting = meeting_of(before, behind)
    one, other = (
        tcp_path_of(chain.robot, joints, move.planned.X_MT, path)
        for move, joints, path in (
            (before, before.joints, meeting.before if meeting else _in_base(before)),
            (behind, behind.joints, meeting.behind if meeting else _in_base(behind)),
        )
    )
    halves, zone = (HALF * one.length, HALF * other.length), commanded_zone(chain, before.move)
    if zone < LEAST_ZONE:
        return Stop.TOO_SMALL
    if meeting:
        zone = min(zone, one.distance(halves[0], one.length), other.distance(halves[1], 0.0))
        if zone < LEAST_ZONE:
            return Stop.STANDS
    (s_leave, leaving), (s_enter, entering) = one.leave(zone, halves[0]), other.enter(zone, halves[1])
    achieved = max(leaving, entering)
    if meeting:
        between = blend_curve(meeting.before, s_leave, meeting.behind, s_enter)
        if between is BlendFault.TURNS_BACK:
            return Stop.TURNS_BACK
        if not isinstance(between, BlendFault):
            axes = meeting.axes
            along = coordination_round(between.length, axes[0], s_leave, axes[1], s_enter) if axes else None
            if are_led(before, behind):
                led = wrist_blend_of(chain.robot, (before, s_leave), (behind, s_enter), between, along)
                return (
                    CartesianBlend(achieved, s_leave, s_enter, led.tool, led.joints, along)
                    if led
                    else Stop.UNREACHABLE
                )
            ends = before.joints.joints(np.array([s_leave])), behind.joints.joints(np.array([s_enter]))
            traced = follow_path(chain, between, ends[0].q[0], before.move, along)
            if isinstance(traced, Refusal):
                return Stop.UNREACHABLE
            joints = joined_to(chain, between, traced[0], ends, before.planned, along)
            return (
                CartesianBlend(achieved, s_leave, s_enter, between, joints, along)
                if joints
                else Stop.UNREACHABLE
            )
    return joint_space_blend_of((s_leave, leaving), (s_enter, entering))


def joint_space_blend_of(leave: Crossing, enter: Crossing) -> JointSpaceBlend:
    """Return the overlap of two moves.

    Args:
        leave: where the path before may be left.
        enter: up to where that behind may be entered.
    """
    (s_leave, leaving), (s_enter, entering) = leave, enter
    achieved, shorter = max(leaving, entering), min(leaving, entering)
    # where the tool only turns no zone is too long
    return _overlap(achieved, shorter if shorter > LEAST_ZONE else achieved, s_leave, s_enter)


def commanded_zone(chain: MotionChain, move: MoveInstruction) -> float:
    """Return the zone of a move [m]: its own, or that of via points where it only passes by."""
    modal = move.modal
    return chain.controller.via_zone if modal.passes and modal.zone == 0.0 else modal.zone


def _in_base(move: PlannedMove) -> ToolPath | None:
    """Return the path of the tool of a move if it is in the base frame."""
    coordination = move.planned.coordination
    return None if coordination and coordination.frame else move.tool
