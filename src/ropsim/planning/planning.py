"""Planning a sequence: moves become paths, paths a course with rounded corners, that a motion in time."""

import math
from collections.abc import Sequence
from itertools import pairwise

from ropsim.core import Diagnostic
from ropsim.flow import MoveInstruction
from ropsim.model import Payload, RobotModel
from ropsim.motion import TIME_LAWS, Infeasible, JointBounds, Ticks, own_law_of
from ropsim.planning.blends.blend import Blend, Stop, blend_between
from ropsim.planning.control_ticks import in_ticks, standing
from ropsim.planning.joint_limits.arm_limits import arm_bounds, beyond_refusal, move_at, slowed_findings
from ropsim.planning.motion_sequence import MotionSequence
from ropsim.planning.moves.move_check import check_duration
from ropsim.planning.moves.planned_move import PlannedMove
from ropsim.planning.path_limits.path_limits import along_with, joint_path_limits, tool_path_limits
from ropsim.planning.records.entities import Refusal
from ropsim.planning.records.motion_chain import MotionChain
from ropsim.planning.records.motion_plan import MotionPlan, MotionState
from ropsim.planning.sequence_checks import (
    beside_correction,
    beyond_arm,
    check_start,
    correction_refusal,
    joints_refusal,
    may_take_too_long,
    rest_to_rest_refusal,
    standing_refusal,
)
from ropsim.planning.sequence_moves import sequence_moves
from ropsim.planning.stops.chosen_stops import by_joints, by_tool
from ropsim.planning.trajectory.sections import TimingRules
from ropsim.planning.trajectory.segments import segments_of
from ropsim.planning.zones import achieved_zones, clipped, stopped
from ropsim.spatial import Array, record

NO_PAYLOAD = Payload()
_CRAWLING = 1e-9
"""Smallest limit of a move that is planned without a check of its duration, in units of the limits."""
_SMALLEST = 1e-300
"""Bounds below this count as this, so that nothing is divided by 0."""


def ordered(chain: MotionChain, order: MotionSequence) -> tuple[MotionPlan | None, Refusal | None]:
    """Return the motion through the moves of a sequence from rest; see `plan`."""
    return plan(chain, order.moves, MotionState.at_rest(order.q_start), order.payload, order.ahead)


def plan(
    chain: MotionChain,
    sequence: Sequence[MoveInstruction],
    state: MotionState,
    payload: Payload = NO_PAYLOAD,
    ahead: Sequence[MoveInstruction] = (),
) -> tuple[MotionPlan | None, Refusal | None]:
    """Return the motion through the moves of a sequence.

    All moves but the last have a zone. A move that cannot be made ends the plan: the arm stops at the
    target of the one before it.

    Args:
        chain: the entities.
        sequence: moves in order.
        state: at rest.
        payload: tool and part as one body, for the whole sequence.
        ahead: moves that follow upon the stop at its end; they also affect the choice of postures.

    Returns:
        The plan of the moves up to the first one that cannot be made, None where that is the first; and why
        it cannot be made, None where all can.
    """
    wrong = check_start(state, chain.robot, sequence[0])
    if wrong:
        return None, wrong
    legs, refusal = sequence_moves(chain, sequence, ahead, state.q)
    while legs:
        planned = _planned(chain, legs, state, payload)
        if isinstance(planned, MotionPlan):
            return planned, refusal
        legs, refusal = legs[: planned.leg], planned.refusal
    return None, refusal


@record
class _Hurdle:
    """A move that cannot be made though its path is known.

    Attributes:
        leg: its number.
        refusal: why.
    """

    leg: int
    refusal: Refusal


def _planned(
    chain: MotionChain, legs: list[PlannedMove], state: MotionState, payload: Payload
) -> MotionPlan | _Hurdle:
    """Return the motion through moves, or the move that cannot be made."""
    findings = [finding for leg in legs for finding in leg.findings]
    findings += beyond_arm(legs, chain.robot)
    crawling = _crawling(legs)
    for number, leg in enumerate(legs):
        if number in crawling and check_duration(leg.move, alone := _time_alone(leg)):
            return _too_long(legs, number, alone)
        if refusal := correction_refusal(leg):
            return _Hurdle(number, refusal)
    corners = _corners(chain, legs, findings)
    walks = segments_of(legs, corners)
    for pieces, _ in walks:
        for piece in pieces:
            if piece.corner is None and (refusal := standing_refusal(legs[piece.leg], piece)):
                return _Hurdle(piece.leg, refusal)
    rates = chain.controller.rates
    rules, period = TimingRules(TIME_LAWS[chain.time_law], chain.controller.look_ahead), rates.control_period
    chosen = by_tool(legs, corners, walks, rules)
    findings += (hint for one in chosen.stops for hint in stopped(legs[one].move, Stop.QUICKER))
    course = chosen.course
    if not course.runs:
        return standing(legs, state.q, period, findings)
    if late := _late(legs, course.ends):
        return _too_long(legs, *late)
    bounds = arm_bounds(chain.robot, payload)
    if infeasible := _infeasible(legs, chosen.corners, state.q, chain.robot, bounds.joints):
        return infeasible
    if any(leg.move.tracking for leg in legs):
        bounds = beside_correction(bounds)
    by_joint_limits = by_joints(legs, chosen, bounds, Ticks(period, rates.interpolation_ticks), rules)
    findings += (hint for one in by_joint_limits.stops for hint in stopped(legs[one].move, Stop.SLOWED))
    course, kept = by_joint_limits.keeping.course, by_joint_limits.keeping.kept
    if isinstance(kept, Infeasible):
        number = move_at(course.ends, kept.phi)
        return _Hurdle(number, beyond_refusal(legs[number], kept, chain.robot))
    if late := _late(legs, kept.clock.times_of(course.ends).tolist()):
        return _Hurdle(late[0], Refusal(check_duration(legs[late[0]].move, late[1])))
    findings += slowed_findings(legs, course.ends, by_joint_limits.keeping.slowed, chain.robot)
    zones = achieved_zones(chain.robot, legs, by_joint_limits.corners, by_joint_limits.keeping.motion)
    return in_ticks(chain, legs, zones, course, kept, findings)


