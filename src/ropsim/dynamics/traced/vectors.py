"""Vector algebra on traced scalars: three-vectors and 3x3 matrices as tuples."""

from collections.abc import Sequence

from ropsim.codegen import Scalar

Vector = tuple[Scalar, Scalar, Scalar]
Matrix = tuple[Vector, Vector, Vector]


def add(a: Vector, b: Vector) -> Vector:
    """Return a + b."""
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def scale(factor: Scalar, a: Vector) -> Vector:
    """Return factor · a."""
    return (factor * a[0], factor * a[1], factor * a[2])


def cross(a: Vector, b: Vector) -> Vector:
    """Return a × b."""
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a: Sequence[Scalar], b: Sequence[Scalar]) -> Scalar:
    """Return a · b; both of the same length, at least 1."""
    total = a[0] * b[0]
    for x, y in zip(a[1:], b[1:], strict=True):
        total = total + x * y
    return total


def column(m: Matrix, k: int) -> Vector:
    """Return column k."""
    return (m[0][k], m[1][k], m[2][k])


def transpose(m: Matrix) -> Matrix:
    """Return the transposed matrix."""
    return (column(m, 0), column(m, 1), column(m, 2))


def apply(m: Matrix, a: Vector) -> Vector:
    """Return m @ a."""
    return (dot(m[0], a), dot(m[1], a), dot(m[2], a))


def product(a: Matrix, b: Matrix) -> Matrix:
    """Return a @ b."""
    rows = transpose(b)
    return (apply(rows, a[0]), apply(rows, a[1]), apply(rows, a[2]))
