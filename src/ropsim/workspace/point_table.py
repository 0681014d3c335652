"""Task points from a table: a line for each, with numbers that are checked."""

import csv
import io
import math
import re
from collections.abc import Sequence

import numpy as np

from ropsim.core import Diagnostic, SourceText, Span, did_you_mean, frozen_dataclass
from ropsim.spatial import approach_orientation, frozen, quaternion
from ropsim.workspace.diagnostics import BAD_POINT, NO_POINTS
from ropsim.workspace.task_point import TaskPoint

LENGTHS = {"mm": 1e-3, "cm": 1e-2, "m": 1.0, "inch": 0.0254}
"""Metres per unit of a length."""
ANGLES = {"deg": math.radians(1.0), "rad": 1.0}
"""Radians per unit of an angle."""
PLACES, TURNS = ("x", "y", "z"), ("roll", "pitch", "yaw")
MOST_POINTS = 10_000
FARTHEST = 1e3
"""Points farther away [m] are no points of a cell."""
FORM = (
    "columns are `name, x, y, z` in mm, and `roll, pitch, yaw` in degrees where the tool is to be turned so"
)
_TITLE = re.compile(r"\s*([a-z_ ]+?)\s*(?:[\[(]\s*([a-z]+)\s*[\])])?\s*", re.IGNORECASE)


@frozen_dataclass
class _Column:
    """Quantity of a column, and the factor to metres or radians."""

    name: str
    factor: float


class _TableError(Exception):
    """The table cannot be read at all; carries why."""

    def __init__(self, diagnostic: Diagnostic) -> None:
        super().__init__(diagnostic.message)
        self.diagnostic = diagnostic


def read_points(text: SourceText) -> tuple[tuple[TaskPoint, ...], tuple[Diagnostic, ...]]:
    """Return the points of a table, and its errors; wrong lines are left out.

    The first line may name the columns, `name, x, y, z, roll, pitch, yaw` in any order and with units as in
    `x [m]`; the second one may contain units. Without titles they are `x, y, z` or `x, y, z, roll, pitch,
    yaw`, behind a name or not. Lengths are in millimetres and angles in degrees. The tool is turned by roll
    about the fixed x, by pitch about y and by yaw about z; without these columns any orientation will do. A
    table with `pitch` before `roll` is a list of points of a project, with angles as in
    `approach_orientation`.
    """
    try:
        rows = [(number, _cells(text, number, line)) for number, line in enumerate(text.lines, start=1)]
        rows = [(number, cells) for number, cells in rows if any(cells) and not cells[0].startswith("#")]
        columns, rest = _columns(text, rows)
    except _TableError as error:
        return (), (error.diagnostic,)
    points: list[TaskPoint] = []
    findings: list[Diagnostic] = []
    for number, cells in rest[:MOST_POINTS]:
        found = _point(text, number, cells, columns, f"p{len(points) + len(findings) + 1}")
        if isinstance(found, Diagnostic):
            findings.append(found)
        else:
            points.append(found)
    if len(rest) > MOST_POINTS:
        message = f"`{text.name}` has {len(rest)} points, at most {MOST_POINTS} are looked at"
        findings.append(BAD_POINT.at(Span.whole_line(text.name, rest[MOST_POINTS][0]), message))
    if not points and not findings:
        findings.append(NO_POINTS.at(None, f"`{text.name}` holds no points", hint=FORM))
    return tuple(points), tuple(findings)


def _cells(text: SourceText, number: int, line: str) -> list[str]:
    separator = next((one for one in (";", "\t") if one in line), ",")
    try:
        row = next(csv.reader(io.StringIO(line), delimiter=separator), [])
    except csv.Error as error:  # a cell is longer than any number or name
        raise _error(text, number, f"this is no table: {error}", FORM) from error
    return [cell.strip() for cell in row]


