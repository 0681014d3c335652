"""Frames of steps of a traced arm in the frame of a step below them, and how steps move points."""

from collections.abc import Iterator

from ropsim.codegen import Scalar
from ropsim.dynamics.traced.traced_arm import TracedArm
from ropsim.dynamics.traced.vectors import Matrix, Vector, add, apply, column, cross, dot, product
from ropsim.model import BASE_LINK, JointType


def common_step(arm: TracedArm, one: int, other: int) -> int:
    """Return the last step that two steps hang on, or are; -1 for the base."""
    below = {BASE_LINK, one, *_below(arm, one)}
    while other not in below:
        other = arm.parents[other]
    return other


def way_to(arm: TracedArm, step: int, start: int) -> list[int]:
    """Return the steps behind `start` up to a step that hangs on it, in order."""
    found = []
    while step != start:
        found.append(step)
        step = arm.parents[step]
    return found[::-1]


def frames_on_way(arm: TracedArm, way: list[int]) -> list[tuple[Matrix, Vector]]:
    """Return rotation and origin of each step of a way in the frame in which the way starts."""
    found: list[tuple[Matrix, Vector]] = []
    for step in way:
        R, p = arm.rotations[step], arm.origins[step]
        if found:
            R_before, p_before = found[-1]
            R, p = product(R_before, R), add(p_before, apply(R_before, p))
        found.append((R, p))
    return found


def moved_along(arm: TracedArm, step: int, frame: tuple[Matrix, Vector], u: Vector, point: Vector) -> Scalar:
    """Return how fast a step moves a point along a direction.

    Args:
        arm: the arm.
        step: that moves with unit speed.
        frame: of the step.
        u: direction, in the axes in which the frame is given.
        point: in the same axes.
    """
    R, p = frame
    z = column(R, 2)
    if arm.types[step] is JointType.PRISMATIC:
        return dot(u, z)
    lever = (point[0] - p[0], point[1] - p[1], point[2] - p[2])
    return dot(cross(lever, u), z)


def turned_about(arm: TracedArm, step: int, frame: tuple[Matrix, Vector], u: Vector) -> Scalar:
    """Return how fast a step turns bodies about a direction; arguments as in `moved_along`."""
    if arm.types[step] is JointType.PRISMATIC:
        return arm.tracer.constant(0.0)
    return dot(u, column(frame[0], 2))


def _below(arm: TracedArm, step: int) -> Iterator[int]:
    while step != BASE_LINK:
        step = arm.parents[step]
        yield step
