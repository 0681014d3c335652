"""A point of a task call: a name or numbers, as people type it, as task text has it, and as a term."""

from math import degrees, radians

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.prolog import Atom, Struct, Term
from ropsim.spatial import Pose, pitch_roll_yaw, quaternion
from ropsim.tasks.terms.expression_text import short_text

_DIGITS = 10
"""Digits of a degree kept of computed angles."""


@frozen_dataclass
class ApproachPose:
    """A point with the approach direction of the tool: X Y Z Pitch Roll Yaw, as people type it.

    It corresponds to `(x, y, z; pitch p, roll r, yaw w)` of the task language: X Y Z Pitch Roll with a yaw in
    place of the azimuth of the point.

    Attributes:
        x: in the units of the program.
        y: also.
        z: also.
        pitch: of the approach direction below the level; 90 points down.
        roll: about the approach direction.
        yaw: azimuth of the approach direction; 0 lies along +x.
    """

    x: float
    y: float
    z: float
    pitch: float
    roll: float
    yaw: float

    @property
    def numbers(self) -> tuple[float, float, float, float, float, float]:
        """Return X Y Z Pitch Roll Yaw."""
        return self.x, self.y, self.z, self.pitch, self.roll, self.yaw


Numbers = tuple[float, ...]
"""Plain numbers of a location in task text: X Y Z, X Y Z Pitch Roll or X Y Z Roll Pitch Yaw."""


@frozen_dataclass
class FramedPoint:
    """A point whose numbers are read in a frame of the cell: `(x, y, z) in pallet`.

    Attributes:
        numbers: X Y Z, X Y Z Pitch Roll or X Y Z Roll Pitch Yaw as task text has them, or an approach pose.
        frame: its name.
    """

    numbers: "Coordinates"
    frame: str


APPROACH_WORDS = ("pitch", "roll", "yaw")
"""Words of the angles of an approach direction, in the order in which they are typed."""
Coordinates = Numbers | ApproachPose
"""Numbers of a point, in the units of the program."""
Given = Coordinates | FramedPoint
"""A point that is given by numbers."""
Point = str | Given
"""Name of a location, or its numbers."""


def typed_point(numbers: Numbers) -> Coordinates:
    """Return the point of typed numbers: X Y Z, X Y Z Pitch Roll or X Y Z Pitch Roll Yaw [mm, deg]."""
    return ApproachPose(*numbers) if len(numbers) == 6 else numbers


def typed_numbers(point: Coordinates) -> Numbers:
    """Return a point as typed: the inverse of `typed_point`.

    Six numbers of task text, which are Roll Pitch Yaw about fixed axes, become Pitch Roll Yaw of the approach
    direction.
    """
    if isinstance(point, ApproachPose):
        return point.numbers
    if len(point) != 6:
        return point
    roll, pitch, yaw = map(radians, point[3:])
    turned = Pose(np.zeros(3), np.array(quaternion.from_zyx(yaw, pitch, roll)))
    return (*point[:3], *(round(degrees(one), _DIGITS) + 0.0 for one in pitch_roll_yaw(turned)))


def point_text(point: Point) -> str:
    """Return a point as written in task text; the word of three angles determines their order."""
    match point:
        case str():
            return point
        case FramedPoint(numbers, frame):
            return f"{point_text(numbers)} in {frame}"
        case ApproachPose():
            x, y, z, pitch, roll, yaw = map(short_text, point.numbers)
            return f"({x}, {y}, {z}; pitch {pitch}, roll {roll}, yaw {yaw})"
        case (x, y, z, roll, pitch, yaw):
            position = ", ".join(map(short_text, (x, y, z)))
            return f"({position}; rpy {' '.join(map(short_text, (roll, pitch, yaw)))})"
    return f"({', '.join(map(short_text, point))})"


def term_of_point(point: Point) -> Term:
    """Return a point as a term in facts: a name, `p(X,Y,Z)`, or this with a list of turns."""
    match point:
        case str():
            return Atom(point)
        case FramedPoint(numbers, frame):
            return Struct("in", (term_of_point(numbers), Atom(frame)))
        case ApproachPose():
            x, y, z, *angles = map(exact_number, point.numbers)
            turns = (Struct(word, (angle,)) for word, angle in zip(APPROACH_WORDS, angles, strict=True))
            return Struct("p", (x, y, z, tuple(turns)))
    return Struct("p", tuple(map(exact_number, point)))


def point_of_term(term: Term) -> Point | None:
    """Return the point of a term, None where it is none."""
    match term:
        case Atom(name):
            return name
        case Struct("in", (Struct("p", values), Atom(frame))):
            coordinates = _coordinates(values)
            return None if coordinates is None else FramedPoint(coordinates, frame)
        case Struct("p", values):
            return _coordinates(values)
    return None


def _coordinates(values: tuple[Term, ...]) -> Coordinates | None:
    match values:
        case (x, y, z, (Struct("rpy", (_, _, _) as angles),)):
            return _floats((x, y, z, *angles))
        case (x, y, z, tuple(turns)):
            approach = _approach_angles(turns)
            numbers = _floats((x, y, z, *approach)) if approach else None
            return None if numbers is None else typed_point(numbers)
    return _floats(values)


def _approach_angles(turns: tuple[Term, ...]) -> tuple[Term, ...]:
    """Return pitch and roll, or pitch, roll and yaw, of the turns of a location; none for other turns."""
    found = {one.name: one.arguments[0] for one in turns if isinstance(one, Struct) and one.arguments}
    words = APPROACH_WORDS[: len(turns)]
    return tuple(found[word] for word in words) if len(words) > 1 and set(found) == set(words) else ()


def _floats(terms: tuple[Term, ...]) -> Numbers | None:
    """Return numbers, None where one of the terms is none."""
    found = tuple(float(one) for one in terms if isinstance(one, int | float))
    return found if len(found) == len(terms) else None


def exact_number(number: float) -> Term:
    """Return a number of a term: whole where it is so in Python."""
    return int(number) if float(number).is_integer() and isinstance(number, int) else float(number)
