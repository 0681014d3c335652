"""The drives of an arm in its equations: what they bring to the joints, and the rates of their states."""

from collections.abc import Sequence

from ropsim.codegen import Scalar, Tracer
from ropsim.dynamics.drives import Carried
from ropsim.dynamics.structure import ArmStructure

Side = tuple[Scalar, Scalar]
"""Friction and inertia at the joint."""


def trace_drives(
    structure: ArmStructure,
    numbers: Sequence[Sequence[Scalar]],
    joints: tuple[Sequence[Scalar], Sequence[Scalar]],
    states: Sequence[Sequence[Scalar]],
    u: Sequence[Scalar],
) -> list[Carried]:
    """Return what each drive brings to its joint.

    Args:
        structure: of the arm.
        numbers: of each drive.
        joints: coordinates and speeds.
        states: of each drive.
        u: what each amplifier puts out.
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
    structure: ArmStructure, numbers: Sequence[Sequence[Scalar]], tracer: Tracer, qd: Sequence[Scalar]
) -> list[Side]:
    """Return friction and inertia of the drives at the joints, which no state of a drive has a part in.

    Args:
        structure: of the arm.
        numbers: of each drive.
        tracer: the graph.
        qd: joint speeds.
    """
    zero = tracer.constant(0.0)
    rest = [zero] * structure.n
    states = [[zero] * len(chain.states) for chain in structure.drives]
    return sides_of(tracer, trace_drives(structure, numbers, (rest, qd), states, rest))
