"""Planning a sequence: moves become paths, paths with blends become a timing, and that a trajectory."""

import math
from collections.abc import Mapping, Sequence
from itertools import pairwise

from ropsim.core import Diagnostic
from ropsim.flow import MoveInstruction, ReachedSpeed
from ropsim.model import Payload, RobotModel
from ropsim.motion import TIME_LAWS, Infeasible, JointBounds, RetimedTrajectory, Ticks, own_law_of
from ropsim.planning.achieved.helpful_limits import AchievedMotion
from ropsim.planning.achieved.lines_as_curves import lines_as_curves
from ropsim.planning.achieved.reached_speeds import reached_speeds, singularity_at
from ropsim.planning.achieved.zones import achieved_zones, clipped, stopped
from ropsim.planning.blends.blend import Blend, PassedPoint, Stop
from ropsim.planning.blends.curve_blends import blend_at
from ropsim.planning.blends.move_curves import may_be_slower, with_curves
from ropsim.planning.control_ticks import in_ticks, standing
from ropsim.planning.joint_limits.arm_limits import (
    ArmBounds,
    arm_bounds,
    beyond_refusal,
    move_at,
    slowed_findings,
)
from ropsim.planning.moves.move_check import check_duration
from ropsim.planning.moves.planned_move import PlannedMove
from ropsim.planning.path_limits.path_limits import along_with, joint_path_limits, tool_path_limits
from ropsim.planning.records.entities import Refusal
from ropsim.planning.records.motion_chain import MotionChain
from ropsim.planning.records.motion_plan import MotionPlan, MotionSequence, MotionState
from ropsim.planning.sequence_checks import (
    beyond_arm,
    check_start,
    correction_refusal,
    joints_refusal,
    may_take_too_long,
    rest_to_rest_refusal,
    standing_refusal,
    with_correction,
)
from ropsim.planning.sequence_moves import sequence_moves
from ropsim.planning.stops.chosen_stops import ByJoints, ByTool, by_joints, by_tool
from ropsim.planning.trajectory.sections import TimingRules
from ropsim.planning.trajectory.segments import segments_of
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
    made, refusal = _made(chain, sequence, state, payload, ahead)
    return (_explained(made) if isinstance(made, _Motion) else made), refusal


def timed(chain: MotionChain, order: MotionSequence) -> tuple[MotionPlan | None, Refusal | None]:
    """Return the motion of `ordered` without the reasons why moves are slower than programmed.

    They take about as long as planning itself, which counts where a sequence is planned again and again.
    """
    start = MotionState.at_rest(order.q_start)
    made, refusal = _made(chain, order.moves, start, order.payload, order.ahead)
    return (_in_ticks(made, {}, made.findings) if isinstance(made, _Motion) else made), refusal


def _made(
    chain: MotionChain,
    sequence: Sequence[MoveInstruction],
    state: MotionState,
    payload: Payload,
    ahead: Sequence[MoveInstruction],
) -> "tuple[MotionPlan | _Motion | None, Refusal | None]":
    """Return the motion through the moves up to the first one that cannot be made; see `plan`."""
    wrong = check_start(state, chain.robot, sequence[0])
    if wrong:
        return None, wrong
    moves, refusal = sequence_moves(chain, sequence, ahead, state.q)
    while moves:
        planned = _quickest(chain, moves, state, payload)
        if not isinstance(planned, _Hurdle):
            return planned, refusal
        moves, refusal = moves[: planned.move_number], planned.refusal
    return None, refusal


@record
class _Hurdle:
    """A move that cannot be made though its path is known.

    Attributes:
        move_number: its number.
        refusal: why.
    """

    move_number: int
    refusal: Refusal


@record
class _Motion:
    """A motion over nominal time, of which nothing is said yet.

    Attributes:
        chain: the entities.
        moves: the moves.
        chosen: blends and timing by the limits of the tool.
        by_joint_limits: the same within the limits of the joints.
        bounds: capabilities of the arm.
        rules: of the timing.
        retimed: the trajectory at all control ticks.
        findings: so far.
    """

    chain: MotionChain
    moves: list[PlannedMove]
    chosen: ByTool
    by_joint_limits: ByJoints
    bounds: ArmBounds
    rules: TimingRules
    retimed: RetimedTrajectory
    findings: list[Diagnostic]

    @property
    def ticks(self) -> int:
        """Return how many control ticks it takes."""
        period = self.chain.controller.rates.control_period
        return Ticks(period).count(self.retimed.clock.duration)


