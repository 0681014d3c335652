"""Arms from facts that are no DH table, tools/library/chains/NAME.toml: axes and offsets of a straight chain.

Where all coordinates are 0 the frames of the links are parallel to the base: x ahead, z up. Each joint turns
about the z or the y axis there; masses, centres and inertias of its link are in these axes too.
"""

import tomllib
from math import radians
from pathlib import Path
from typing import Any

import numpy as np

from ropsim.model import (
    Drive,
    EffortAmplifier,
    ElasticGear,
    Friction,
    Gear,
    IdealMotor,
    Joint,
    JointType,
    Link,
    ParameterOrigin,
    RobotModel,
    Transmission,
)
from ropsim.spatial import Array, Pose, frozen

_TURNED = {"z": np.eye(3), "y": np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])}
"""Axes of a joint frame in those of the base, by the axis that it turns about."""
_STEEPER = 10.0
"""Jerk over acceleration [1/s]: as in robot files."""


def chain(path: Path) -> RobotModel:
    """Return the arm of a file of facts; its interface is the last frame, z along the last axis."""
    facts: dict[str, Any] = tomllib.loads(path.read_text("utf-8"))
    rows = facts["joints"]
    turned = [_TURNED[row["axis"]] for row in rows]
    before = [np.eye(3), *turned[:-1]]
    return RobotModel(
        name=path.stem,
        title=facts["title"],
        joints=tuple(
            _joint(str(number), row, R_before, R)
            for number, (row, R_before, R) in enumerate(zip(rows, before, turned, strict=True), start=1)
        ),
        links=tuple(_link(row, R) for row, R in zip(rows, turned, strict=True)),
        drives=tuple(_drive(row["drive"]) for row in rows),
        home=frozen([radians(one) for one in facts["home"]]),
        origins=tuple(ParameterOrigin(**one) for one in facts["origins"]),
        rated_payload=float(facts["payload"]),
    )


def _joint(name: str, row: dict[str, Any], R_before: Array, R: Array) -> Joint:
    X = np.eye(4)
    X[:3, :3] = R_before.T @ R
    X[:3, 3] = R_before.T @ (1e-3 * np.array(row["offset"]))
    lower, upper = map(radians, row["limits"])
    speed, acceleration = float(row["speed"]), float(row["acceleration"])
    motion = speed, acceleration, _STEEPER * acceleration
    most = abs(row["drive"]["ratio"]) * float(row["drive"]["max_torque"])
    return Joint(name, JointType.REVOLUTE, Pose.from_matrix(X), 0.0, lower, upper, *motion, max_effort=most)


def _link(row: dict[str, Any], R: Array) -> Link:
    xx, yy, zz, xy, xz, yz = row["inertia"]
    tensor = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    return Link(float(row["mass"]), R.T @ (1e-3 * np.array(row["com"])), R.T @ tensor @ R)


def _drive(row: dict[str, float]) -> Drive:
    """Return a drive: friction at the motor or at the joint; torque limit, spring and damper at the motor."""
    ratio = row["ratio"]
    viscous = row.get("viscous", row.get("viscous_at_joint", 0.0) / ratio**2)
    dry = row.get("coulomb", row.get("coulomb_at_joint", 0.0) / abs(ratio))
    motor = IdealMotor(row["rotor_inertia"])
    gear: Transmission = Gear(ratio)
    if "stiffness" in row:
        gear = ElasticGear(ratio, row["stiffness"] * ratio**2, row["damping"] * ratio**2)
    return Drive(EffortAmplifier(row["max_torque"]), motor, gear, Friction(viscous, dry, -dry))
