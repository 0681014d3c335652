"""Texts of robots in MJCF for tests."""

import numpy as np

ARM = """<mujoco model="arm">
  <compiler angle="radian"/>
  <worldbody>
    <body name="a" pos="0 0 1">
      <joint name="j1" axis="0 1 0" range="-1 1" damping="0.1"/>
      <inertial pos="0 0 0.2" mass="2" diaginertia="0.1 0.1 0.1"/>
      <geom type="capsule" size="0.05 0.2" group="3"/>
      <geom type="box" size="0.1 0.2 0.3" rgba="0 0 1 0.5"/>
      <body name="b" pos="0 0 0.5">
        <joint name="j2" axis="1 0 0" range="-1 1"/>
        <inertial pos="0 0 0.1" mass="1" diaginertia="0.1 0.1 0.1"/>
        <site name="tcp" pos="0 0 0.3"/>
      </body>
    </body>
  </worldbody>
</mujoco>
"""
"""Two hinges, a geometry that is drawn and one that collides."""

HANDS = """
<mujoco model="hands">
  <compiler angle="{angle}" eulerseq="{order}"/>
  <option gravity="1 -2 -9"/>
  <default>
    <joint armature="0.2" damping="0.5"/>
    <geom density="500" rgba="1 0 0 1"/>
    <default class="heavy"><geom density="4000"/><joint armature="0.7" axis="0 1 0"/></default>
  </default>
  <worldbody>
    <light pos="0 0 3"/>
    <geom type="plane" size="1 1 1"/>
    <body name="pillar" pos="0 0 0.4" euler="10 20 30">
      <geom type="cylinder" size="0.1 0.2"/>
      <body name="upper" pos="0 0 0.2" axisangle="1 1 0 40" childclass="heavy">
        <joint name="shoulder" pos="0.05 0.02 -0.1" range="-90 80"/>
        <joint name="lift" type="slide" axis="1 0 1" range="-0.2 0.3" ref="0.1"/>
        <geom type="capsule" fromto="0 0 0 0.1 0.2 0.3" size="0.04"/>
        <geom type="box" size="0.1 0.05 0.02" pos="0.1 0 0" zaxis="1 2 3" mass="2"/>
        <frame pos="0.1 0.1 0.1" euler="0 30 0">
          <body name="fore" pos="0.2 0 0.1" xyaxes="0 1 0 -1 0 0.1">
            <joint name="elbow" class="main" axis="0.3 0 2" ref="20" range="-100 100" frictionloss="0.1"/>
            <inertial pos="0.01 0.02 0.03" euler="10 0 5" mass="1.5" diaginertia="0.02 0.03 0.04"/>
            <geom type="ellipsoid" size="0.1 0.05 0.03"/>
            <body name="hand" pos="0 0 0.3">
              <joint name="wrist" axis="1 0 0"/>
              <geom type="sphere" size="0.06" pos="0.01 0 0"/>
              <geom type="ellipsoid" size="0.1 0.05 0.03"/>
              <site name="flange" pos="0 0.1 0.05" quat="1 2 3 4"/>
            </body>
          </body>
        </frame>
      </body>
    </body>
  </worldbody>
  <equality><joint joint1="wrist" joint2="elbow" polycoef="0.1 0.5 0 0 0"/></equality>
  <actuator>
    <motor joint="elbow" ctrlrange="-5 6" gear="10"/>
    <position joint="shoulder" kp="100" forcerange="-70 70"/>
    <motor joint="lift"/>
  </actuator>
  <keyframe><key qpos="0.1 0.2 0.3 0.4"/></keyframe>
</mujoco>
"""
"""Everything that says an orientation or a weight; the unit and the order of angles are to be put in."""


def framed_chain(seed: int) -> str:
    """Return a chain of four bodies whose joints, weights, bodies and site stand in frames in each other."""
    rng = np.random.default_rng(seed)

    def place() -> str:
        turn = rng.choice(["quat", "euler", "axisangle", "zaxis"])
        numbers = {"quat": 4, "axisangle": 4}.get(turn, 3)
        return f'pos="{_row(rng, 3)}" {turn}="{_row(rng, numbers)}"'

    def framed(text: str) -> str:
        for _ in range(rng.integers(0, 3)):
            text = f"<frame {place()}>{text}</frame>"
        return text

    def joint(number: int) -> str:
        kind = rng.choice(["hinge", "slide"])
        axis = f'axis="{_row(rng, 3)}" pos="{_row(rng, 3)}"'
        return framed(f'<joint name="j{number}" type="{kind}" {axis} range="-4 4"/>')

    def inertial() -> str:
        return framed(f'<inertial {place()} mass="{rng.uniform(1.0, 2.0):.3f}" diaginertia="0.2 0.3 0.4"/>')

    inner = framed(f'<site name="tip" {place()}/>')
    for number in reversed(range(4)):
        joints = joint(2 * number) + (joint(2 * number + 1) if rng.random() < 0.4 else "")
        inner = framed(f"<body {place()}>{joints}{inertial()}{inner}</body>")
    return f'<mujoco><compiler angle="radian"/><worldbody>{inner}</worldbody></mujoco>'


def _row(rng: np.random.Generator, count: int) -> str:
    return " ".join(f"{value:.4f}" for value in rng.uniform(-1.0, 1.0, count))
