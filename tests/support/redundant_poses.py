"""Redundant arms, and configurations of them that are awkward: at limits and near to singular ones."""

from dataclasses import replace
from math import pi

import numpy as np
from scipy.optimize import minimize

from ropsim.kinematics import jacobian
from ropsim.model import RobotModel
from ropsim.robots import load
from ropsim.spatial import Array
from support.arms import random_arm
from support.published_arms import SEVEN_AXES, published_arm

LIBRARY = ("iiwa14", "panda")
RANDOM = 4
NARROW = 6


def seven_axis_arms() -> dict[str, RobotModel]:
    """Return arms with seven turning joints: of the library, published ones, and random ones."""
    arms = [load(name) for name in LIBRARY]
    arms += [published_arm(name) for name in ("motoman_sia20d", "kuka_lbr_iiwa_14_r820", *SEVEN_AXES)]
    arms += [replace(random_arm(seed, "RRRRRRR"), name=f"random {seed}") for seed in range(RANDOM)]
    arms += [
        narrowed(replace(random_arm(seed, "RRRRRRR"), name=f"narrow {seed}"), seed) for seed in range(NARROW)
    ]
    return {arm.name: arm for arm in arms}


def narrowed(robot: RobotModel, seed: int) -> RobotModel:
    """Return an arm whose joints have 0.1 to 2.4 rad between their limits, somewhere."""
    rng = np.random.default_rng(seed)
    middle, half = rng.uniform(-2.5, 2.5, robot.n), rng.uniform(0.05, 1.2, robot.n)
    rows = zip(robot.joints, middle - half, middle + half, strict=True)
    joints = tuple(replace(joint, lower=float(low), upper=float(high)) for joint, low, high in rows)
    return replace(robot, joints=joints)


def awkward_joints(robot: RobotModel, count: int, seed: int) -> Array:
    """Return configurations within the limits, shape (count, n).

    Half of them are spread evenly, a quarter has some joints at limits or within 1e-6 rad of them, and a
    quarter is next to a singular configuration, at distances of 1e-9 to 0.1 rad.
    """
    rng = np.random.default_rng(seed)
    lower, upper = np.maximum(robot.lower_limits, -pi), np.minimum(robot.upper_limits, pi)
    limited, singular = count // 4, count // 4
    shape = limited, robot.n
    away = 10.0 ** rng.uniform(-12.0, -6.0, shape) * (rng.random(shape) < 0.5)
    at = np.where(rng.random(shape) < 0.5, robot.lower_limits + away, robot.upper_limits - away)
    held = rng.random(shape) < rng.uniform(0.1, 0.9, (limited, 1))
    return np.concatenate(
        (
            rng.uniform(lower, upper, (count - limited - singular, robot.n)),
            np.where(held, at, rng.uniform(lower, upper, shape)),
            *(_singular(robot, (lower, upper), rng)[np.newaxis] for _ in range(singular)),
        )
    )


def _singular(robot: RobotModel, limits: tuple[Array, Array], rng: np.random.Generator) -> Array:
    """Return a configuration next to one with a small least singular value of the Jacobian, shape (n,)."""

    def least(q: Array) -> float:
        return float(np.linalg.svd(jacobian(robot, q), compute_uv=False)[-1]) ** 2

    begin, way = rng.uniform(*limits), rng.normal(size=robot.n)
    bounds = list(zip(*limits, strict=True))
    found = minimize(least, begin, bounds=bounds, method="L-BFGS-B", options={"maxiter": 40}).x
    step = 10.0 ** rng.uniform(-9.0, -1.0) / np.linalg.norm(way)
    return np.asarray(np.clip(found + step * way, *limits))
