"""Numbers of a path of the joints, for compiled loops that evaluate several paths."""

from typing import NamedTuple

from ropsim.motion.curves.path import JointPath
from ropsim.spatial import Array

TRACED, STRAIGHT, SYNCHRONISED = range(3)
"""Kinds of paths that compiled loops support: through rows, between two rows, and by profiles of each
joint."""


class PathRows(NamedTuple):
    """Data of a path; paths of other kinds are evaluated one by one.

    Attributes:
        kind: one of the three.
        begin: path parameter of that path at which this one begins, in its unit.
        length: of that path, in its unit.
        size: number of its rows k.
        rows: of n numbers, one behind the other in flat arrays: joint coordinates [rad | m] of all path
            parameters, or of both ends; behind these, of profiles, the three rows of their shapes.
        slopes: first and second derivatives at all path parameters, shape (2, k, n); None of paths that are
            not traced.
        parameters: these path parameters, shape (k,); None of paths that are not traced.
    """

    kind: int
    begin: float
    length: float
    size: int
    rows: tuple[Array, ...]
    slopes: Array | None
    parameters: Array | None


def rows_of_path(path: JointPath, begin: float = 0.0) -> PathRows | None:
    """Return the data of a path for compiled loops from a path parameter on; None if unsupported.

    Args:
        path: of the joints.
        begin: the path parameter, in its unit.
    """
    result = getattr(path, "path_rows", None)
    found = result(begin) if result else None
    return found if isinstance(found, PathRows) else None
