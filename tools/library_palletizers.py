"""Palletizers of makers from facts, tools/library/palletizers/NAME.toml: parallelograms as exact couplings.

Coordinates as makers count them: axis 2 is the lean of the lower arm, 0 upright and positive forwards; axis 3
the forearm, 0 level and positive downwards, whatever axis 2 does, for a crank and a rod beside the lower arm
hold it; two more parallelograms over a triangle at the elbow keep the wrist level. Bodies of rods are where
they are, so a parallelogram that would not close is seen; masses and drives are not published.
"""

import tomllib
from math import radians
from pathlib import Path
from typing import Any

import numpy as np
from tools.palletizer_looks import Lengths, base_shapes, link_shapes

from ropsim.model import (
    BASE_LINK,
    Coupling,
    Joint,
    JointLimits,
    JointType,
    Link,
    OriginKind,
    ParameterOrigin,
    RobotModel,
    Shape,
    limited,
)
from ropsim.spatial import Array, Pose, frozen

TURN, ARM, CRANK, ELBOW, ROD, WRIST, TRIANGLE, LOW_LINK, HIGH_LINK, FLANGE = range(10)
NAMES = ("1", "2", "3", "elbow", "rod", "wrist", "triangle", "lower link", "upper link", "4")
_COUPLINGS = (
    Coupling(ELBOW, ((CRANK, 1.0), (ARM, -1.0))),  # forearm parallel to the crank
    Coupling(ROD, ((ARM, 1.0), (CRANK, -1.0))),  # rod parallel to the lower arm
    Coupling(WRIST, ((CRANK, -1.0),)),  # level
    Coupling(TRIANGLE, ((ARM, -1.0),)),  # level
    Coupling(LOW_LINK, ((ARM, 1.0),)),  # parallel to the lower arm
    Coupling(HIGH_LINK, ((CRANK, 1.0),)),  # parallel to the forearm
)
_PASSIVE = JointLimits(-2.0 * np.pi, 2.0 * np.pi, 10.0, 100.0, 1000.0)
_UP = np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]])  # x up, z to the left side
_AHEAD = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])  # x ahead, z to the left side
_RISE, _STEEPER = 4.0, 10.0  # acceleration over speed, jerk over acceleration [1/s]: as in robot files
_ESTIMATED = (
    ParameterOrigin("home position", OriginKind.ESTIMATED, "lower arm upright, forearm a little down"),
    ParameterOrigin(
        "joint accelerations and jerks",
        OriginKind.ESTIMATED,
        "full speed within 0.25 s; full acceleration within 0.1 s",
    ),
    ParameterOrigin("crank, rods and drawn shapes", OriginKind.ESTIMATED, "by eye around the link lengths"),
)


def palletizer(path: Path) -> RobotModel:
    """Return the robot of a file of facts."""
    facts: dict[str, Any] = tomllib.loads(path.read_text("utf-8"))
    lengths = Lengths(**{key: 1e-3 * value for key, value in facts["lengths"].items()})
    shapes: list[tuple[Shape, ...]] = link_shapes(lengths, facts["tones"])
    return RobotModel(
        name=path.stem,
        title=facts["title"],
        joints=_joints(lengths, facts),
        links=tuple(Link(0.0, np.zeros(3), np.zeros((3, 3)), one) for one in shapes),
        drives=(),
        home=frozen([radians(one) for one in facts["home"]]),
        axes=(TURN, ARM, CRANK, FLANGE),
        couplings=_COUPLINGS,
        origins=(*(ParameterOrigin(**one) for one in facts["origins"]), *_ESTIMATED),
        base_shapes=base_shapes(lengths, facts["tones"]),
        X_nM=Pose(np.array([0.0, 0.0, lengths.flange])),
        tip=FLANGE,
        rated_payload=float(facts["payload"]),
    )


def _joints(lengths: Lengths, facts: dict[str, Any]) -> tuple[Joint, ...]:
    shoulder = (lengths.ahead, 0.0, lengths.height)
    pin_x, pin_z = lengths.pin
    places = {
        TURN: (BASE_LINK, _pose((0.0, 0.0, 0.0), np.eye(3))),
        ARM: (TURN, _pose(shoulder, _UP)),
        CRANK: (TURN, _pose(shoulder, _AHEAD)),
        ELBOW: (ARM, _pose((lengths.lower_arm, 0.0, 0.0), _about_z(90.0))),
        ROD: (CRANK, _pose((-lengths.crank, 0.0, 0.0), _about_z(-90.0))),
        WRIST: (ELBOW, _pose((lengths.forearm, 0.0, 0.0), np.eye(3))),
        TRIANGLE: (ARM, _pose((lengths.lower_arm, 0.0, 0.0), _about_z(90.0))),
        LOW_LINK: (TURN, _pose((lengths.ahead + pin_x, 0.0, lengths.height + pin_z), _UP)),
        HIGH_LINK: (TRIANGLE, _pose((pin_x, -pin_z, 0.0), np.eye(3))),
        FLANGE: (WRIST, _pose((lengths.wrist, 0.0, 0.0), _AHEAD @ _about_z(180.0))),
    }
    limits = {
        axis: _limits(*map(radians, (*between, speed)))
        for axis, between, speed in zip(
            (TURN, ARM, CRANK, FLANGE), facts["limits"], facts["speeds"], strict=True
        )
    }
    lower, upper = map(radians, facts["elbow"])
    limits[ELBOW] = JointLimits(lower, upper, 10.0, 100.0, 1000.0)
    return tuple(
        limited(NAMES[one], JointType.REVOLUTE, X, limits.get(one, _PASSIVE), parent)
        for one, (parent, X) in sorted(places.items())
    )


def _limits(lower: float, upper: float, speed: float) -> JointLimits:
    return JointLimits(lower, upper, speed, _RISE * speed, _RISE * _STEEPER * speed)


def _pose(position: tuple[float, float, float], rotation: Array) -> Pose:
    X = np.eye(4)
    X[:3, :3], X[:3, 3] = rotation, position
    return Pose.from_matrix(X)


def _about_z(angle: float) -> Array:
    c, s = round(np.cos(radians(angle)), 12), round(np.sin(radians(angle)), 12)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
