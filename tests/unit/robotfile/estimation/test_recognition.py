"""The class of an arm: as its file says, else by its axes."""

from dataclasses import replace

import pytest

from ropsim import robots
from ropsim.core import SourceText
from ropsim.model import ArmClass
from ropsim.robotfile import read_robot_file, write_robot_file
from ropsim.robotfile.testing import arm_class_of


@pytest.mark.parametrize(
    ("name", "arm_class"),
    [
        ("irb120", ArmClass.INDUSTRIAL),
        ("m10ia_12", ArmClass.INDUSTRIAL),
        ("stanford", ArmClass.INDUSTRIAL),
        ("two_link", ArmClass.INDUSTRIAL),
        ("ur3e", ArmClass.COBOT),
        ("panda", ArmClass.SEVEN_AXIS),
        ("iiwa14", ArmClass.SEVEN_AXIS),
        ("cobra600", ArmClass.SCARA),
        ("scara", ArmClass.SCARA),
        ("irb660_180_315", ArmClass.PALLETIZER),
        ("palletizer", ArmClass.PALLETIZER),
    ],
)
def test_axes_say_the_class_of_an_arm(name: str, arm_class: ArmClass) -> None:
    assert arm_class_of(robots.load(name)) is arm_class


def test_an_arm_that_says_its_class_has_it() -> None:
    """A CRX has the axes of an industrial arm."""
    robot = replace(robots.load("irb120"), arm_class=ArmClass.COBOT)
    assert arm_class_of(robot) is ArmClass.COBOT


def test_a_robot_file_says_the_class_and_keeps_it() -> None:
    text = write_robot_file(replace(robots.load("irb120"), arm_class=ArmClass.COBOT)).text
    assert 'class = "cobot"' in text
    robot = read_robot_file(SourceText("a.toml", text)).robot
    assert robot is not None
    assert robot.arm_class is ArmClass.COBOT


def test_a_robot_file_without_a_class_has_none() -> None:
    text = write_robot_file(robots.load("irb120")).text
    assert "class =" not in text


def test_an_unknown_class_is_a_finding_with_those_that_are_allowed() -> None:
    text = write_robot_file(robots.load("irb120")).text.replace("convention", 'class = "cobott"\nconvention')
    (found,) = read_robot_file(SourceText("a.toml", text)).findings
    assert found.is_error
    assert "industrial" in f"{found.message} {found.hint}"
    assert found.span
    assert found.span.line == text[: text.index("class =")].count("\n") + 1


def test_the_class_decides_how_the_mass_is_shared() -> None:
    row = "{ limits = [-90, 90], a = 300, alpha = 0 }"
    text = f'convention = "standard"\ntotal_mass = 40\njoints = [{", ".join([row] * 6)}]\n'
    shares = {}
    for name in ("industrial", "cobot"):
        robot = read_robot_file(SourceText("a.toml", f'class = "{name}"\n{text}')).robot
        assert robot is not None
        shares[name] = [link.mass for link in robot.links]
    assert sum(shares["industrial"]) == pytest.approx(0.71 * 40.0)
    assert sum(shares["cobot"]) == pytest.approx(0.855 * 40.0)
    assert shares["cobot"][5] > 3.0 * shares["industrial"][5]
