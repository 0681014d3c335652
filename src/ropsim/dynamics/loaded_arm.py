"""The torques of an arm as a formula that is given the load of its interface while it runs."""

from collections.abc import Sequence
from dataclasses import replace

from ropsim.codegen import Scalar, Tracer
from ropsim.dynamics.structure import ArmStructure, TracedNumbers
from ropsim.dynamics.traced.mass_matrix import joined_bodies, moved_body
from ropsim.dynamics.traced.newton_euler import trace_inverse
from ropsim.dynamics.traced.traced_arm import TracedArm, trace_arm, traced_body
from ropsim.dynamics.traced.traced_drives import joint_sides


def trace_loaded_inverse(
    tracer: Tracer,
    structure: ArmStructure,
    numbers: TracedNumbers,
    motion: tuple[Sequence[Scalar], Sequence[Scalar], Sequence[Scalar]],
    load: list[Scalar],
    sliding: Sequence[Scalar],
) -> list[Scalar]:
    """Return the torques of the drives at the axes that a motion takes, with friction and motor inertia.

    Args:
        tracer: the graph.
        structure: of the arm.
        numbers: of the arm without payload.
        motion: coordinates, speeds and accelerations of the axes.
        load: barycentric parameters of tool and part in the interface frame, 10 of them, as laws get them.
        sliding: speeds of the axes for which the friction of the drives is taken.
    """
    q, qd, qdd = motion
    arm = _loaded(trace_arm(tracer, structure, numbers, q), load)
    tau = trace_inverse(arm, list(qd), list(qdd))
    for k, (friction, inertia) in enumerate(joint_sides(structure, numbers.drives, tracer, (q, sliding))):
        tau[k] = tau[k] + qdd[k] * inertia + friction
    return tau


def _loaded(arm: TracedArm, load: list[Scalar]) -> TracedArm:
    """Return the arm with a load fixed to its interface."""
    if arm.tip < 0:
        return arm
    carried = moved_body(traced_body(load), arm.interface_rotation, arm.interface_origin)
    bodies = list(arm.bodies)
    bodies[arm.tip] = joined_bodies(bodies[arm.tip], carried)
    return replace(arm, bodies=tuple(bodies))
