"""The manual of robot files: its example is right, and it names every key."""

import re

from ropsim.core import SourceText
from ropsim.dynamics import gravity
from ropsim.robotfile import read_robot_file
from support.manual import DOCS, blocks

PAGE = DOCS / "reference" / "robot-file.md"
MANUAL = PAGE.read_text("utf-8")
(EXAMPLE,) = [block.text for block in blocks(PAGE, "toml")]
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


def test_the_manual_names_every_key() -> None:
    asked = known_keys(f"{STRANGE}\n{EXAMPLE}")
    for before in ('{ name = "swivel"', "{ mass = 9", '{ kind = "dc"', '{ kind = "servo", ratio = 80'):
        assert before in EXAMPLE
        asked |= known_keys(EXAMPLE.replace(before, f"{before}, {STRANGE}"))
    for before in ("base = { ", "flange = { "):
        asked |= known_keys(EXAMPLE.replace(before, f"{before}{STRANGE}, "))
    asked |= known_keys(f"origins = [{{ {STRANGE} }}]\n{EXAMPLE}")
    assert {"convention", "limits", "com", "stiffness", "max_torque", "parameters", "flange"} <= asked
    assert [key for key in sorted(asked) if f"`{key}`" not in MANUAL] == []
