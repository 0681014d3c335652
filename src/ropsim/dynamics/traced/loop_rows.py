"""The cuts of closed chains as equations: residuals between two frames, and their slopes.

In directions along the axes of the first frame, the residual is the way from its origin to the other one; of
rotations, with E = R₁ᵀ·R₂ and all three held, it is the vector of (E - Eᵀ)/2. With two held it is the tilt of
the axis of the free one; with one held it is by how far two axes of the frames, between which the cross of a
universal joint stands, are off the right angle. None of these slopes vanishes in a closed chain, however far
the free directions are turned.
"""

from collections.abc import Sequence
from typing import NamedTuple

from ropsim.codegen import Scalar, Tracer, rates_of
from ropsim.dynamics.fastened import CutPlaces
from ropsim.dynamics.traced.traced_arm import TracedArm, traced_placement
from ropsim.dynamics.traced.tree_frames import common_step, frames_on_way, moved_along, turned_about, way_to
from ropsim.dynamics.traced.vectors import Matrix, Vector, add, apply, column, cross, dot, product, transpose

_AXES = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
_RIGHT_ANGLES = ((2, 1, 1.0), (2, 0, -1.0), (1, 0, 1.0))
"""For each direction that is held alone: axes of the first and second frame at right angles, and a sign."""


class LoopRows(NamedTuple):
    """The equations of all cuts, r of them.

    Attributes:
        left: residuals between the frames [m, rad], r of them.
        slopes: by the coordinates that move the tree, r rows.
        steps: the same by the coordinates of the steps.
    """

    left: list[Scalar]
    slopes: list[list[Scalar]]
    steps: list[list[Scalar]]


def trace_loops(arm: TracedArm, cuts: Sequence[CutPlaces]) -> LoopRows:
    """Return the equations of cuts."""
    left: list[Scalar] = []
    steps: list[list[Scalar]] = []
    for cut in cuts:
        found = _cut(arm, cut)
        left += found[0]
        steps += found[1]
    return LoopRows(left, [arm.of_axes(row) for row in steps], steps)


def trace_drift(arm: TracedArm, rows: LoopRows, speeds: Sequence[Scalar]) -> list[Scalar]:
    """Return the second derivatives of the residuals, without accelerations of the coordinates.

    Args:
        arm: the arm.
        rows: of its cuts.
        speeds: of the coordinates that move the tree.
    """
    if not rows.left:
        return []
    of_steps, zero = arm.of_steps(speeds), arm.tracer.constant(0.0)
    rates = [sum((a * b for a, b in zip(row, of_steps, strict=True)), zero) for row in rows.steps]
    return rates_of(rates, dict(zip(arm.coordinates, speeds, strict=True)))


def _cut(arm: TracedArm, cut: CutPlaces) -> tuple[list[Scalar], list[list[Scalar]]]:
    start = common_step(arm, cut.first, cut.second)
    way_1, way_2 = way_to(arm, cut.first, start), way_to(arm, cut.second, start)
    frames_1, frames_2 = frames_on_way(arm, way_1), frames_on_way(arm, way_2)
    R_1, p_1 = _end(frames_1, *traced_placement(arm.tracer, cut.X_first))
    R_2, p_2 = _end(frames_2, *traced_placement(arm.tracer, cut.X_second))
    apart = (p_2[0] - p_1[0], p_2[1] - p_1[1], p_2[2] - p_1[2])
    E = product(transpose(R_1), R_2)
    moved = [(step, frame, 1.0) for step, frame in zip(way_2, frames_2, strict=True)]
    moved += [(step, frame, -1.0) for step, frame in zip(way_1, frames_1, strict=True)]
    left, rows = [], []
    for k in range(3):
        if cut.held[k]:
            u = column(R_1, k)
            left.append(dot(u, apart))
            rates = [(step, sense * moved_along(arm, step, frame, u, p_2)) for step, frame, sense in moved]
            rows.append(_row(arm, rates))
    for value, turn in _turns(arm.tracer, E, cut.held[3:]):
        u = apply(R_1, turn)
        left.append(value)
        rates = [(step, sense * turned_about(arm, step, frame, u)) for step, frame, sense in moved]
        rows.append(_row(arm, rates))
    return left, rows


def _end(frames: list[tuple[Matrix, Vector]], R: Matrix, p: Vector) -> tuple[Matrix, Vector]:
    """Return a frame on the last step of a way in the frame in which the way starts."""
    if not frames:
        return R, p
    R_step, p_step = frames[-1]
    return product(R_step, R), add(p_step, apply(R_step, p))


def _row(arm: TracedArm, rates: list[tuple[int, Scalar]]) -> list[Scalar]:
    """Return a number of each step, from those of the steps that have a part."""
    row = [arm.tracer.constant(0.0)] * arm.m
    for step, rate in rates:
        row[step] = rate
    return row


def _turns(tracer: Tracer, E: Matrix, held: Sequence[bool]) -> list[tuple[Scalar, Vector]]:
    """Return the residuals of the rotations that are held, each with the turn that lets it grow.

    A turn is a factor of the angular velocity of the second frame against the first one, in the axes of that.
    """
    axes = [k for k in range(3) if held[k]]
    if len(axes) == 3:
        trace = E[0][0] + E[1][1] + E[2][2]
        return [
            (0.5 * (E[(k + 2) % 3][(k + 1) % 3] - E[(k + 1) % 3][(k + 2) % 3]), _whole(E, trace, k))
            for k in range(3)
        ]
    found = []
    for k in axes:
        if len(axes) == 2:
            (free,) = {0, 1, 2} - set(axes)
            before = k == (free + 1) % 3
            row, of, sense = (free + (2 if before else 1)) % 3, free, -1.0 if before else 1.0
        else:
            row, of, sense = _RIGHT_ANGLES[k]
        unit = tuple(tracer.constant(one) for one in _AXES[row])
        turn = cross(column(E, of), (unit[0], unit[1], unit[2]))
        found.append((sense * E[row][of], (sense * turn[0], sense * turn[1], sense * turn[2])))
    return found


def _whole(E: Matrix, trace: Scalar, k: int) -> Vector:
    """Return row k of (tr(E)·1 - E)/2: the rate of the vector of (E - Eᵀ)/2 over an angular velocity."""
    entries = [0.5 * ((trace - E[k][j]) if j == k else -E[k][j]) for j in range(3)]
    return entries[0], entries[1], entries[2]
