"""Texts of robots in URDF for tests; those of published arms are made from `published_arms.toml`."""

from support.published_arms import TABLES

ARM = """<?xml version="1.0"?>
<robot name="arm">
  <material name="orange"><color rgba="1 0.5 0 0.5"/></material>
  <link name="base_link">
    <visual><geometry><cylinder radius="0.1" length="0.2"/></geometry><material name="orange"/></visual>
  </link>
  <link name="upper">
    <inertial>
      <origin xyz="0.1 0.2 0.3" rpy="0.3 -0.2 0.5"/>
      <mass value="4"/>
      <inertia ixx="0.05" ixy="0.01" ixz="0" iyy="0.06" iyz="0" izz="0.04"/>
    </inertial>
    <visual><origin xyz="0 0 0.2"/><geometry><box size="0.1 0.1 0.4"/></geometry></visual>
    <collision><geometry><sphere radius="0.3"/></geometry></collision>
  </link>
  <link name="camera">
    <inertial>
      <mass value="0.5"/><inertia ixx="1e-3" ixy="0" ixz="0" iyy="1e-3" iyz="0" izz="1e-3"/>
    </inertial>
    <visual><geometry><sphere radius="0.05"/></geometry></visual>
  </link>
  <link name="lower">
    <inertial><mass value="2"/><inertia ixx="0.02" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.01"/></inertial>
  </link>
  <link name="tool0"/>
  <link name="finger">
    <inertial>
      <mass value="0.1"/><inertia ixx="1e-4" ixy="0" ixz="0" iyy="1e-4" iyz="0" izz="1e-4"/>
    </inertial>
  </link>
  <joint name="shoulder" type="revolute">
    <origin xyz="0 0 0.3" rpy="0.1 0.2 0.3"/><parent link="base_link"/><child link="upper"/>
    <axis xyz="0 1 0"/>
    <limit lower="-2" upper="1.5" effort="100" velocity="2" acceleration="8" jerk="80"/>
    <dynamics damping="0.7" friction="0.3"/>
  </joint>
  <joint name="camera_mount" type="fixed">
    <origin xyz="0.1 0 0.1" rpy="0 0.5 0"/><parent link="upper"/><child link="camera"/>
  </joint>
  <joint name="slide" type="prismatic">
    <origin xyz="0 0 0.5"/><parent link="upper"/><child link="lower"/><axis xyz="1 2 2"/>
    <limit lower="0.1" upper="0.4" effort="0" velocity="0.5"/>
  </joint>
  <joint name="tool_mount" type="fixed">
    <origin xyz="0.3 0 0"/><parent link="lower"/><child link="tool0"/>
  </joint>
  <joint name="grip" type="prismatic">
    <origin xyz="0 0.1 0"/><parent link="lower"/><child link="finger"/><axis xyz="0 1 0"/>
    <limit lower="0.01" upper="0.05" effort="10" velocity="0.1"/>
  </joint>
</robot>
"""
"""Two joints with axes in any direction, a camera fixed to a link, a finger beside the tip."""


MACROS = """<?xml version="1.0"?>
<robot xmlns:xacro="http://wiki.ros.org/xacro">
  <xacro:property name="M_PI" value="3.14159265358979"/>
  <xacro:property name="length" value="${2*half}"/>
  <xacro:property name="half" value="0.25"/>
  <xacro:macro name="slat" params="name mass:=2 size:='${length} 0.1 0.1' *origin">
    <link name="${prefix}${name}">
      <inertial>
        <xacro:insert_block name="origin"/>
        <mass value="${mass}"/>
        <inertia ixx="${mass/12*(0.02)}" ixy="0" ixz="0" iyy="${mass/12*(length**2+0.01)}" iyz="0"
          izz="${mass/12*(length**2 + 0.01)}"/>
      </inertial>
      <visual><geometry><box size="${size}"/></geometry></visual>
      <xacro:if value="${meshes}">
        <visual><geometry><mesh filename="package://arm/${name}.stl"/></geometry></visual>
      </xacro:if>
    </link>
  </xacro:macro>
  <xacro:macro name="hinge" params="number parent child angle:=90 **in-side prefix:=^">
    <joint name="${prefix}joint_${number}" type="revolute">
      <parent link="${prefix}${parent}"/><child link="${prefix}${child}"/>
      <xacro:insert_block name="in-side"/>
      <xacro:property name="limit" value="${radians(angle)}"/>
      <limit lower="${-limit}" upper="${limit}" velocity="${M_PI / 2}" effort="10" acceleration="5"
        jerk="50"/>
    </joint>
  </xacro:macro>
  <xacro:macro name="arm" params="prefix meshes:=false">
    <link name="${prefix}base_link"/>
    <xacro:slat name="upper"><origin xyz="${half} 0 0"/></xacro:slat>
    <xacro:slat name="fore" mass="1.5"><origin xyz="${half} 0 0"/></xacro:slat>
    <xacro:hinge number="1" parent="base_link" child="upper">
      <in-side><origin xyz="0 0 1"/><axis xyz="0 1 0"/></in-side>
    </xacro:hinge>
    <xacro:hinge number="2" parent="upper" child="fore" angle="120">
      <in-side><origin xyz="${length} 0 0"/><axis xyz="0 1 0"/></in-side>
    </xacro:hinge>
    <xacro:unless value="$(arg bare)">
      <link name="${prefix}tool0"/>
      <joint name="${prefix}tool" type="fixed">
        <parent link="${prefix}fore"/><child link="${prefix}tool0"/><origin xyz="${length} 0 0"/>
      </joint>
    </xacro:unless>
  </xacro:macro>
</robot>
"""
"""Macros for an arm of two hinges, as robot files of ROS are written."""


