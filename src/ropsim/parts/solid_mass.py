"""Mass, centre of mass and inertia of shapes that are filled evenly."""

from collections.abc import Iterable, Sequence
from dataclasses import replace
from itertools import pairwise
from math import pi

import numpy as np

from ropsim.model import Box, Cylinder, Payload, Point2, Prism, Revolve, Shape, Sphere, combine, moved
from ropsim.spatial import frozen


def filled(shapes: Iterable[Shape], mass: float | None, density: float = 1.0) -> Payload:
    """Return the rigid body that shapes form; where two overlap, both count.

    Args:
        shapes: in one frame; lines and meshes weigh nothing.
        mass: of the whole [kg]; None for that of the density.
        density: [kg/m³].
    """
    body = combine(tuple(moved(_solid(shape), shape.pose) for shape in shapes))
    whole = density * body.mass if mass is None else mass
    return Payload(whole, body.com, (whole / body.mass if body.mass else 0.0) * body.inertia)


def with_com(load: Payload, height: float | None) -> Payload:
    """Return a body with its centre of mass on the z axis at a height [m]; as it is for None."""
    return load if height is None else replace(load, com=frozen([0.0, 0.0, height]))


def _solid(shape: Shape) -> Payload:
    """Return a solid of density 1 kg/m³ in its own frame."""
    match shape.solid:
        case Box((x, y, z)):
            mass = x * y * z
            squares = np.array([y * y + z * z, z * z + x * x, x * x + y * y])
            return Payload(mass, inertia=np.diag(mass / 12.0 * squares))
        case Cylinder() as one:
            half = one.length / 2.0
            return _turned(((one.radius, -half), (one.top_radius, half)))
        case Sphere(radius):
            mass = 4.0 / 3.0 * pi * radius**3
            return Payload(mass, inertia=0.4 * mass * radius**2 * np.eye(3))
        case Revolve(profile):
            return _turned(profile)
        case Prism(outline, length):
            return _drawn_out(outline, length)
        case _:
            return Payload()


def _turned(profile: Sequence[Point2]) -> Payload:
    """Return a body of revolution: the sum of frustums, negative in a hollow.

    With r(z) linear over a frustum, the integrals of r², z r², z² r² and r⁴ are exact by Gauss-Legendre
    quadrature with three points.
    """
    nodes, weights = np.polynomial.legendre.leggauss(3)
    mass = first = second = axial = 0.0
    for (r0, z0), (r1, z1) in pairwise(profile):
        share = 0.5 * (1.0 + nodes)
        r, z, dz = r0 + share * (r1 - r0), z0 + share * (z1 - z0), 0.5 * (z1 - z0) * weights
        disc = pi * r**2 * dz
        mass += float(disc.sum())
        first += float((disc * z).sum())
        second += float((disc * z**2).sum())
        axial += float((disc * r**2).sum()) / 2.0
    com = first / mass if mass else 0.0
    across = axial / 2.0 + second - mass * com**2
    return Payload(mass, frozen([0.0, 0.0, com]), np.diag([across, across, axial]))


def _drawn_out(outline: Sequence[Point2], length: float) -> Payload:
    """Return a prism, by Green's theorem on its outline."""
    points = np.array(outline)
    x, y = points.T
    x1, y1 = np.roll(points, -1, axis=0).T
    cross = x * y1 - x1 * y
    area = 0.5 * cross.sum()
    cx, cy = ((x + x1) * cross).sum() / (6.0 * area), ((y + y1) * cross).sum() / (6.0 * area)
    xx = (cross * (x * x + x * x1 + x1 * x1)).sum() / 12.0 - area * cx * cx
    yy = (cross * (y * y + y * y1 + y1 * y1)).sum() / 12.0 - area * cy * cy
    xy = (cross * (x * y1 + 2.0 * x * y + 2.0 * x1 * y1 + x1 * y)).sum() / 24.0 - area * cx * cy
    zz = area * length**2 / 12.0
    inertia = length * np.array([[yy + zz, -xy, 0.0], [-xy, xx + zz, 0.0], [0.0, 0.0, xx + yy]])
    return Payload(area * length, frozen([cx, cy, length / 2.0]), inertia)
