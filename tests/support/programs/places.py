"""Locations as rotation matrices and positions in the base frame, by the sentences of the manual."""

import math
from dataclasses import dataclass

import numpy as np

from ropsim import robots
from ropsim.kinematics import forward
from ropsim.model import Cell
from ropsim.spatial import Array
from support.cells import one_station
from support.tasks import CELL

Row = tuple[float, float, float]
Matrix = tuple[Row, Row, Row]

IDENTITY: Matrix = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


@dataclass(frozen=True, slots=True)
class Place:
    """A location.

    Attributes:
        turn: orientation of the tool, or of a frame, in the base frame.
        at: position in the base frame [m].
        axes: orientation of the frame in which it was given.
    """

    turn: Matrix
    at: Row
    axes: Matrix = IDENTITY


def rotation(axis: str, angle: float) -> Matrix:
    """Return the rotation about a coordinate axis [rad]."""
    c, s = math.cos(angle), math.sin(angle)
    if axis == "rx":
        return ((1.0, 0.0, 0.0), (0.0, c, -s), (0.0, s, c))
    if axis == "ry":
        return ((c, 0.0, s), (0.0, 1.0, 0.0), (-s, 0.0, c))
    return ((c, -s, 0.0), (s, c, 0.0), (0.0, 0.0, 1.0))


def turned(matrix: Matrix, vector: Row) -> Row:
    """Return matrix · vector."""
    x, y, z = (sum(a * b for a, b in zip(row, vector, strict=True)) for row in matrix)
    return (x, y, z)


def product(a: Matrix, b: Matrix) -> Matrix:
    """Return a · b."""
    x, y, z = (turned(a, column) for column in zip(*b, strict=True))
    rows = tuple(zip(x, y, z, strict=True))
    return (rows[0], rows[1], rows[2])


def inverse(matrix: Matrix) -> Matrix:
    """Return the transpose."""
    rows = tuple(zip(*matrix, strict=True))
    return (rows[0], rows[1], rows[2])


def added(a: Row, b: Row) -> Row:
    """Return a + b."""
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def seen(place: Place, frame: Place) -> Place:
    """Return the numbers that a place has in a frame."""
    back = inverse(frame.turn)
    way = (place.at[0] - frame.at[0], place.at[1] - frame.at[1], place.at[2] - frame.at[2])
    return Place(product(back, place.turn), turned(back, way))


def read_in(numbers: Place, frame: Place) -> Place:
    """Return the place that has these numbers in a frame; it is given in that frame."""
    return Place(
        product(frame.turn, numbers.turn), added(frame.at, turned(frame.turn, numbers.at)), frame.turn
    )


DOWN = rotation("rx", math.pi)
_PALLET = Place(IDENTITY, (CELL.frames["pallet"][0], CELL.frames["pallet"][1], CELL.frames["pallet"][2]))
BASE = Place(IDENTITY, (0.0, 0.0, 0.0))
FRAMES = {
    "base": BASE,
    "pallet": _PALLET,
    "shelf": Place(rotation("rz", math.pi / 2.0), (0.1, 0.05, 0.02)),
    "tilted": read_in(
        Place(
            product(rotation("rz", math.radians(25.0)), rotation("rx", math.radians(30.0))),
            (-0.04, 0.03, 0.01),
        ),
        _PALLET,
    ),
}
INFEED = Place(DOWN, (CELL.locations["infeed"][0], CELL.locations["infeed"][1], CELL.locations["infeed"][2]))

STATION: Cell = one_station("programs", robots.load("puma560"), robots.default_controller("puma560"))
"""The robot that the programs move; it stands in its home position at the start."""


def _tool(q: Array) -> Place:
    """Return where the tool `jaws` is: its length lies along the approach direction."""
    X_BM = forward(STATION.first.robot, q).matrix().tolist()
    turn: Matrix = ((*X_BM[0][:3],), (*X_BM[1][:3],), (*X_BM[2][:3],))
    reach = turned(turn, (0.0, 0.0, CELL.tools["jaws"][2]))
    return Place(turn, added((X_BM[0][3], X_BM[1][3], X_BM[2][3]), reach))


ARM = {
    "home": _tool(STATION.first.robot.home),
    "joints(10, 20, -100, 30, -60, 5)": _tool(np.radians([10.0, 20.0, -100.0, 30.0, -60.0, 5.0])),
}
"""Targets that are no locations, and where the tool is then."""