SPELLINGS = """<robot name="words" xmlns:xacro="x">
  <xacro:arg name="side" default="left"/>
  <xacro:property name="links"
    value="${['base_link'] + ['%s_%d' % ('$(arg side)', k) for k in range(1, 3)]}"/>
  <xacro:property name="sizes" value="${dict(left='0.1 0.2 0.3', right='1 1 1')}"/>
  <xacro:property name="size" lazy_eval="false"
    value="${[2 * float(x) for x in sizes['$(arg side)'].split()]}"/>
  <xacro:property name="turn" value="$(optenv TURN 90)"/>
  <xacro:macro name="body" params="name *place parent:=^|none">
    <link name="${name}">
      <xacro:element xacro:name="${'visual' if name.startswith('left') else 'collision'}">
        <geometry><box><xacro:attribute name="size" value="${' '.join(map(str, size))}"/></box></geometry>
      </xacro:element>
    </link>
    <xacro:unless value="${parent is None or parent == 'none'}">
      <joint name="${parent[:4].upper()}_${name.split('_')[-1]}" type="revolute">
        <xacro:insert_block name="place"/>
        <parent link="${parent}"/><child link="${name}"/><axis xyz="0 ${1 if '1' in name else 0} 1"/>
        <limit lower="${-radians(turn)}" upper="${radians(turn)}" velocity="1" effort="$(eval 5 * 2)"/>
      </joint>
    </xacro:unless>
  </xacro:macro>
  <xacro:body name="${links[0]}"><origin/></xacro:body>
  <xacro:body name="${links[1]}" parent="${links[0]}"><origin xyz="0 0 ${size[-1]}"/></xacro:body>
  <xacro:property name="parent" value="${links[1]}"/>
  <xacro:call macro="body" name="${links[-1]}"><origin xyz="0 0 ${sum(size[1:])}"/></xacro:call>
  <xacro:property name="parent" remove="true"/>
  ${xacro.warning('no masses')}
</robot>
"""
"""Two joints; each construct of xacro that is a text method, a slice, a comprehension or a computed name."""


LIMITS = """# limits of an arm
joint_limits:
  shoulder_pan:
    has_velocity_limits: true
    max_position: !degrees  360.0   # of a file of Universal Robots
    min_position: !degrees -360
    turn: !radians pi / 2
  'elbow':
    max_position: 3.5
    name: "a: b # c"
---
list:
- 1
- x: 2
  y: [1, two, {k: 3}]
-
  - -4
empty:
nothing: ~
inline: { a: 1, b: 'x, y' }
"""
"""A parameter file with everything that is read of YAML."""


def published_urdf(name: str) -> str:
    """Return the URDF of a published arm: its chain only, one link behind each joint, `tool0` at the end."""
    table = TABLES[name]
    rows: list[tuple[str, str, list[float], list[float]]] = (
        [("base", "fixed", table["base"], [])] if "base" in table else []
    )
    rows += [(f"joint_{k}", "revolute", row, row[6:]) for k, row in enumerate(table["joints"], start=1)]
    rows += [(f"end_{k}", "fixed", row, []) for k, row in enumerate(table["tip"])]
    links = [f"l{k}" for k in range(len(rows))] + ["tool0"]
    text = "".join(f'<link name="{one}"/>' for one in links)
    for (joint, kind, row, more), parent, child in zip(rows, links, links[1:], strict=False):
        text += f'<joint name="{joint}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>'
        text += f'<origin xyz="{_words(row[:3])}" rpy="{_words(row[3:6])}"/>'
        if more:
            text += f'<axis xyz="{_words(more[:3])}"/><limit lower="{more[3]!r}" upper="{more[4]!r}" '
            text += 'velocity="3" effort="0"/>'
        text += "</joint>"
    return f'<robot name="{name}">{text}</robot>'


def _words(values: list[float]) -> str:
    return " ".join(repr(value) for value in values)
