"""Textbook linkages with one closed chain: a slider-crank and a four-bar."""

import numpy as np

from ropsim.model import BASE_LINK, Direction, Joint, JointType, Link, LoopCut, RobotModel
from ropsim.spatial import Pose

CRANK, ROD = 0.2, 0.7
ALONG_X = Pose(orientation=np.array([1.0, 0.0, 1.0, 0.0]))  # z of the joint points along x
IN_PLANE = (Direction.X, Direction.Y)


def at(x: float, y: float = 0.0) -> Pose:
    return Pose(np.array([x, y, 0.0]))


def joint(name: str, type_: JointType, placement: Pose, parent: int) -> Joint:
    return Joint(name, type_, placement, 0.0, -4.0, 4.0, 1.0, 1.0, 1.0, parent=parent)


def linkage(joints: tuple[Joint, ...], cut: LoopCut, home: float = 0.0) -> RobotModel:
    link = Link(1.0, np.zeros(3), np.eye(3))
    return RobotModel(
        "linkage", "linkage", joints, (link,) * len(joints), (), np.array([home]), axes=(0,), cuts=(cut,)
    )


SLIDER_CRANK = linkage(
    (
        joint("crank", JointType.REVOLUTE, Pose(), BASE_LINK),
        joint("rod", JointType.REVOLUTE, at(CRANK), 0),
        joint("slider", JointType.PRISMATIC, at(CRANK + ROD) @ ALONG_X, BASE_LINK),
    ),
    LoopCut(1, at(ROD), 2, Pose(), IN_PLANE),
)
GROUND, COUPLER, ROCKER = 0.9, 0.8, 0.6
FOUR_BAR = linkage(
    (
        joint("crank", JointType.REVOLUTE, Pose(), BASE_LINK),
        joint("coupler", JointType.REVOLUTE, at(CRANK), 0),
        joint(
            "rocker", JointType.REVOLUTE, at(GROUND) @ Pose(orientation=np.array([1.0, 0, 0, 1.0])), BASE_LINK
        ),
    ),
    LoopCut(1, at(COUPLER), 2, at(ROCKER), IN_PLANE),
)
