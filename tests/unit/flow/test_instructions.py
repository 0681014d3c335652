"""Moves that say more than where they end, as values."""

from dataclasses import replace

from ropsim.flow import (
    Comparison,
    Guard,
    ModalState,
    MotionKind,
    MoveInstruction,
    PostureRequest,
    Side,
    Trigger,
)
from ropsim.spatial import Pose, fingerprint

PLAIN = MoveInstruction(MotionKind.LIN, Pose(), ModalState())


def test_a_kind_of_motion_is_its_name_so_that_others_can_be_added() -> None:
    assert MotionKind.CIRC == "CIRC"
    assert f"{MotionKind.SPLINE}" == "SPLINE"
    assert replace(PLAIN, kind="HELIX").kind == "HELIX"


def test_each_addition_makes_another_move() -> None:
    others = [
        replace(PLAIN, via=(Pose(),)),
        replace(PLAIN, angle=1.0),
        replace(PLAIN, triggers=(Trigger("glue", True, Side.AFTER_START, distance=0.003),)),
        replace(PLAIN, triggers=(Trigger("glue", True, Side.BEFORE_END, distance=0.003),)),
        replace(PLAIN, triggers=(Trigger("glue", True, Side.AFTER_START, time=0.003),)),
        replace(PLAIN, guard=Guard("part_ok", Comparison.IS, value=True)),
        replace(PLAIN, guard=Guard("part_ok", Comparison.IS, value=True, timeout=2.0)),
        replace(PLAIN, guard=Guard("force_z", Comparison.ABOVE, 15.0)),
        replace(PLAIN, guard=Guard("force_z", Comparison.BELOW, 15.0)),
        replace(PLAIN, posture=PostureRequest(("left", "up"))),
        replace(PLAIN, posture=PostureRequest(turns=(0, -1))),
        replace(PLAIN, modal=ModalState(passes=True)),
    ]
    assert len({fingerprint(one) for one in (PLAIN, *others)}) == len(others) + 1
    assert len({PLAIN, *others}) == len(others) + 1
