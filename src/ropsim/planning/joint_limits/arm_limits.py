"""Joint limits of a motion: capabilities of the arm with its payload, and findings where they bind."""

from bisect import bisect_right
from collections.abc import Callable, Sequence
from functools import lru_cache

from ropsim.core import Diagnostic
from ropsim.dynamics import effort_limits, effort_rows, with_rigid_gears
from ropsim.model import Joint, JointType, Payload, RobotModel
from ropsim.motion import (
    BEYOND_LIMITS,
    SINGULARITY_HINTS,
    SLOWED,
    Effort,
    Infeasible,
    JointBounds,
    Quantity,
    Slowed,
)
from ropsim.planning.moves.planned_move import PlannedMove
from ropsim.planning.records.entities import Refusal
from ropsim.planning.records.wording import passes, rate
from ropsim.spatial import record

WORTH_SAYING = 0.8
"""Share of the planned speed above which slowing is not reported: it costs almost no time."""

_WORDS = {
    Quantity.SPEED: ("speed", "/s"),
    Quantity.ACCELERATION: ("acceleration", "/s²"),
    Quantity.JERK: ("jerk", "/s³"),
    Quantity.TORQUE: ("torque", ""),
}


@record
class ArmBounds:
    """Capabilities of the joints of an arm.

    Attributes:
        joints: speed, acceleration, jerk, and torque where drives say it.
        effort: torques that a motion takes with the payload in force; None where they do not count.
    """

    joints: JointBounds
    effort: Effort | None


@lru_cache(maxsize=256)
def arm_bounds(robot: RobotModel, payload: Payload) -> ArmBounds:
    """Return the capabilities of an arm; torque counts where masses and drives of all joints are known.

    Args:
        robot: the arm.
        payload: tool and part as one body, for the whole motion.
    """
    limits = robot.max_speeds, robot.max_accelerations, robot.max_jerks
    if len(robot.drives) != robot.n:
        return ArmBounds(JointBounds(*limits), None)
    moved = with_rigid_gears(robot)  # motors behind springs have to move their rotors, too
    return ArmBounds(JointBounds(*limits, effort_limits(moved)), effort_rows(moved, payload))


def slowed_findings(
    moves: Sequence[PlannedMove],
    ends: Sequence[float],
    slowed: Sequence[Slowed],
    robot: RobotModel,
    singularity: Callable[[Slowed], str],
) -> tuple[Diagnostic, ...]:
    """Return M563 for each move that is slowed, where it is slowest.

    Args:
        moves: the moves.
        ends: nominal times at which they end [s].
        slowed: the parts of the motion that are slower than planned.
        robot: the arm.
        singularity: returns which one is near on such a part, empty for none.
    """
    worst: dict[int, Slowed] = {}
    for part in slowed:
        move = move_at(ends, 0.5 * (part.start + part.end))
        if move not in worst or part.share < worst[move].share:
            worst[move] = part
    return tuple(
        _slowed(
            moves[move],
            part,
            robot.axis_joints[part.joint],
            (ends[move - 1] if move else 0.0, ends[move]),
            singularity(part) if moves[move].tool is not None else "",
        )
        for move, part in sorted(worst.items())
        if part.share < WORTH_SAYING
    )


def beyond_refusal(move: PlannedMove, beyond: Infeasible, robot: RobotModel) -> Refusal:
    """Return M564 for a move that exceeds the capability of a joint at any speed."""
    joint, origin = robot.axis_joints[beyond.joint], move.move.origin
    finding = BEYOND_LIMITS.at(
        origin.span,
        f"joint `{joint.name}` would need a {_WORDS[beyond.quantity][0]} of "
        f"{_figure(joint, beyond.quantity, beyond.value)}, the limit is "
        f"{_figure(joint, beyond.quantity, beyond.limit)}, however slow the move is",
        label=passes(origin),
        hint="bring the load nearer to the axis of the joint, or take a lighter one",
        data={"joint": joint.name, "value": beyond.value, "limit": beyond.limit, **origin.data},
    )
    return Refusal((finding,))


def move_at(ends: Sequence[float], phi: float) -> int:
    """Return the number of the move that goes on at a nominal time [s].

    Args:
        ends: nominal times at which the moves end [s].
        phi: nominal time [s].
    """
    return min(bisect_right(ends, phi), len(ends) - 1)


def _slowed(
    move: PlannedMove, part: Slowed, joint: Joint, times: tuple[float, float], singularity: str
) -> Diagnostic:
    start, end = times
    progress = (0.5 * (part.start + part.end) - start) / max(end - start, 1e-300)
    progress, origin = min(max(progress, 0.0), 1.0), move.move.origin
    return SLOWED.at(
        origin.span,
        f"slowed down to {part.share:.0%} of the planned speed at {progress:.0%} of the planned duration: "
        f"joint `{joint.name}` is at its {_WORDS[part.quantity][0]} limit"
        + (f", near the singularity of the {singularity}" if singularity else ""),
        label=passes(origin),
        hint=SINGULARITY_HINTS.get(
            singularity,
            "another posture may need less of the joint; a lower speed of the whole move may be quicker",
        ),
        data={
            "joint": joint.name,
            "share": part.share,
            "place": progress,
            "singularity": singularity,
            **origin.data,
        },
    )


def _figure(joint: Joint, quantity: Quantity, value: float) -> str:
    if quantity is Quantity.TORQUE:
        return f"{value:.4g} {'N·m' if joint.measure is JointType.REVOLUTE else 'N'}"
    return rate(joint, value, _WORDS[quantity][1])
