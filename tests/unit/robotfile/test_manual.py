"""The manual of robot files: its example is right, and it names every key."""

import re

import numpy as np

from ropsim.core import SourceText
from ropsim.dynamics import gravity
from ropsim.kinematics import forward, loop_freedom
from ropsim.robotfile import read_robot_file
from support.manual import DOCS, blocks

PAGE = DOCS / "reference" / "robot-file.md"
MANUAL = PAGE.read_text("utf-8")
EXAMPLE, FIVE_BAR, SPRINGS = [block.text for block in blocks(PAGE, "toml")]
STRANGE = "qqqqqqqqqqqq = 1"


def known_keys(text: str) -> set[str]:
    """Return the keys that the finding of an unknown one lists."""
    findings = read_robot_file(SourceText("robots/arm.toml", text)).findings
    (found,) = [one for one in findings if one.code == "X802"]
    return set(re.findall(r"`(\w+)`", found.hint))


def test_the_example_of_the_manual_is_a_robot_with_dynamics() -> None:
    read = read_robot_file(SourceText("robots/arm.toml", EXAMPLE))
    assert read.findings == ()
    assert read.robot is not None
    assert [joint.name for joint in read.robot.joints] == ["swivel", "2", "3"]
    assert sum(link.mass for link in read.robot.links) == 20.0
    assert abs(gravity(read.robot, read.robot.home)[1]) > 10.0


def test_the_five_bar_of_the_manual_closes_and_moves() -> None:
    read = read_robot_file(SourceText("robots/five_bar.toml", FIVE_BAR))
    assert not any(one.is_error for one in read.findings)
    assert read.robot is not None
    assert loop_freedom(read.robot) == ()
    place = forward(read.robot, read.robot.home).position
    np.testing.assert_allclose(place, [0.05, 0.55, 0.0], atol=1e-9)


def test_the_springs_of_the_manual_are_fastened_to_the_example() -> None:
    read = read_robot_file(SourceText("robots/arm.toml", f"{EXAMPLE}\n{SPRINGS}"))
    assert read.findings == ()
    assert read.robot is not None
    (spring,), (on_joint,) = read.robot.springs, read.robot.joint_springs
    assert (spring.link_1, spring.link_2, spring.stiffness) == (-1, 1, 2e4)
    np.testing.assert_allclose(spring.free_length, 0.35)
    assert (on_joint.coordinate, on_joint.stiffness) == (2, 40.0)


def test_the_manual_names_every_key() -> None:
    asked = known_keys(f"{STRANGE}\n{EXAMPLE}")
    for before in ('{ name = "swivel"', "{ mass = 9", '{ kind = "dc"', '{ kind = "servo", ratio = 80'):
        assert before in EXAMPLE
        asked |= known_keys(EXAMPLE.replace(before, f"{before}, {STRANGE}"))
    for before in ("base = { ", "flange = { "):
        asked |= known_keys(EXAMPLE.replace(before, f"{before}{STRANGE}, "))
    asked |= known_keys(f"origins = [{{ {STRANGE} }}]\n{EXAMPLE}")
    asked |= known_keys(f"{STRANGE}\n{FIVE_BAR}")
    for before in ('{ name = "right"', 'first = { on = "left elbow"', '[flange]\non = "left elbow"'):
        assert before in FIVE_BAR
        more = f"\n{STRANGE}" if before.startswith("[") else f", {STRANGE}"
        asked |= known_keys(FIVE_BAR.replace(before, before + more))
    asked |= known_keys(f"{FIVE_BAR}{STRANGE}\n")
    screw = FIVE_BAR.replace('{ name = "right",', '{ name = "right", type = "screw", lead = 5,')
    asked |= known_keys(screw + STRANGE)
    for before in ('name = "balance"', 'first = { on = "base"', 'joint = "3"'):
        assert before in SPRINGS
        more = f", {STRANGE}" if "{" in before else f"\n{STRANGE}"
        asked |= known_keys(f"{EXAMPLE}\n{SPRINGS.replace(before, before + more)}")
    assert {"convention", "limits", "com", "stiffness", "max_torque", "parameters", "flange"} <= asked
    assert {"axes", "loops", "on", "holds", "follows", "springs", "free_length", "coordinate"} <= asked
    assert [key for key in sorted(asked) if f"`{key}`" not in MANUAL] == []
