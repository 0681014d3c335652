"""The arm as traced scalars: the moving frames and bodies from which the recursions are written."""

import math
from collections.abc import Sequence

from ropsim.codegen import Scalar, Tracer, cos, sin
from ropsim.core import frozen_dataclass
from ropsim.dynamics.fastened import Placement, SpringPlaces
from ropsim.dynamics.structure import ArmStructure, TracedNumbers
from ropsim.dynamics.traced.vectors import Matrix, Vector
from ropsim.model import JointType

ROUNDING = 1e-15
"""Of sines and cosines of right angles."""


@frozen_dataclass
class Body:
    """A rigid body by its barycentric parameters in its joint frame; see `ropsim.dynamics.inertia`.

    Attributes:
        mass: m.
        moment: m·c.
        inertia: I_o, symmetric.
    """

    mass: Scalar
    moment: Vector
    inertia: Matrix


@frozen_dataclass
class TracedArm:
    """An arm in one traced formula: m steps that n coordinates move.

    The coordinates are of the axes, then of closed chains.

    Attributes:
        tracer: the graph.
        coordinates: n of them.
        types: of the steps.
        parents: step that each hangs on, -1 for the base.
        spread: rows of (T, P), empty where step i is axis i.
        rotations: from the frame of each step to that of its parent, as the arm stands.
        origins: origin of its frame in that of its parent, as the arm stands.
        bodies: body on each step.
        base_acceleration: of the base in its own axes: minus free fall, which stands for gravity.
        tip: step that carries the mechanical interface, -1 for the base.
        interface_rotation: from the mechanical interface to the frame of that step.
        interface_origin: of the mechanical interface in that frame.
        springs: between bodies.
        sprung: (T, P, c) of the coordinate of each spring on one.
        spring_numbers: stiffness, free length or rest, and damping of each of both.
    """

    tracer: Tracer
    coordinates: tuple[Scalar, ...]
    types: tuple[JointType, ...]
    parents: tuple[int, ...]
    spread: tuple[tuple[float, ...], ...]
    rotations: tuple[Matrix, ...]
    origins: tuple[Vector, ...]
    bodies: tuple[Body, ...]
    base_acceleration: Vector
    tip: int
    interface_rotation: Matrix
    interface_origin: Vector
    springs: tuple[SpringPlaces, ...] = ()
    sprung: tuple[tuple[float, ...], ...] = ()
    spring_numbers: tuple[list[Scalar], ...] = ()

    @property
    def m(self) -> int:
        """Return the number of steps."""
        return len(self.types)

    @property
    def n(self) -> int:
        """Return the number of coordinates."""
        return len(self.spread[0]) if self.spread else self.m

    def of_steps(self, values: Sequence[Scalar]) -> list[Scalar]:
        """Return speeds or accelerations of the steps from those of the coordinates: T times them."""
        return [_sum(self.tracer, row, values) for row in self.spread] if self.spread else list(values)

    def of_axes(self, efforts: Sequence[Scalar]) -> list[Scalar]:
        """Return the efforts at the coordinates that do the work of efforts at the steps: Tᵀ times them."""
        if not self.spread:
            return list(efforts)
        return [_sum(self.tracer, column, efforts) for column in zip(*self.spread, strict=True)]


def trace_arm(
    tracer: Tracer, structure: ArmStructure, numbers: TracedNumbers, q: Sequence[Scalar]
) -> TracedArm:
    """Return the arm with its coordinates at `q`, n of them."""
    rotations, origins, moving = [], [], tuple(q)
    spread, turns = structure.spread, _Turns(tracer, moving)
    if spread:
        q = [_sum(tracer, row[:-1], q) + row[-1] for row in spread]
    for step, (type_, placement, offset, coordinate) in enumerate(
        zip(structure.types, structure.placements, structure.offsets, q, strict=True)
    ):
        R0, p0 = traced_placement(tracer, placement)
        moved = coordinate + offset
        if type_ is JointType.REVOLUTE:
            s, c = turns.of(spread[step], offset) if spread else (sin(moved), cos(moved))
            rows = [(r[0] * c + r[1] * s, r[1] * c - r[0] * s, r[2]) for r in R0]
            rotations.append((rows[0], rows[1], rows[2]))
            origins.append(p0)
        else:
            rotations.append(R0)
            origins.append((p0[0] + R0[0][2] * moved, p0[1] + R0[1][2] * moved, p0[2] + R0[2][2] * moved))
    x, y, z = numbers.base_acceleration
    return TracedArm(
        tracer,
        moving,
        structure.types,
        structure.parents,
        tuple(row[:-1] for row in structure.spread),
        tuple(rotations),
        tuple(origins),
        tuple(traced_body(parameters) for parameters in numbers.bodies),
        (x, y, z),
        structure.tip,
        *traced_placement(tracer, structure.interface),
        structure.springs,
        structure.sprung,
        tuple(numbers.springs),
    )


class _Turns:
    """Sines and cosines of sums of coordinates, from those of the coordinates where factors are 1 and -1.

    The angles of a parallelogram are such sums: each costs four products in place of a sine and a cosine.

    Args:
        tracer: the graph.
        coordinates: of the axes, then of closed chains.
    """

    def __init__(self, tracer: Tracer, coordinates: Sequence[Scalar]) -> None:
        self._tracer, self._coordinates = tracer, coordinates
        self._known: dict[int, tuple[Scalar, Scalar]] = {}

    def of(self, row: Sequence[float], offset: float) -> tuple[Scalar, Scalar]:
        """Return sine and cosine of a row of (T, P, c), plus an offset [rad]."""
        tracer, factors, fixed = self._tracer, row[:-1], row[-1] + offset
        moving = [factor for factor in factors if factor]
        if moving == [1.0] or any(factor not in {1.0, -1.0} for factor in moving):
            moved = _sum(tracer, factors, self._coordinates) + fixed
            return sin(moved), cos(moved)
        s, c = (tracer.constant(_exact(one)) for one in (math.sin(fixed), math.cos(fixed)))
        for number, factor in enumerate(factors):
            if factor:
                s1, c1 = self._pair(number)
                s, c = s * c1 + factor * (c * s1), c * c1 - factor * (s * s1)
        return s, c

    def _pair(self, number: int) -> tuple[Scalar, Scalar]:
        if number not in self._known:
            one = self._coordinates[number]
            self._known[number] = sin(one), cos(one)
        return self._known[number]


def _exact(value: float) -> float:
    """Return a sine or cosine without the rounding of a right angle."""
    nearest = float(round(value))
    return nearest if abs(value - nearest) < ROUNDING else value


def _sum(tracer: Tracer, factors: Sequence[float], values: Sequence[Scalar]) -> Scalar:
    """Return the sum of products; factors of 0 leave nothing behind."""
    total = tracer.constant(0.0)
    for factor, value in zip(factors, values, strict=True):
        total = total + factor * value
    return total


def traced_body(parameters: list[Scalar]) -> Body:
    """Return the body of ten barycentric parameters."""
    m, hx, hy, hz, xx, yy, zz, xy, xz, yz = parameters
    return Body(m, (hx, hy, hz), ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz)))


def traced_placement(tracer: Tracer, placement: Placement) -> tuple[Matrix, Vector]:
    """Return rotation and origin of a frame that does not move."""
    xx, xy, xz, yx, yy, yz, zx, zy, zz = (tracer.constant(value) for value in placement[0])
    x, y, z = (tracer.constant(value) for value in placement[1])
    return ((xx, xy, xz), (yx, yy, yz), (zx, zy, zz)), (x, y, z)
