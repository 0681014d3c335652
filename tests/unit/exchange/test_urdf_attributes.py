"""Attributes and elements of URDF that are not read are losses with their names; known ones are none."""

import pytest

from ropsim.core import SourceText
from ropsim.exchange import read_urdf

TEXT = """<robot name="arm" version="1.2" xmlns:drake="x">
  <material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>
  <link name="base_link"/>
  <link name="hand" type="tool">
    <inertial><origin xyz="0 0 0.1" rpy="0 0 0"/><mass value="1"/>
      <inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial>
    <visual name="v"><origin xyz="0 0 0" quat_xyzw="0 0 0 1"/><geometry><box size="1 1 1"/></geometry>
      <material name="grey"/></visual>
  </link>
  <joint name="j" type="revolute"><parent link="base_link"/><child link="hand"/><origin xyz="0 0 1"/>
    <axis xyz="0 1 0" rpy="0 0 0"/><dynamics damping="0.1" friction="0.2"/>
    <limit lower="-1" upper="1" effort="100" velocity="1" acceleration="2" jerk="20"/></joint>
</robot>"""


Losses = dict[tuple[str, str], object]
"""Names by code and topic."""


def losses(*changes: tuple[str, str]) -> Losses:
    """Return the losses of the text with changes, beside the names of links that every file loses."""
    text = TEXT
    for old, new in changes:
        assert old in text
        text = text.replace(old, new, 1)
    found = read_urdf(SourceText("arm.urdf", text))
    assert found.robot is not None, found.findings
    lost = [one for one in found.findings if one.code in ("X993", "X994", "X995")]
    rows = {(one.code, topic): names for one in lost for topic, names in one.data.items()}
    assert rows.pop(("X995", "names of links"))
    return rows


def test_a_file_of_known_attributes_alone_loses_nothing() -> None:
    assert losses() == {}


@pytest.mark.parametrize(
    ("old", "new", "code", "name"),
    [
        ("<dynamics ", '<dynamics D="1" ', "X994", "dynamics/D"),
        ("<dynamics ", '<dynamics mu_coulomb="3" ', "X994", "dynamics/mu_coulomb"),
        ("<limit ", '<limit current="3" ', "X994", "limit/current"),
        ("<axis xyz", "<axis xyx", "X993", "axis/xyx"),
        ('iyz="0"', 'iyz="0" izx="1"', "X993", "inertia/izx"),
        ('rpy="0 0 0"', 'ryp="0 0 1"', "X993", "origin/ryp"),
        ('type="tool"', 'concave="yes"', "X995", "link/concave"),
        ("<box ", '<box colour="red" ', "X995", "box/colour"),
        ('"grey"><', '"grey" shine="1"><', "X995", "material/shine"),
    ],
)
def test_an_attribute_that_is_not_read_is_named(old: str, new: str, code: str, name: str) -> None:
    assert losses((old, new)) == {(code, "attributes"): (name,)}


def test_elements_of_links_and_joints_that_are_not_read_are_named_once_for_each_kind() -> None:
    assert losses(
        ("<visual ", '<contact><lateral_friction value="1"/></contact><contact/><visual '),
        ("<axis ", '<joint_properties damping="1"/><axis '),
    ) == {("X995", "elements of links"): ("contact",), ("X994", "elements of joints"): ("joint_properties",)}


def test_a_multiplier_that_is_misspelt_is_a_loss_of_motion() -> None:
    finger = (
        '<link name="finger"/><joint name="f" type="continuous"><parent link="hand"/><child link="finger"/>'
        '<mimic joint="j" multiplyer="2"/></joint></robot>'
    )
    assert losses(("</robot>", finger))["X993", "attributes"] == ("mimic/multiplyer",)
