"""The drives of an arm in its equations: their effect on the joints, and the rates of their states."""

from collections.abc import Callable, Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from ropsim.codegen import Engine, Formula, GivenCode, Scalar, Tracer, maximum, minimum
from ropsim.dynamics.drives import Carried, Rubbing, trace_supply
from ropsim.dynamics.structure import ArmStructure, TracedNumbers, traced_numbers
from ropsim.spatial import Array


class Side(NamedTuple):
    """What a drive brings to its joint besides its effort.

    Attributes:
        friction: that it takes.
        inertia: in addition to that of the links.
    """

    friction: Rubbing
    inertia: Scalar

    def needed(self, effort: Scalar) -> Scalar:
        """Return the effort of the drive at which one is left when friction has taken its part.

        With a share s of the load, τ = x + s·|τ| is solved by x/(1 - s) for positive and x/(1 + s) for
        negative x, the effort with the other part of friction.
        """
        whole, share = effort + self.friction.torque, self.friction.share
        if share is None:
            return whole
        zero = whole.tracer.constant(0.0)
        return maximum(whole, zero) / (1.0 - share) + minimum(whole, zero) / (1.0 + share)


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


def at_supplies(
    structure: ArmStructure, numbers: TracedNumbers, pressures: Sequence[Scalar]
) -> list[Sequence[Scalar]]:
    """Return the numbers of the drives at the present pressures of their supplies of oil [Pa].

    Args:
        structure: of the arm.
        numbers: of the arm.
        pressures: of its supplies with accumulators.
    """
    found: list[Sequence[Scalar]] = list(numbers.drives)
    for axes, pressure in zip(structure.supplies, pressures, strict=True):
        for axis in axes:
            found[axis] = structure.drives[axis].supplied(found[axis], pressure)
    return found


def trace_supplies(
    structure: ArmStructure,
    numbers: TracedNumbers,
    states: Sequence[Sequence[Scalar]],
    pressures: Sequence[Scalar],
) -> list[Scalar]:
    """Return the rates of the pressures of the supplies with accumulators [Pa/s].

    Args:
        structure: of the arm.
        numbers: of the arm.
        states: of each drive.
        pressures: of the supplies [Pa].
    """
    at, rates = at_supplies(structure, numbers, pressures), []
    for axes, own, pressure in zip(structure.supplies, numbers.supplies, pressures, strict=True):
        flows = (structure.drives[axis].taken(at[axis], states[axis]) for axis in axes)
        rates.append(trace_supply(own, pressure, [flow for flow in flows if flow is not None]))
    return rates


def sides_of(tracer: Tracer, carried: Sequence[Carried]) -> list[Side]:
    """Return what drives bring to their joints, 0 where there is none."""
    zero = tracer.constant(0.0)
    return [Side(one.friction or Rubbing(zero), one.inertia or zero) for one in carried]


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
    q, qd = joints
    chains = enumerate(structure.drives)
    return sides_of(tracer, [chain.side(numbers[k], q[k], qd[k]) for k, chain in chains])


@lru_cache(maxsize=64)
def sides_code(structure: ArmStructure) -> GivenCode:
    """Return `sides(q, qd, constants, out)`: what the drives bring to the joints, shape (3·n,).

    It is friction that does not depend on the load, then inertia, then the share of the load that friction
    takes besides.
    """
    tracer, n = Tracer(), structure.n
    zero = tracer.constant(0.0)
    q, qd = tracer.variables("q", n), tracer.variables("qd", n)
    sides = joint_sides(structure, traced_numbers(tracer, structure).drives, tracer, (q, qd))
    sides = sides or [Side(Rubbing(zero), zero)] * n
    results = [(f"out[{k}]", one.friction.torque) for k, one in enumerate(sides)]
    results += [(f"out[{n + k}]", one.inertia) for k, one in enumerate(sides)]
    results += [(f"out[{2 * n + k}]", one.friction.share or zero) for k, one in enumerate(sides)]
    return GivenCode.of(Formula("sides", ("q", "qd", "out"), results))


def drive_sides(structure: ArmStructure, numbers: Array) -> Callable[[Array, Array], Array]:
    """Return the function from joint coordinates and speeds to what the drives bring, shape (3, n).

    Its rows are friction without load, with the sign of the motion [N·m | N], inertia [kg·m² | kg], and the
    share of the load that friction takes besides. The function is plain Python: it has a line for each joint,
    and compiling them takes longer than many calls.

    Args:
        structure: of the arm.
        numbers: as from `arm_numbers`.
    """
    code = sides_code(structure).bound("drive_sides", numbers, Engine.PYTHON)

    def sides(q: Array, qd: Array) -> Array:
        out = np.empty(3 * structure.n)
        code(q, qd, out)
        return out.reshape(3, structure.n)

    return sides
