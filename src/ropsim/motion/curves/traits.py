"""Traits of paths: properties of a path beyond its points, so that callers need not check its class.

A path of the package may have an attribute of the name; a path of a user, derived from one of ours or not,
counts as one without: it may override the property of the attribute.
"""

import numpy as np

from ropsim.motion.curves.path import JointPath, Path, ToolPath
from ropsim.spatial import Array, frozen


def constant_derivatives(path: Path) -> Array | None:
    """Return the first derivatives of a path that are the same everywhere, None of one that is bent.

    Args:
        path: of the tool (6 numbers, see `ToolPoints`) or of the joints (n numbers).
    """
    found: Array | None = getattr(path, "constant_derivatives", None) if _is_own(path) else None
    return found


def parameter_is_arc_length(path: ToolPath) -> bool | None:
    """Return whether the path parameter is an arc length [m], not an angle; None for another unit."""
    if not _is_own(path):
        return False
    found: bool | None = getattr(path, "moves", False)
    return found


def has_straight_tcp(path: ToolPath | None) -> bool:
    """Return whether the TCP goes on one straight line and the path parameter is its arc length."""
    return _is_own(path) and bool(getattr(path, "has_straight_tcp", False))


def knots_of(path: ToolPath) -> Array:
    """Return the path parameters of the points that a path leads through, at least its ends, shape (k,)."""
    found: Array | None = getattr(path, "knots", None) if _is_own(path) else None
    return np.array([0.0, path.length]) if found is None else found


def end_of(path: JointPath) -> Array:
    """Return the joint coordinates at the end of a path [rad | m], shape (n,)."""
    found: Array | None = getattr(path, "q_end", None) if _is_own(path) else None
    return frozen(path.joints(np.array([path.length])).q[0]) if found is None else found


def _is_own(path: object) -> bool:
    return type(path).__module__.startswith("ropsim.")
