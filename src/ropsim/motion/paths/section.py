"""Section of a path of the tool, as a path of its own."""

import numpy as np

from ropsim.motion.curves.grid import Gridded, grid_of_part
from ropsim.motion.curves.nearest import distances
from ropsim.motion.curves.path import ToolPath, ToolPoints
from ropsim.motion.curves.traits import constant_derivatives, parameter_is_arc_length
from ropsim.spatial import Array, record


@record
class ToolSection:
    """The path parameters `begin` to `end` of a path of the tool, counted from 0.

    Attributes:
        path: of the tool.
        begin: its path parameter at the start of the section.
        end: its path parameter at the end of the section, beyond `begin`.
        grid: into how many steps the search for the nearest path parameter divides it at least; with the grid
            of the path, if that has one, it must not turn by more than half a right angle between two steps.
    """

    path: ToolPath
    begin: float
    end: float
    grid: int = 64

    @property
    def length(self) -> float:
        """Return the length in the unit of the path."""
        return self.end - self.begin

    @property
    def constant_derivatives(self) -> Array | None:
        """Return the derivatives of the path, see `constant_derivatives`."""
        return constant_derivatives(self.path)

    @property
    def moves(self) -> bool | None:
        """Return whether the path parameter is an arc length, see `parameter_is_arc_length`."""
        return parameter_is_arc_length(self.path)

    def own_grid(self) -> Array:
        """Return the grid of the path as far as it lies in the section, shape (m,)."""
        return grid_of_part(self.path, self.begin, self.length)

    def tool(self, s: Array) -> ToolPoints:
        """Return the tool and its derivatives at path parameters s, shape (k,)."""
        return self.path.tool(s + self.begin)

    def positions(self, s: Array) -> Array:
        """Return where the TCP is at path parameters s, shape (k,) to (k, 3) [m]."""
        return self.path.positions(s + self.begin)

    def distance(self, points: Array) -> Array:
        """Return how far points, shape (k, 3) [m], are from the path of the TCP, shape (k,) [m]."""
        even = np.linspace(self.begin, self.end, self.grid + 1)
        if isinstance(self.path, Gridded):  # dense where it bends
            even = np.unique(np.concatenate((even, np.minimum(self.begin + self.own_grid(), self.end))))
        return distances(points, self._curve, even)

    def _curve(self, s: Array) -> tuple[Array, Array, Array]:
        rows = self.path.tool(s)
        return rows.matrices[:, :3, 3], rows.d1[:, :3], rows.d2[:, :3]
