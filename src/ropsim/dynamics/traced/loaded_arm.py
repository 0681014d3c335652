"""The torques of an arm as formulas that are given the load of its interface while they run."""

from collections.abc import Sequence
from dataclasses import replace

from ropsim.codegen import Scalar, Tracer
from ropsim.dynamics.structure import ArmStructure, TracedNumbers
from ropsim.dynamics.traced.mass_matrix import joined_bodies, moved_body, trace_mass_matrix
from ropsim.dynamics.traced.newton_euler import trace_inverse
from ropsim.dynamics.traced.traced_arm import TracedArm, trace_arm, traced_body
from ropsim.dynamics.traced.traced_drives import joint_sides

Axes = Sequence[Scalar]
"""A number of each axis."""


def trace_loaded_inverse(
    tracer: Tracer,
    structure: ArmStructure,
    numbers: TracedNumbers,
    motion: tuple[Axes, Axes, Axes],
    load: list[Scalar],
    motors: tuple[Axes, Axes],
) -> list[Scalar]:
    """Return the torques of the drives at the axes that a motion takes, with friction and motor inertia.

    Args:
        tracer: the graph.
        structure: of the arm.
        numbers: of the arm without payload.
        motion: coordinates, speeds and accelerations of the axes.
        load: barycentric parameters of tool and part in the interface frame, 10 of them, as laws get them.
        motors: speeds and accelerations at the axes for which friction and inertia of the drives are taken.
    """
    q, qd, qdd = motion
    speeds, accelerations = motors
    arm = _loaded(trace_arm(tracer, structure, numbers, q), load)
    tau = trace_inverse(arm, list(qd), list(qdd))
    for k, side in enumerate(joint_sides(structure, numbers.drives, tracer, (q, speeds))):
        tau[k] = side.needed(tau[k] + accelerations[k] * side.inertia)
    return tau


def trace_loaded_tree(
    tracer: Tracer,
    structure: ArmStructure,
    numbers: TracedNumbers,
    motion: tuple[Axes, Axes, Axes],
    load: list[Scalar],
) -> list[Scalar]:
    """Return the efforts of bodies and springs at all coordinates of a tree, without drives.

    Args:
        tracer: the graph.
        structure: of the arm.
        numbers: of the arm without payload.
        motion: coordinates, speeds and accelerations of axes and closed chains.
        load: as in `trace_loaded_inverse`.
    """
    y, yd, ydd = motion
    return trace_inverse(_loaded(trace_arm(tracer, structure, numbers, y), load), list(yd), list(ydd))


def trace_loaded_links(
    tracer: Tracer,
    structure: ArmStructure,
    numbers: TracedNumbers,
    motion: tuple[Axes, Axes],
    load: list[Scalar],
) -> list[Scalar]:
    """Return the mass matrix of links, tool and part times accelerations, without drives and gravity.

    Args:
        tracer: the graph.
        structure: of the arm.
        numbers: of the arm without payload.
        motion: coordinates and accelerations of the axes.
        load: as in `trace_loaded_inverse`.
    """
    q, qdd = motion
    zero = tracer.constant(0.0)
    arm = _loaded(trace_arm(tracer, structure, numbers, q), load)
    weightless = replace(arm, base_acceleration=(zero, zero, zero), springs=(), sprung=())
    return trace_inverse(weightless, [zero] * structure.n, list(qdd))


def trace_loaded_inertias(
    tracer: Tracer, structure: ArmStructure, numbers: TracedNumbers, q: Axes, load: list[Scalar]
) -> list[Scalar]:
    """Return the inertia that each axis moves while the others stand: the diagonal of the mass matrix.

    Args:
        tracer: the graph.
        structure: of the arm.
        numbers: of the arm without payload.
        q: coordinates of the axes.
        load: as in `trace_loaded_inverse`.
    """
    arm = _loaded(trace_arm(tracer, structure, numbers, q), load)
    still = [tracer.constant(0.0)] * structure.n
    sides = joint_sides(structure, numbers.drives, tracer, (q, still))
    return [row[-1] + side.inertia for row, side in zip(trace_mass_matrix(arm), sides, strict=True)]


def _loaded(arm: TracedArm, load: list[Scalar]) -> TracedArm:
    """Return the arm with a load fixed to its interface."""
    if arm.tip < 0:
        return arm
    carried = moved_body(traced_body(load), arm.interface_rotation, arm.interface_origin)
    bodies = list(arm.bodies)
    bodies[arm.tip] = joined_bodies(bodies[arm.tip], carried)
    return replace(arm, bodies=tuple(bodies))