def _quickest(
    chain: MotionChain, moves: list[PlannedMove], state: MotionState, payload: Payload
) -> MotionPlan | _Motion | _Hurdle:
    """Return the motion through moves, with chains of short lines as curves where these are quicker."""
    curved = with_curves(chain, moves)
    if not any(move.on_curve for move in curved):
        return _planned(chain, moves, state, payload)
    along = _planned(chain, curved, state, payload)
    if isinstance(along, _Motion) and not may_be_slower(curved):
        return along
    rounded = _planned(chain, moves, state, payload)
    if isinstance(along, _Motion) and isinstance(rounded, _Motion):
        return min(along, rounded, key=lambda one: one.ticks)
    return along if isinstance(along, _Motion) else rounded


def _planned(
    chain: MotionChain, moves: list[PlannedMove], state: MotionState, payload: Payload
) -> MotionPlan | _Motion | _Hurdle:
    """Return the motion through moves, or the move that cannot be made; a plan where nothing moves."""
    findings = [finding for move in moves for finding in move.findings]
    findings += beyond_arm(moves, chain.robot)
    crawling = _crawling(moves)
    for number, move in enumerate(moves):
        if number in crawling and check_duration(move.move, alone := _time_alone(move)):
            return _too_long(moves, number, alone)
        if refusal := correction_refusal(move):
            return _Hurdle(number, refusal)
    blends = _blends(chain, moves, findings)
    joined = segments_of(moves, blends)
    for path_segments, _ in joined:
        for path_segment in path_segments:
            if path_segment.blend is None and (
                refusal := standing_refusal(moves[path_segment.move_number], path_segment)
            ):
                return _Hurdle(path_segment.move_number, refusal)
    period = chain.controller.rates.control_period
    rules = TimingRules(TIME_LAWS[chain.time_law], chain.controller.look_ahead)
    chosen = by_tool(moves, blends, joined, rules)
    findings += (hint for one in chosen.stops for hint in stopped(moves[one].move, Stop.QUICKER))
    timing = chosen.timing
    if not timing.sections:
        return standing(moves, state.q, period, findings)
    if late := _late(moves, timing.ends):
        return _too_long(moves, *late)
    bounds = arm_bounds(chain.robot, payload)
    if infeasible := _infeasible(moves, chosen.blends, state.q, chain.robot, bounds.joints):
        return infeasible
    if any(move.move.tracking for move in moves):
        bounds = with_correction(bounds)
    by_joint_limits = by_joints(moves, chosen, bounds, Ticks(period), rules)
    findings += (hint for one in by_joint_limits.stops for hint in stopped(moves[one].move, Stop.SLOWED))
    timing, retimed = by_joint_limits.retiming.timing, by_joint_limits.retiming.retimed
    if isinstance(retimed, Infeasible):
        number = move_at(timing.ends, retimed.phi)
        return _Hurdle(number, beyond_refusal(moves[number], retimed, chain.robot))
    if late := _late(moves, retimed.clock.times_of(timing.ends).tolist()):
        return _Hurdle(late[0], Refusal(check_duration(moves[late[0]].move, late[1])))
    return _Motion(chain, moves, chosen, by_joint_limits, bounds, rules, retimed, findings)


def _explained(motion: _Motion) -> MotionPlan:
    """Return the plan of a motion with the reasons why moves are slower than programmed."""
    moves, robot, retiming = motion.moves, motion.chain.robot, motion.by_joint_limits.retiming
    blends = motion.by_joint_limits.blends
    slowed = slowed_findings(
        moves,
        retiming.timing.ends,
        retiming.slowed,
        robot,
        lambda part: singularity_at(retiming, part, robot),
    )
    ticks = Ticks(motion.chain.controller.rates.control_period)
    achieved = AchievedMotion(moves, blends, motion.bounds, ticks, motion.rules)
    reached = reached_speeds(achieved, motion.chosen.timing, retiming, robot)
    return _in_ticks(
        motion, reached, [*motion.findings, *slowed, *lines_as_curves(motion.chain, moves, blends)]
    )


def _in_ticks(
    motion: _Motion, reached: Mapping[int, ReachedSpeed], findings: Sequence[Diagnostic]
) -> MotionPlan:
    joints = motion.by_joint_limits
    zones = achieved_zones(motion.chain.robot, motion.moves, joints.blends, joints.retiming.motion)
    return in_ticks(
        motion.chain, motion.moves, zones, joints.retiming.timing, motion.retimed, reached, findings
    )


