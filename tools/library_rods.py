"""The parallelogram of an arm whose axis 3 holds the forearm against the column: crank and rod.

Crank, lower arm, rear end of the forearm and rod: the crank is as long as that rear end and stays parallel to
the forearm, the rod is as long as the lower arm and stays parallel to it.
"""

from dataclasses import replace
from math import hypot, inf
from typing import Any

import numpy as np

from ropsim.kinematics import joint_frames
from ropsim.model import Coupling, JointLimits, JointType, Link, RobotModel, limited, rod
from ropsim.spatial import Array, Pose

_PASSIVE = JointLimits(-inf, inf, 10.0, 100.0, 1000.0)


def with_rod(robot: RobotModel, look: dict[str, Any], tones: list[str]) -> RobotModel:
    """Return an arm whose axis 3 is coupled with axis 2 by factor -1, with its crank and its rod as bodies.

    Args:
        robot: as a robot file describes it, its crank behind all other links.
        look: `crank`: length, `aside`: how far beside the lower arm along axis 2 [mm], `radii` of crank and
            rod, `tone`.
        tones: colours of the robot.
    """
    crank, aside = 1e-3 * look["crank"], 1e-3 * look["aside"]
    frames = joint_frames(robot, np.zeros(robot.n))
    wrist, elbow, shoulder, number = frames[3], frames[2], frames[1], len(robot.joints) - 1
    ahead = _unit(elbow[:3, :3].T @ wrist[:3, 2])  # of the forearm, in the frames of elbow and crank
    if float(ahead @ (elbow[:3, :3].T @ (wrist[:3, 3] - elbow[:3, 3]))) < 0.0:
        ahead = -ahead
    upper = elbow[:3, :3].T @ (elbow[:3, 3] - shoulder[:3, 3])
    beside = np.array([0.0, 0.0, aside])
    end = np.round(beside - crank * ahead, 9) + 0.0
    width, thin = (1e-3 * one for one in look["radii"])
    tone = tones[look["tone"]]
    bodies = list(robot.links)
    hub = np.array([0.0, 0.0, 1.2 * width])
    bodies[number] = replace(
        bodies[number],
        shapes=(
            rod(beside - hub, beside + hub, 1.2 * width, 1.2 * width, tone),
            rod(beside, end, width, width, tone),
        ),
    )
    pin = np.round(-crank * ahead, 9) + 0.0
    bodies[2] = replace(
        bodies[2],
        shapes=(
            *bodies[2].shapes,
            rod(np.zeros(3), pin, width, width, tone),
            rod(pin, end, 0.7 * width, 0.7 * width, tone),
        ),
    )
    top = np.round(upper, 9) + 0.0
    drawn = (rod(-hub, hub, width, width, tone), rod(np.zeros(3), top, thin, thin, tone))
    bodies.append(Link(0.0, np.zeros(3), np.zeros((3, 3)), drawn))
    hung = limited("rod", JointType.REVOLUTE, Pose(end), _PASSIVE, number)
    follows = Coupling(number + 1, ((1, 1.0), (number, -1.0)))
    return replace(
        robot, joints=(*robot.joints, hung), links=tuple(bodies), couplings=(*robot.couplings, follows)
    )


def _unit(vector: Array) -> Array:
    return np.asarray(vector / hypot(*vector.tolist()))
