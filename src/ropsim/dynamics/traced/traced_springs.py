"""The springs of a mechanism in its equations: efforts that balance them."""

from collections.abc import Sequence

from ropsim.codegen import Scalar, maximum, sqrt
from ropsim.dynamics.fastened import SpringPlaces
from ropsim.dynamics.traced.traced_arm import TracedArm
from ropsim.dynamics.traced.tree_frames import common_step, frames_on_way, moved_along, way_to
from ropsim.dynamics.traced.vectors import Vector, add, apply, dot

LEAST = 1e-150
"""Length below which a spring has no direction [m]; its square is a number still."""


def trace_spring_efforts(arm: TracedArm, speeds: Sequence[Scalar]) -> list[Scalar]:
    """Return the efforts at the steps that balance springs and dampers between bodies, m of them.

    Args:
        arm: the arm.
        speeds: of its steps.
    """
    zero = arm.tracer.constant(0.0)
    efforts = [zero] * arm.m
    for spring, (stiffness, free_length, damping) in zip(arm.springs, arm.spring_numbers, strict=False):
        length, slopes = trace_length(arm, spring)
        rate = sum((slope * speeds[step] for step, slope in slopes), zero)
        force = stiffness * (length - free_length) + damping * rate
        for step, slope in slopes:
            efforts[step] = efforts[step] + force * slope
    return efforts


def trace_length(arm: TracedArm, spring: SpringPlaces) -> tuple[Scalar, list[tuple[int, Scalar]]]:
    """Return the length of a spring, and how fast each of the steps that stretch it does so."""
    start = common_step(arm, spring.first, spring.second)
    ways = [way_to(arm, step, start) for step in (spring.first, spring.second)]
    frames = [frames_on_way(arm, way) for way in ways]
    points: list[Vector] = []
    for found, place in zip(frames, (spring.point_1, spring.point_2), strict=True):
        x, y, z = (arm.tracer.constant(one) for one in place)
        point: Vector = (x, y, z)
        points.append(add(found[-1][1], apply(found[-1][0], point)) if found else point)
    one, other = points
    apart: Vector = (other[0] - one[0], other[1] - one[1], other[2] - one[2])
    length = sqrt(dot(apart, apart))
    size = maximum(length, arm.tracer.constant(LEAST))
    u: Vector = (apart[0] / size, apart[1] / size, apart[2] / size)
    slopes = []
    for way, found, point, sense in zip(ways, frames, points, (-1.0, 1.0), strict=True):
        for step, frame in zip(way, found, strict=True):
            slopes.append((step, sense * moved_along(arm, step, frame, u, point)))
    return length, slopes


def trace_joint_spring_efforts(arm: TracedArm, speeds: Sequence[Scalar]) -> list[Scalar]:
    """Return the efforts at the coordinates that balance springs and dampers on coordinates of joints.

    Args:
        arm: the arm.
        speeds: of the coordinates that move its tree.
    """
    zero = arm.tracer.constant(0.0)
    efforts = [zero] * len(speeds)
    numbers = arm.spring_numbers[len(arm.springs) :]
    for row, (stiffness, rest, damping) in zip(arm.sprung, numbers, strict=True):
        place = sum((a * q for a, q in zip(row[:-1], arm.coordinates, strict=True)), zero) + row[-1]
        rate = sum((a * v for a, v in zip(row[:-1], speeds, strict=True)), zero)
        effort = stiffness * (place - rest) + damping * rate
        efforts = [one + a * effort for one, a in zip(efforts, row[:-1], strict=True)]
    return efforts