def _infeasible(
    moves: list[PlannedMove],
    blends: Sequence[Blend | None],
    q_start: Array,
    robot: RobotModel,
    bounds: JointBounds,
) -> _Hurdle | None:
    """Return the first move for which joints need far too long, as is seen without a time law.

    Args:
        moves: the moves.
        blends: between each two of them; None where the arm stops.
        q_start: joint coordinates at the start [rad | m], shape (n,).
        robot: the arm.
        bounds: capabilities of its joints.
    """
    if not may_take_too_long(robot, bounds):
        return None
    for number, move in enumerate(moves):
        if refusal := joints_refusal(move, bounds.speed):
            return _Hurdle(number, refusal)
    stops = [0, *(number + 1 for number, blend in enumerate(blends) if blend is None), len(moves)]
    for first, last in pairwise(stops):
        q_first = moves[first - 1].q_end if first else q_start
        if found := rest_to_rest_refusal(moves[first:last], q_first, bounds):
            return _Hurdle(first + found[0], found[1])
    return None


def _late(moves: list[PlannedMove], ends: Sequence[float]) -> tuple[int, float] | None:
    """Return the first move that lasts too long, and how long [s]; None where all end soon enough.

    Args:
        moves: the moves.
        ends: times at which they end [s].
    """
    for number, (move, (before, end)) in enumerate(zip(moves, pairwise((0.0, *ends)), strict=True)):
        if check_duration(move.move, end - before):
            return number, end - before
    return None


def _too_long(moves: list[PlannedMove], number: int, duration: float) -> _Hurdle:
    """Return M513 for a move that lasts too long [s], or for the neighbour that makes its blend slow."""
    neighbours = range(max(number - 1, 0), min(number + 2, len(moves)))
    slowest = max(neighbours, key=lambda one: (_time_alone(moves[one]), one == number))
    return _Hurdle(slowest, Refusal(check_duration(moves[slowest].move, duration)))


def _crawling(moves: Sequence[PlannedMove]) -> set[int]:
    """Return the moves with a limit so small that their time is no number to plan with."""
    found, last, crawls = set[int](), None, False
    for number, move in enumerate(moves):
        if (limits := move.planned.limits) is not last:
            last, joints = limits, limits.joints
            of_joints = joints.speed.tolist(), joints.acceleration.tolist(), joints.jerk.tolist()
            crawls = min(*map(min, of_joints), *limits.tool.all) < _CRAWLING
        if crawls:
            found.add(number)
    return found


def _time_alone(move: PlannedMove) -> float:
    """Return the time [s] below which a move cannot be made from rest to rest."""
    limits = move.planned.limits
    if move.joints is None:
        return 0.0
    if own := own_law_of(move.joints):
        return own.duration
    path_limits = (
        along_with(tool_path_limits(move.tool, limits.tool), move.planned.coordination)
        if move.tool
        else joint_path_limits(move.joints, limits.joints)
    )
    length = sum(limit.length for limit in path_limits)
    cruise = sum(limit.length / max(limit.speed, _SMALLEST) for limit in path_limits)
    acceleration = max(_SMALLEST, *(limit.acceleration for limit in path_limits))
    jerk = max(_SMALLEST, *(limit.jerk for limit in path_limits))
    return max(cruise, math.sqrt(4.0 * length / acceleration), math.cbrt(32.0 * length / jerk))


def _blends(chain: MotionChain, moves: list[PlannedMove], findings: list[Diagnostic]) -> list[Blend | None]:
    """Return the rounded blends between moves, None where the arm stops or where nothing moves.

    Nothing is told of the stop at the end of a path that says itself that the arm stops there.

    Where the arm is at the target of a move already, that is told only if it flows there: not where it stands
    before the first move, nor behind a move that is told to have the same target.
    """
    blends: list[Blend | None] = []
    stands = True
    for before, behind in pairwise(moves):
        if before.planned.stops:
            stands = True
            blends.append(None)
            continue
        found = blend_at(chain, before, behind)
        if isinstance(found, Stop):
            if not (stands and found is Stop.NO_WAY_TO):
                findings += stopped(before.move, found)
            stands = found in (Stop.NO_WAY_TO, Stop.NO_WAY_ON)
            blends.append(None)
        else:
            stands = False
            if not isinstance(found, PassedPoint):
                findings += clipped(before.move, found)
            blends.append(found)
    return blends
