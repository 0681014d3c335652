"""What Python prints of a project, its cell, robot, recording and answers: one line each, without arrays."""

from pathlib import Path

import ropsim
from ropsim import kinematics, robots

FIRST_CELL = Path(__file__).parents[3] / "examples" / "first_cell"
LONGEST = 200


def test_each_of_them_says_in_one_line_what_it_is() -> None:
    project = ropsim.open(FIRST_CELL)
    robot = robots.load("puma560")
    answers = kinematics.inverse(robot, kinematics.forward(robot, robot.home))
    told = [repr(one) for one in (robot, project.cell, answers)]
    assert told == [
        "<RobotModel puma560: Unimation PUMA 560, 6 axes>",
        "<Cell first_cell: robot (puma560), 2 locations, 1 part>",
        "<IkResult found: 8 postures of the arm, within its limits left-up-flip; right-up-noflip>",
    ]
    assert repr(project).endswith(f": {project.cell!r}, programs main>")


def test_a_channel_says_what_it_is_its_unit_and_how_much_there_is() -> None:
    channels = ropsim.open(FIRST_CELL).simulate().channels
    assert repr(channels["tau"]).startswith(
        "<Channel torque of the drive at the joint, before friction [N·m]: "
    )
    assert repr(channels["tau"]).endswith(" × 6>")
    assert repr(channels["line"]).endswith(" changes>")
    assert max(len(repr(one)) for one in channels.values()) < LONGEST