def _columns(
    text: SourceText, rows: Sequence[tuple[int, list[str]]]
) -> tuple[tuple[_Column, ...], Sequence[tuple[int, list[str]]]]:
    """Return the columns and the lines behind the lines that define them."""
    if not rows:
        return (), rows
    number, cells = rows[0]
    if any(_number(cell) is not None for cell in cells[1:]):
        return _plain(text, number, cells), rows
    titles = [_TITLE.fullmatch(cell) for cell in cells]
    names = [one[1].lower().strip() if one else cells[k] for k, one in enumerate(titles)]
    known = ("name", *PLACES, *TURNS)
    for cell in names:
        if cell not in known:
            hint = did_you_mean(cell, known) or FORM
            raise _error(text, number, f"`{cell[:40]}` is no column that is known", hint)
    if not set(PLACES) <= set(names) or len(set(names)) != len(names):
        raise _error(
            text, number, f"the columns are {', '.join(names)}; x, y and z are needed, each once", FORM
        )
    units = [(one[2] or "").lower() if one else "" for one in titles]
    rest = rows[1:]
    if (
        rest
        and all(cell.lower() in ("", *LENGTHS, *ANGLES) for cell in rest[0][1])
        and len(rest[0][1]) <= len(names)
    ):
        units = [*(cell.lower() for cell in rest[0][1]), *[""] * (len(names) - len(rest[0][1]))]
        rest = rest[1:]
    return tuple(_column(text, number, *one) for one in zip(names, units, strict=True)), rest


def _plain(text: SourceText, number: int, cells: Sequence[str]) -> tuple[_Column, ...]:
    """Return the columns of a table without titles."""
    named = _number(cells[0]) is None
    count = len(cells) - named
    if count not in (3, 6):
        raise _error(text, number, f"a line has {count} numbers, 3 or 6 are needed", FORM)
    names = (*(("name",) if named else ()), *PLACES, *TURNS[: count - 3])
    return tuple(_column(text, number, name, "") for name in names)


def _column(text: SourceText, number: int, name: str, unit: str) -> _Column:
    if name == "name":
        return _Column(name, 0.0)
    units, usual = (LENGTHS, "mm") if name in PLACES else (ANGLES, "deg")
    if (unit or usual) not in units:
        raise _error(text, number, f"`{unit}` is no unit of {name}, known are {', '.join(units)}", FORM)
    return _Column(name, units[unit or usual])


def _point(
    text: SourceText, number: int, cells: Sequence[str], columns: Sequence[_Column], name: str
) -> TaskPoint | Diagnostic:
    """Return the point of a line, or its error."""
    span = Span.whole_line(text.name, number)
    beyond = next((cell for cell in cells[len(columns) :] if cell), None)
    if beyond is not None:
        names = ", ".join(one.name for one in columns)
        message = f"`{beyond[:40]}` stands behind the last column, the columns are {names}"
        return BAD_POINT.at(span, message, hint="the first line tells the columns; " + FORM)
    values: dict[str, float] = {}
    for k, column in enumerate(columns):
        cell = cells[k] if k < len(cells) else ""
        if column.name == "name":
            name = cell or name
            continue
        value = _number(cell)
        if value is None and not cell and column.name in TURNS:
            continue  # free
        if value is None or not math.isfinite(value):
            shown = f"`{cell[:40]}`" if cell else "nothing"
            return BAD_POINT.at(
                span, f"{shown} stands for {column.name}, a finite number is needed", hint=FORM
            )
        values[column.name] = value * column.factor
    position = np.array([values[one] for one in PLACES])
    if np.abs(position).max() > FARTHEST:
        message = (
            f"point `{name}` is {np.abs(position).max():.0f} m away, up to {FARTHEST:.0f} m are looked at"
        )
        return BAD_POINT.at(span, message, hint="lengths are in millimetres where no unit is told")
    if not set(TURNS) & set(values):
        return TaskPoint(name, frozen(position))
    roll, pitch, yaw = (values.get(one, 0.0) for one in TURNS)
    if _is_point_list(columns):
        azimuth = math.atan2(values["y"], values["x"])
        q = approach_orientation(pitch, roll, values.get("yaw", azimuth))
        return TaskPoint(name, frozen(position), frozen(q))
    return TaskPoint(name, frozen(position), frozen(quaternion.from_zyx(yaw, pitch, roll)))


def _is_point_list(columns: Sequence[_Column]) -> bool:
    """Return whether angles stand in the order of lists of points: pitch, roll, yaw."""
    names = [one.name for one in columns]
    return "pitch" in names and "roll" in names and names.index("pitch") < names.index("roll")


def _number(cell: str) -> float | None:
    """Return the number in a cell; NaN and infinity are numbers here, to be reported later.

    Digits are plain digits of tables: Python's own `1_000` and digits of other scripts are no numbers.
    """
    if "_" in cell or not cell.isascii():
        return None
    try:
        return float(cell)
    except ValueError:
        return None


def _error(text: SourceText, number: int, message: str, hint: str) -> _TableError:
    return _TableError(BAD_POINT.at(Span.whole_line(text.name, number), message, hint=hint))
