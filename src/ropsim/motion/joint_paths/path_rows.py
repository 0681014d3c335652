"""Numbers of a path of the joints, as compiled loops that walk several paths take them."""

from typing import NamedTuple

from ropsim.motion.curves.path import JointPath
from ropsim.spatial import Array

TRACED, STRAIGHT, SYNCHRONISED = range(3)
"""Kinds of paths that such loops know: through rows, between two rows, and by profiles of each joint."""


class PathRows(NamedTuple):
    """What a path is made of; others than those of the three kinds are walked one by one.

    Attributes:
        kind: one of the three.
        begin: place of that path at which this one begins, in its unit.
        length: of that path, in its unit.
        size: number of its rows k.
        rows: of n numbers, one behind the other in flat arrays: joint coordinates [rad | m] of all places, or
            of both ends; behind these, of profiles, the three rows of their shapes.
        slopes: first and second derivatives at all places by the number of the row, shape (2, k, n); None of
            paths that are not traced.
    """

    kind: int
    begin: float
    length: float
    size: int
    rows: tuple[Array, ...]
    slopes: Array | None


def rows_of_path(path: JointPath, begin: float = 0.0) -> PathRows | None:
    """Return what compiled loops take of a path from a place on; None of one that they do not know.

    Args:
        path: of the joints.
        begin: the place, in its unit.
    """
    told = getattr(path, "path_rows", None)
    found = told(begin) if told else None
    return found if isinstance(found, PathRows) else None
