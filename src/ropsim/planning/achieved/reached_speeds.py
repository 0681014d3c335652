"""Speeds that moves on paths of the tool reach, and what keeps them below the programmed ones."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from ropsim.core import Span
from ropsim.flow import LimitQuantity, MotionKind, ReachedSpeed, SpeedCause
from ropsim.kinematics import near_singularity
from ropsim.model import RobotModel
from ropsim.motion import Quantity, RetimedTrajectory, Slowed, ToolLimits
from ropsim.planning.achieved.helpful_limits import AchievedMotion, helpful_limits
from ropsim.planning.achieved.moves_on_sections import MoveOnSection, moves_on, times_at
from ropsim.planning.achieved.tool_causes import SAMPLES, SLOW, tool_cause, turn_of
from ropsim.planning.joint_limits.retiming import Retiming
from ropsim.planning.moves.planned_move import PlannedMove
from ropsim.planning.trajectory.sections import TimingRules, planned_section
from ropsim.planning.trajectory.timing import TimedSection, Timing, timing_of
from ropsim.spatial import record

_QUANTITIES = {
    Quantity.SPEED: LimitQuantity.SPEED,
    Quantity.ACCELERATION: LimitQuantity.ACCELERATION,
    Quantity.JERK: LimitQuantity.JERK,
    Quantity.TORQUE: LimitQuantity.TORQUE,
}
_BY_JOINTS = 0.5
"""Share of the time lost from which on joints are the cause."""
_BY_PATH = (SpeedCause.ACCELERATION, SpeedCause.JERK, SpeedCause.ZONE, SpeedCause.BEND)
"""Causes of which limits of the path for acceleration and jerk are a part."""
_LEAST_LOST = 0.02
"""Time [s] that is lost on a line or curve of a sequence at least for that."""
_MOST_LOOKED_AT = 6
"""Lines or curves of a sequence for which planning looks for what helps."""


_TimedSpan = tuple[TimedSection, MoveOnSection, tuple[float, float]]
"""A move on its section, and the times from the start of that on at which it begins and ends [s]."""


@record
class _Slow:
    """A move that is slow, on its section as it is achieved.

    Attributes:
        section: in the timing that is achieved.
        span: of the move there.
        phi: nominal times at which it begins and ends [s].
        time: that it takes [s].
        lost: more than it would with the programmed speed [s].
    """

    section: TimedSection
    span: MoveOnSection
    phi: tuple[float, float]
    time: float
    lost: float


def reached_speeds(
    achieved: AchievedMotion, by_tool: Timing, retiming: Retiming, robot: RobotModel
) -> dict[int, ReachedSpeed]:
    """Return the moves that are slower than programmed, by their numbers.

    The ways of the moves between two stops could be a straight line: the tool would go with the programmed
    speed all the way, but for speeding up and slowing down at both stops with acceleration and jerk of the
    path. A move for which that is less than nine tenths of its time is slow. Of the moves of a line the one
    that loses most for a cause says which limits of the path help.

    Args:
        achieved: the sequence.
        by_tool: timing with the limits of their paths alone.
        retiming: the motion within the limits of the joints.
        robot: the arm.
    """
    moves, rules, retimed = achieved.moves, achieved.rules, retiming.retimed
    if not isinstance(retimed, RetimedTrajectory):
        return {}
    slow_moves = list(_slow(moves, retiming.timing, retimed, rules))
    if not slow_moves:
        return {}
    before = {one.move_number: (section, one, times) for section, one, times in _timed_spans(by_tool)}
    found, free = {}, _times_with_all_known(by_tool, rules)
    for slow in slow_moves:
        number = slow.span.move_number
        limits = moves[number].planned.limits.tool
        figures = _top(slow, retimed, limits), slow.span.length, turn_of(slow.span), slow.lost
        section, span, (begin, end) = before.get(number) or _timed(slow.section, (slow.span,))[0]
        joint = _slowest(slow, retiming.slowed)
        if free.get(number, end - begin) < SLOW * (end - begin):
            found[number] = ReachedSpeed(*figures, SpeedCause.LOOK_AHEAD)
        elif joint and slow.time - (end - begin) >= _BY_JOINTS * slow.lost:
            found[number] = ReachedSpeed(
                *figures,
                SpeedCause.JOINT,
                joint=robot.axis_joints[joint.joint].name,
                quantity=_QUANTITIES[joint.quantity],
                singularity=singularity_at(retiming, joint, robot),
            )
        else:
            found[number] = ReachedSpeed(*figures, *tool_cause(section, span, (begin, end), limits))
        if (via := len(moves[number].move.via)) and moves[number].move.kind == MotionKind.SPLINE:
            found[number] = replace(found[number], points=via + 1)
    lost = {
        cause: {number: one.lost for number, one in found.items() if one.cause is cause} for cause in _BY_PATH
    }
    helped = {
        number: _with_help(found[number], achieved, number, lost[found[number].cause])
        for number in _worst_by_line(moves, found)
    }
    return found | helped


def _worst_by_line(moves: Sequence[PlannedMove], found: Mapping[int, ReachedSpeed]) -> list[int]:
    """Return the moves that lose most on the worst lines or curves, for causes made by limits of the path."""
    alike: dict[tuple[Span | int | None, SpeedCause], list[int]] = {}
    for number, one in found.items():
        on_curve = moves[number].on_curve
        place = id(on_curve.curve) if on_curve else moves[number].move.origin.span
        if one.cause in _BY_PATH:
            alike.setdefault((place, one.cause), []).append(number)
    lost = sorted(((sum(found[one].lost for one in some), some) for some in alike.values()), reverse=True)
    worst = [some for whole, some in lost[:_MOST_LOOKED_AT] if whole >= _LEAST_LOST]
    return [max(some, key=lambda one: found[one].lost) for some in worst]


def _with_help(
    reached: ReachedSpeed, achieved: AchievedMotion, number: int, lost: Mapping[int, float]
) -> ReachedSpeed:
    """Return with a slow move what helps; between acceleration and jerk as causes that decides."""
    helps = helpful_limits(achieved, number, lost)
    ramps = {LimitQuantity.ACCELERATION: SpeedCause.ACCELERATION, LimitQuantity.JERK: SpeedCause.JERK}
    if helps and reached.cause in ramps.values():
        limits = achieved.moves[number].planned.limits.tool
        value = limits.jerk if helps[0] is LimitQuantity.JERK else limits.acceleration
        return replace(reached, cause=ramps[helps[0]], value=value, helps=helps)
    return replace(reached, helps=helps)


def _times_with_all_known(by_tool: Timing, rules: TimingRules) -> dict[int, float]:
    """Return the times of moves if the controller knew its path to the end [s]; none where it does."""
    moves = len(by_tool.ends)
    if moves <= rules.look_ahead.moves:
        return {}
    known = rules._replace(look_ahead=replace(rules.look_ahead, moves=moves))
    parts = [
        planned_section(part.path_segments, part.path_limits, part.counts, part.over, known)
        if part.has_path_limits
        else part
        for part in (section.part for section in by_tool.sections)
    ]
    timed = _timed_spans(timing_of(parts, moves))
    return {span.move_number: end - begin for _, span, (begin, end) in timed}


def singularity_at(retiming: Retiming, part: Slowed, robot: RobotModel) -> str:
    """Return the singularity that is near in the middle of a slowed part, see `near_singularity`."""
    middle = np.array([0.5 * (part.start + part.end)])
    return near_singularity(robot, retiming.motion.at(middle).q[0])


def _top(slow: _Slow, retimed: RetimedTrajectory, limits: ToolLimits) -> float:
    """Return the greatest speed on a move [m/s]."""
    first, last = retimed.clock.times_of(slow.phi).tolist()
    phi, rates, _ = retimed.clock.at(np.linspace(first, last, SAMPLES + 1))
    return min(float((slow.section.law.at(phi - slow.section.start).speeds * rates).max()), limits.speed)


def _spans(timing: Timing) -> Iterator[tuple[TimedSection, tuple[MoveOnSection, ...]]]:
    """Yield the moves along paths of the tool by sections."""
    for section in timing.sections:
        if spans := tuple(moves_on(section)):
            yield section, spans


def _timed_spans(timing: Timing) -> Iterator[_TimedSpan]:
    """Yield the moves along paths of the tool, with their times on their sections."""
    for section, spans in _spans(timing):
        yield from _timed(section, spans)


def _timed(section: TimedSection, spans: Sequence[MoveOnSection]) -> list[_TimedSpan]:
    """Return moves of a section with the times from its start on at which they begin and end [s]."""
    at = times_at(section, np.array([(one.start, one.end) for one in spans]).ravel()).tolist()
    return [(section, span, (begin, end)) for span, begin, end in zip(spans, at[::2], at[1::2], strict=True)]


def _slow(
    moves: Sequence[PlannedMove], timing: Timing, retimed: RetimedTrajectory, rules: TimingRules
) -> Iterator[_Slow]:
    """Yield the moves that take longer than their programmed speed lets expect."""
    for section, spans in _spans(timing):
        at = section.start + times_at(section, np.array([(one.start, one.end) for one in spans]).ravel())
        times = retimed.clock.times_of(at).reshape(-1, 2)
        taken = (times[:, 1] - times[:, 0]).tolist()
        expected = expected_times(spans, [moves[one.move_number].planned.limits.tool for one in spans], rules)
        phi = at.reshape(-1, 2).tolist()
        for span, (begin, end), time, most in zip(spans, phi, taken, expected, strict=True):
            if most < SLOW * time:
                yield _Slow(section, span, (begin, end), time, time - most)


def expected_times(
    spans: Sequence[MoveOnSection], limits: Sequence[ToolLimits], rules: TimingRules
) -> list[float]:
    """Return the times of moves on a section as on one straight line, without regard to joints [s].

    Args:
        spans: the moves, in order.
        limits: of the tool on each.
        rules: with the time law.
    """
    rows = [
        (span.length, most.speed, most.acceleration, most.jerk, 1.0, -1.0)
        for span, most in zip(spans, limits, strict=True)
    ]
    ends = rules.law(np.array(rows), np.ones(len(rows))).ends
    return list(np.diff(ends, prepend=0.0).tolist())


def _slowest(slow: _Slow, slowed: Sequence[Slowed]) -> Slowed | None:
    """Return the slowest part of a motion that lies on a move, None where joints do not slow it."""
    begin, end = slow.phi
    here = [one for one in slowed if one.start < end and one.end > begin]
    return min(here, key=lambda one: one.share, default=None)
