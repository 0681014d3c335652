"""Moves that a sensor corrects: which of them can be, and what of the joints is left for the correction."""

from dataclasses import replace

from ropsim.controller.correction_room import PLANNED_ACCELERATION, PLANNED_SPEED
from ropsim.controller.entities import Refusal
from ropsim.controller.kept_limits import ArmBounds
from ropsim.controller.leg import Leg
from ropsim.controller.wording import passes
from ropsim.motion import PATH_NOT_CORRECTED


def correction_refusal(leg: Leg) -> Refusal | None:
    """Return M587 for a move that a sensor is to correct and cannot."""
    move, planned = leg.move, leg.planned
    if move.tracking is None or leg.joints is None:
        return None
    if planned.tool is None:
        why = "it has no path of the tool"
    elif planned.coordination is not None:
        why = "external axes go along with it"
    else:
        return None
    finding = PATH_NOT_CORRECTED.at(
        move.origin.span,
        f"signal `{move.tracking.channel}` cannot correct this path: {why}",
        label=passes(move.origin),
        hint="move the external axes before, and leave them where they are on this move",
        data={"channel": move.tracking.channel, "pass": move.origin.visit},
    )
    return Refusal((finding,))


def beside_correction(bounds: ArmBounds) -> ArmBounds:
    """Return what the joints may do for a move itself, where a correction is added to it."""
    joints = bounds.joints
    speed, acceleration = joints.speed * PLANNED_SPEED, joints.acceleration * PLANNED_ACCELERATION
    kept = replace(joints, speed=speed, acceleration=acceleration)
    return replace(bounds, joints=kept)
