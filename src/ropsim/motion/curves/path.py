"""Paths: the path of a move over its own length, without time; of the tool, or of the joints."""

from typing import Protocol

from ropsim.spatial import Array, record

STANDS = 1e-9  # [m]; a TCP that moves less only turns
FARTHEST = 1e6  # [m, rad]; greater numbers are mistakes, and their squares have no micrometres
STILL = 1e-9  # [rad]; a tool that turns less keeps its orientation


@record
class ToolPoints:
    """The tool at k path parameters of a path, in the reference frame of the path.

    Attributes:
        matrices: homogeneous matrices, shape (k, 4, 4), positions in m.
        d1: first derivatives by the path parameter s, shape (k, 6): of the position [m per unit of s], then
            the angular velocity [rad per unit of s].
        d2: second derivatives by the path parameter, shape (k, 6): of the position, then of the angular
            velocity.
    """

    matrices: Array
    d1: Array
    d2: Array


@record
class JointPoints:
    """The joints at k path parameters of a path.

    Attributes:
        q: joint coordinates [rad | m], shape (k, n).
        d1: first derivatives by the path parameter, shape (k, n).
        d2: second derivatives by the path parameter, shape (k, n).
    """

    q: Array
    d1: Array
    d2: Array


class Path(Protocol):
    """The path of a move over the path parameter s, from 0 to `length`."""

    @property
    def length(self) -> float:
        """Return the length in the path's own unit; 0 where nothing moves, which is no path."""


class ToolPath(Path, Protocol):
    """A path of the tool in its reference frame.

    The path parameter is the arc length of the TCP path [m]; where the TCP stands and the tool only turns,
    the angle [rad].
    """

    def tool(self, s: Array) -> ToolPoints:
        """Return the tool and its derivatives at path parameters s, shape (k,)."""

    def positions(self, s: Array) -> Array:
        """Return where the TCP is at path parameters s, shape (k,) to (k, 3) [m]."""

    def distance(self, points: Array) -> Array:
        """Return how far points, shape (k, 3) [m], are from the path of the TCP, shape (k,) [m]."""


class JointPath(Path, Protocol):
    """A path of all joints."""

    def joints(self, s: Array) -> JointPoints:
        """Return the joints and their derivatives at path parameters s, shape (k,)."""
