"""Names of xacro at the call of a macro: what its defaults see, and what it takes away."""

import pytest

from ropsim.core import SourceText
from ropsim.exchange import read_urdf
from ropsim.model import ReadRobot

FRAME = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
{before}
<xacro:macro name="arm" params="{params}">
<link name="tool0"><inertial><mass value="${{b}}"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>
</inertial></link>{inside}</xacro:macro>
<link name="base"/><xacro:arm {call}/>
<joint name="j" type="revolute"><parent link="base"/><child link="tool0"/><axis xyz="0 0 1"/>
<limit lower="-1" upper="1" velocity="1" effort="{effort}"/></joint></robot>"""


def read(params: str, call: str = "", before: str = "", inside: str = "", effort: str = "10") -> ReadRobot:
    return read_urdf(SourceText("arm.xacro", FRAME.format(**locals())))


def mass(found: ReadRobot) -> float:
    assert found.robot is not None, found.findings
    return float(found.robot.links[0].mass)


def property_(name: str, value: float) -> str:
    return f'<xacro:property name="{name}" value="{value}"/>'


def test_a_default_sees_the_properties_at_the_call_and_no_other_parameter() -> None:
    """`xacro` evaluates defaults by the symbols of the caller: `a` is 1 there, whatever the call passes."""
    assert mass(read("a b:=${10*a}", 'a="2"', property_("a", 1))) == 10.0
    found = read("a b:=${10*a}", 'a="2"')
    assert found.robot is None
    assert "nobody has defined `a`" in found.findings[0].message


@pytest.mark.parametrize(("before", "expected"), [(property_("b", 3), 3.0), ("", 5.0)])
def test_a_default_behind_a_roof_holds_where_the_caller_has_no_such_property(
    before: str, expected: float
) -> None:
    assert mass(read("b:=^|5", "", before)) == expected
    assert mass(read("b:=^|5", 'b="7"', before)) == 7.0


def test_a_property_that_a_macro_takes_away_is_gone_in_the_file() -> None:
    remove = '<xacro:property name="torque" remove="true"/>'
    assert read("b:=2", "", property_("torque", 30), "", "${torque}").robot is not None
    found = read("b:=2", "", property_("torque", 30), remove, "${torque}")
    assert found.robot is None
    assert "nobody has defined `torque`" in found.findings[0].message
