"""Words on limits, reach and singularities for jogging an arm."""

from collections.abc import Iterable
from math import degrees, radians
from typing import TypeAlias

import numpy as np

from ropsim.kinematics import (
    IkResult,
    Shortfall,
    branch,
    jacobian,
    limit_violations,
    posture,
    singular_distances,
)
from ropsim.model import Joint, JointType, RobotModel, coupled_limits
from ropsim.spatial import Array
from ropsim.studio.wire.jobs import Level

Words: TypeAlias = list[tuple[Level, str]]
"""Pairs of a level and a text."""

LEVELS: tuple[Level, ...] = ("error", "warning", "info")

AT_LIMIT = 1e-6
"""A coordinate this near to its limit is at it [rad | m]."""

NEAR_LIMIT = {JointType.REVOLUTE: radians(5.0), JointType.PRISMATIC: 0.02}
"""From here on a limit is mentioned [rad | m]."""

NEAR_ANGLE, TIGHT_ANGLE = radians(10.0), radians(3.0)
NEAR_SHOULDER, TIGHT_SHOULDER = 0.08, 0.02
"""Distances to a singularity that are mentioned, and that are a warning [m]."""

NEAR_RATIO, TIGHT_RATIO = 0.05, 0.01
"""Ratios of the least to the greatest singular value of the Jacobian that are mentioned, and a warning."""


def worst_first(words: Words) -> tuple[tuple[Level, str], ...]:
    """Return the words in order of their level."""
    return tuple(sorted(words, key=lambda one: LEVELS.index(one[0])))


def limit_words(robot: RobotModel, q: Array, wanted: Array) -> Words:
    """Return the words on joint limits.

    Args:
        robot: the arm.
        q: where it stands, inside the limits [rad | m], shape (n,).
        wanted: requested coordinates, shape (n,).
    """
    words: Words = []
    coupled = coupled_limits(robot)
    joints = (*robot.axis_joints, *coupled.joints)
    values, targets = ((*one.tolist(), *coupled.values(one).tolist()) for one in (q, wanted))
    for joint, value, target in zip(joints, values, targets, strict=True):
        upper = joint.upper - value <= value - joint.lower
        limit = joint.upper if upper else joint.lower
        left = abs(limit - value)
        named = f"{'upper' if upper else 'lower'} limit {shown(joint, limit)}"
        if target - joint.upper > AT_LIMIT or joint.lower - target > AT_LIMIT:
            words.append(("error", f"joint {joint.name} stops at its {named}"))
        elif left <= AT_LIMIT:
            words.append(("warning", f"joint {joint.name} is at its {named}"))
        elif left <= NEAR_LIMIT[joint.measure]:
            words.append(("info", f"joint {joint.name} is {shown(joint, left)} from its {named}"))
    return words


def refusal_words(robot: RobotModel, found: IkResult, here: Array) -> Words:
    """Return why a pose cannot be had: out of reach, or which limits it breaks.

    Limits are the violated ones of the present posture; if it has no answer, of the posture with the least
    violation.

    Args:
        robot: the arm.
        found: no solution.
        here: where the arm stands [rad | m], shape (n,).
    """
    if found.shortfall is not None:
        return [("error", _shortfall_text(found.shortfall))]
    kept = branch(found, posture(robot, here))
    words: Words = []
    for one in found.violations if kept is None else limit_violations(robot, kept):
        joint = one.model
        side = "upper" if one.value > one.limit else "lower"
        text = (
            f"joint {joint.name} would have to go to {shown(joint, one.value)}, "
            f"{shown(joint, one.excess)} beyond its {side} limit {shown(joint, one.limit)}"
        )
        words.append(("error", text))
    return words


def singularity_words(robot: RobotModel, q: Array) -> Words:
    """Return which singularities are near, with how far."""
    left = singular_distances(robot, q)
    if left is None:
        return _general_words(robot, q)
    angle, length = f"{degrees(left.wrist):.1f}°", f"{left.shoulder * 1e3:.0f} mm"
    bend = f"{degrees(left.elbow):.1f}°"
    return [
        *_near(
            left.wrist,
            (NEAR_ANGLE, TIGHT_ANGLE),
            f"wrist nearly straight: axes 4 and 6 are {angle} from lining up, joints 4 and 6 turn fast here",
        ),
        *_near(
            left.elbow,
            (NEAR_ANGLE, TIGHT_ANGLE),
            f"elbow {bend} from being stretched or folded: the arm ends here, joint 3 turns fast",
        ),
        *_near(
            left.shoulder,
            (NEAR_SHOULDER, TIGHT_SHOULDER),
            f"wrist {length} from standing above the shoulder: joint 1 turns fast here",
        ),
    ]


def shown(joint: Joint, value: float) -> str:
    """Return a coordinate in the unit that users read."""
    if joint.measure is JointType.REVOLUTE:
        return f"{round(degrees(value), 1):g}°"
    return f"{round(value * 1e3, 1):g} mm"


def _shortfall_text(shortfall: Shortfall) -> str:
    reach, miss = shortfall.reach, shortfall.miss
    if reach is not None:
        if reach.distance > reach.longest:
            beyond, how = reach.distance - reach.longest, "too far away"
        else:
            beyond, how = reach.shortest - reach.distance, f"too near to axis {reach.axis}"
        return f"out of reach: the {reach.point} would be {beyond * 1e3:.1f} mm {how}"
    if miss is None:
        return shortfall.status.value
    missing = f"{miss.distance * 1e3:.1f} mm and {degrees(miss.angle):.1f}° are missing"
    return f"{shortfall.status.value}: {miss.why}; {missing}"


def _near(left: float, bounds: tuple[float, float], text: str) -> Iterable[tuple[Level, str]]:
    near, tight = bounds
    if left <= near:
        yield ("warning" if left <= tight else "info", f"near a singularity, {text}")


def _general_words(robot: RobotModel, q: Array) -> Words:
    """Return the same for any arm, from the Jacobian of its interface; few joints only place it."""
    rows = 3 if robot.n <= 3 else 6
    values = np.linalg.svd(jacobian(robot, q)[:rows], compute_uv=False)
    greatest = float(values[0])
    ratio = float(values[-1]) / greatest if greatest > 0.0 else 0.0
    text = f"its slowest direction has {ratio:.1%} of the speed of its fastest one"
    return list(_near(ratio, (NEAR_RATIO, TIGHT_RATIO), text))
