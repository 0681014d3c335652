"""Legs of moves in order, as far as they can be made, each from where the one before ends."""

from collections.abc import Sequence

from ropsim.controller.entities import Refusal
from ropsim.controller.leg import Leg, leg_of
from ropsim.controller.line_legs import line_legs_of
from ropsim.controller.motion_chain import MotionChain
from ropsim.controller.ptp_legs import ptp_legs_of
from ropsim.flow import MoveInstruction
from ropsim.spatial import Array


def legs_in_order(
    chain: MotionChain, moves: Sequence[MoveInstruction], q_start: Array
) -> tuple[list[Leg], Refusal | None]:
    """Return the legs of moves up to the first one that cannot be made, and why it cannot.

    Args:
        chain: the entities.
        moves: in order.
        q_start: command joint coordinates at their start [rad | m], shape (n,).
    """
    lines, joints, legs, q = line_legs_of(chain), ptp_legs_of(chain), list[Leg](), q_start
    while len(legs) < len(moves):
        led = joints.legs(moves, len(legs), q) if joints else []
        if not led and lines:
            led = lines.legs(moves, len(legs), q)
        if not led:
            leg = leg_of(chain, moves[len(legs)], q)
            if isinstance(leg, Refusal):
                return legs, leg
            led = [leg]
        legs += led
        q = legs[-1].q_end
    return legs, None
