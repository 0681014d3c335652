"""Arms whose axes are x, y or z of their base."""

from math import radians

import numpy as np

from ropsim.model import Joint, JointType, Link, RobotModel
from ropsim.spatial import Pose


def chain(
    axes: str, origins: tuple[tuple[float, ...], ...], limits: tuple[tuple[float, float], ...]
) -> RobotModel:
    """Return an arm whose axes are x, y or z of the base, at origins in the frame before [m], limits in °."""
    joints, before = [], np.eye(3)
    for number, (axis, origin, limit) in enumerate(zip(axes, origins, limits, strict=True), start=1):
        place = "xyz".index(axis)
        R = np.eye(3)[:, [(place + 1) % 3, (place + 2) % 3, place]]
        X = np.eye(4)
        X[:3, :3], X[:3, 3] = before.T @ R, before.T @ origin
        low, high = map(radians, limit)
        kind = JointType.REVOLUTE
        joints.append(Joint(str(number), kind, Pose.from_matrix(X), 0.0, low, high, 3.0, 10.0, 100.0))
        before = R
    massless = Link(0.0, np.zeros(3), np.zeros((3, 3)))
    end = np.eye(4)
    end[:3, :3] = before.T
    n = len(joints)
    X_nM = Pose.from_matrix(end)
    return RobotModel("chain", "chain", tuple(joints), (massless,) * n, (), np.zeros(n), X_nM=X_nM)


def random_chain(axes: str, seed: int, often: float = 1.0) -> RobotModel:
    """Return an arm with random origins, each coordinate of which is not 0 with a probability `often`."""
    rng = np.random.default_rng(seed)
    origins = rng.uniform(-0.4, 0.4, (len(axes), 3)) * (rng.random((len(axes), 3)) < often)
    return chain(axes, tuple(map(tuple, origins.tolist())), ((-170.0, 170.0),) * len(axes))
