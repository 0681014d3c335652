"""Grid of a path of the tool: path parameters, dense where it changes quickly."""

from typing import Protocol, runtime_checkable

import numpy as np

from ropsim.motion.curves.path import ToolPath
from ropsim.spatial import Array

_EVEN = 32
"""Cells of a path of which nothing is known."""

_NEAR = 1e-6
"""Share of a section below which a path parameter is its start or its end."""


@runtime_checkable
class Gridded(Protocol):
    """A path of the tool that defines where it changes quickly; others are sampled evenly."""

    def own_grid(self) -> Array:
        """Return rising path parameters from start to end, with all at which a third derivative jumps.

        Returns:
            the path parameters in the unit of the path, shape (m,).
        """
        ...


def grid(path: ToolPath) -> Array:
    """Return the grid of a path of a length above 0: its own, or an even one, shape (m,)."""
    return path.own_grid() if isinstance(path, Gridded) else np.linspace(0.0, path.length, _EVEN + 1)


def grid_of_part(path: ToolPath, begin: float, length: float) -> Array:
    """Return the grid of a part of a path, in path parameters of the part, shape (m,).

    Args:
        path: the whole path.
        begin: path parameter on it at which the part begins, in its unit.
        length: of the part, in the same unit.
    """
    whole = grid(path) - begin
    near = _NEAR * length
    inside = whole[(whole > near) & (whole < length - near)]
    return np.concatenate(([0.0], inside, [length]))
