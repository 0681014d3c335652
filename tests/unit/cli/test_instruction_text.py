"""One line for each instruction of a program that is run without a robot."""

from ropsim.cli.testing import instruction_text
from ropsim.flow import ModalState, MotionKind, MoveInstruction, Side, Trigger
from ropsim.spatial import Pose


def test_a_move_tells_the_values_of_external_axes_that_it_is_given() -> None:
    pose = Pose.from_tuple((0.8, 0.7, 0.91, 0.0, 1.0, 0.0, 0.0))
    plain = instruction_text(MoveInstruction(MotionKind.PTP, pose, ModalState()))
    given = instruction_text(MoveInstruction(MotionKind.PTP, pose, ModalState(), external=(0.8, -1.5)))
    assert plain.endswith("PTP x 800.000 y 700.000 z 910.000 mm, roll 180.00 pitch 0.00 yaw 0.00 deg")
    assert given == plain + " external (0.8, -1.5)"


def test_a_move_tells_its_way() -> None:
    pose = Pose.from_tuple((0.8, 0.7, 0.91, 0.0, 1.0, 0.0, 0.0))
    triggers = (
        Trigger("glue", True, Side.AFTER_START, distance=0.003),
        Trigger("rate", 2.5, Side.BEFORE_END, time=0.2),
    )
    modal = ModalState(passes=True)
    move = MoveInstruction(MotionKind.CIRC, pose, modal, via=(pose,), angle=3.5, triggers=triggers)
    plain = instruction_text(MoveInstruction(MotionKind.CIRC, pose, ModalState()))
    assert instruction_text(move) == (
        plain + " passing by via x 800.000 y 700.000 z 910.000 mm angle 200.54 deg"
        " at 3 mm after start set glue = True at 0.2 s before end set rate = 2.5"
    )