def _infeasible(
    legs: list[PlannedMove],
    corners: Sequence[Blend | None],
    q_start: Array,
    robot: RobotModel,
    bounds: JointBounds,
) -> _Hurdle | None:
    """Return the first move for which joints need far too long, as is seen without a time law.

    Args:
        legs: the moves.
        corners: between each two of them; None where the arm stops.
        q_start: joint coordinates at the start [rad | m], shape (n,).
        robot: the arm.
        bounds: capabilities of its joints.
    """
    if not may_take_too_long(robot, bounds):
        return None
    for number, leg in enumerate(legs):
        if refusal := joints_refusal(leg, bounds.speed):
            return _Hurdle(number, refusal)
    stops = [0, *(number + 1 for number, corner in enumerate(corners) if corner is None), len(legs)]
    for first, last in pairwise(stops):
        q_first = legs[first - 1].q_end if first else q_start
        if found := rest_to_rest_refusal(legs[first:last], q_first, bounds):
            return _Hurdle(first + found[0], found[1])
    return None


def _late(legs: list[PlannedMove], ends: Sequence[float]) -> tuple[int, float] | None:
    """Return the first move that lasts too long, and how long [s]; None where all end soon enough.

    Args:
        legs: the moves.
        ends: times at which they end [s].
    """
    for number, (leg, (before, end)) in enumerate(zip(legs, pairwise((0.0, *ends)), strict=True)):
        if check_duration(leg.move, end - before):
            return number, end - before
    return None


def _too_long(legs: list[PlannedMove], number: int, duration: float) -> _Hurdle:
    """Return M513 for a move that lasts too long [s], or for the neighbour that makes its corner slow."""
    beside = range(max(number - 1, 0), min(number + 2, len(legs)))
    slowest = max(beside, key=lambda one: (_time_alone(legs[one]), one == number))
    return _Hurdle(slowest, Refusal(check_duration(legs[slowest].move, duration)))


def _crawling(legs: Sequence[PlannedMove]) -> set[int]:
    """Return the moves with a limit so small that their time is no number to plan with."""
    found, last, crawls = set[int](), None, False
    for number, leg in enumerate(legs):
        if (limits := leg.planned.limits) is not last:
            last, joints = limits, limits.joints
            of_joints = joints.speed.tolist(), joints.acceleration.tolist(), joints.jerk.tolist()
            crawls = min(*map(min, of_joints), *limits.tool.all) < _CRAWLING
        if crawls:
            found.add(number)
    return found


def _time_alone(leg: PlannedMove) -> float:
    """Return the time [s] below which a move cannot be made from rest to rest."""
    limits = leg.planned.limits
    if leg.joints is None:
        return 0.0
    if own := own_law_of(leg.joints):
        return own.duration
    stages = (
        along_with(tool_path_limits(leg.tool, limits.tool), leg.planned.coordination)
        if leg.tool
        else joint_path_limits(leg.joints, limits.joints)
    )
    way = sum(stage.length for stage in stages)
    cruise = sum(stage.length / max(stage.speed, _SMALLEST) for stage in stages)
    acceleration = max(_SMALLEST, *(stage.acceleration for stage in stages))
    jerk = max(_SMALLEST, *(stage.jerk for stage in stages))
    return max(cruise, math.sqrt(4.0 * way / acceleration), math.cbrt(32.0 * way / jerk))


def _corners(chain: MotionChain, legs: list[PlannedMove], findings: list[Diagnostic]) -> list[Blend | None]:
    """Return the rounded corners between moves, None where the arm stops or where nothing moves."""
    corners: list[Blend | None] = []
    for before, behind in pairwise(legs):
        found = blend_between(chain, before, behind)
        if isinstance(found, Stop):
            findings += stopped(before.move, found)
            corners.append(None)
        else:
            findings += clipped(before.move, found)
            corners.append(found)
    return corners
