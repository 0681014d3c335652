"""The drives of an arm in its equations: their effect on the joints, and the rates of their states."""

from collections.abc import Callable, Sequence
from functools import lru_cache

import numpy as np

from ropsim.codegen import Engine, Formula, GivenCode, Scalar, Tracer
from ropsim.dynamics.drives import Carried
from ropsim.dynamics.structure import ArmStructure, traced_numbers
from ropsim.spatial import Array

Side = tuple[Scalar, Scalar]
"""Friction and inertia at the joint."""


def trace_drives(
    structure: ArmStructure,
    numbers: Sequence[Sequence[Scalar]],
    joints: tuple[Sequence[Scalar], Sequence[Scalar]],
    states: Sequence[Sequence[Scalar]],
    u: Sequence[Scalar],
) -> list[Carried]:
    """Return the effect of each drive on its joint.

    Args:
        structure: of the arm.
        numbers: of each drive.
        joints: coordinates and speeds.
        states: of each drive.
        u: output of each amplifier.
    """
    return [
        chain.trace(numbers[k], joints[0][k], joints[1][k], states[k], u[k])
        for k, chain in enumerate(structure.drives)
    ]


def sides_of(tracer: Tracer, carried: Sequence[Carried]) -> list[Side]:
    """Return friction and inertia that drives bring to their joints, 0 where there is none."""
    zero = tracer.constant(0.0)
    return [(one.friction or zero, one.inertia or zero) for one in carried]


def joint_sides(
    structure: ArmStructure,
    numbers: Sequence[Sequence[Scalar]],
    tracer: Tracer,
    joints: tuple[Sequence[Scalar], Sequence[Scalar]],
) -> list[Side]:
    """Return friction and inertia of the drives at the joints, which no state of a drive has a part in.

    Args:
        structure: of the arm.
        numbers: of each drive.
        tracer: the graph.
        joints: coordinates and speeds.
    """
    zero = tracer.constant(0.0)
    rest = [zero] * structure.n
    states = [[zero] * len(chain.states) for chain in structure.drives]
    return sides_of(tracer, trace_drives(structure, numbers, joints, states, rest))


@lru_cache(maxsize=64)
def sides_code(structure: ArmStructure) -> GivenCode:
    """Return `sides(q, qd, constants, out)`: friction, then inertia, that the drives bring to the joints."""
    tracer, n = Tracer(), structure.n
    q, qd = tracer.variables("q", n), tracer.variables("qd", n)
    sides = joint_sides(structure, traced_numbers(tracer, structure).drives, tracer, (q, qd))
    sides = sides or [(tracer.constant(0.0),) * 2] * n
    results = [(f"out[{k}]", friction) for k, (friction, _) in enumerate(sides)]
    results += [(f"out[{n + k}]", inertia) for k, (_, inertia) in enumerate(sides)]
    return GivenCode.of(Formula("sides", ("q", "qd", "out"), results))


def drive_sides(structure: ArmStructure, numbers: Array) -> Callable[[Array, Array], tuple[Array, Array]]:
    """Return the function from joint coordinates and speeds to friction and inertia of drives, (n,) each.

    That are friction and inertia.

    Friction has the sign of the motion [N·m | N]; inertia is in kg·m² | kg. The function is plain Python: it
    has a line for each joint, and compiling them takes longer than many calls.

    Args:
        structure: of the arm.
        numbers: as from `arm_numbers`.
    """
    code = sides_code(structure).bound("drive_sides", numbers, Engine.PYTHON)

    def sides(q: Array, qd: Array) -> tuple[Array, Array]:
        out = np.empty(2 * structure.n)
        code(q, qd, out)
        return out[: structure.n], out[structure.n :].copy()

    return sides
