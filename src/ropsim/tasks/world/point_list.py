"""Lists of points in files: `points/NAME.csv` with a line of names, one of units and one for each point."""

import csv
import io
from collections.abc import Mapping, Sequence
from pathlib import Path

from ropsim.core import (
    Diagnostic,
    LeadsOutError,
    SourceText,
    Span,
    frozen_dataclass,
    outside_project,
    place_inside,
    read_bytes,
)
from ropsim.tasks.findings.text_diagnostics import POINT_LIST
from ropsim.tasks.terms.expression_text import short_text
from ropsim.tasks.terms.point import Coordinates, typed_numbers, typed_point

COLUMNS = ("name", "x", "y", "z", "pitch", "roll")
UNITS = ("", "mm", "mm", "mm", "deg", "deg")
YAW = ("yaw", "deg")
"""A further column, where a point has a yaw, and its unit; empty where it turns with its azimuth."""
SCALES: Mapping[str, float] = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "inch": 25.4}
"""Millimetres per unit of a length."""
DEGREES: Mapping[str, float] = {"deg": 1.0, "rad": 57.29577951308232}
"""Degrees per unit of an angle."""
MOST_POINTS, MOST_BYTES = 10_000, 2_000_000
_HINT = f"the first line is `{','.join(COLUMNS)}`, the second its units: `{','.join(UNITS)}`; or also yaw"


@frozen_dataclass
class PointList:
    """Named points in their order.

    Attributes:
        name: of the list.
        points: name and numbers [mm, deg].
    """

    name: str
    points: tuple[tuple[str, Coordinates], ...]


def read_point_list(path: Path) -> tuple[PointList | None, tuple[Diagnostic, ...]]:
    """Return the list of a file, None where it cannot be read at all; lines that are wrong are left out."""
    label = path.as_posix()
    try:
        content = read_bytes(path, MOST_BYTES) if path.stat().st_size <= MOST_BYTES else b""
        text = SourceText(label, content.decode("utf-8-sig"))
    except (OSError, UnicodeDecodeError) as error:
        return None, (POINT_LIST.at(None, f"`{label}` cannot be read: {error}", hint=_HINT),)
    return points_of(text, path.stem)


def read_point_lists(folder: Path) -> tuple[Mapping[str, PointList], tuple[Diagnostic, ...]]:
    """Return the lists in `points/*.csv` of a project by name, and their errors."""
    lists: dict[str, PointList] = {}
    findings: list[Diagnostic] = []
    for path in point_files(folder):
        try:
            place_inside(folder, path.relative_to(folder))
        except LeadsOutError as error:
            findings.append(outside_project(path.as_posix(), error))
            continue
        found, wrong = read_point_list(path)
        findings += wrong
        if found is not None:
            lists[found.name] = found
    return lists, tuple(findings)


def point_files(folder: Path) -> tuple[Path, ...]:
    """Return the files of a project that are lists of points, by name."""
    return tuple(sorted(one for one in (folder / "points").glob("*.csv") if one.is_file()))


def points_of(text: SourceText, name: str) -> tuple[PointList | None, tuple[Diagnostic, ...]]:
    """Return the list of a text, None where its first two lines are wrong."""
    try:
        rows = [[cell.strip() for cell in row] for row in csv.reader(io.StringIO("\n".join(text.lines)))]
    except csv.Error as error:  # a cell is longer than any number or name
        return None, (POINT_LIST.at(Span.whole_line(text.name, 1), f"this is no table: {error}", hint=_HINT),)
    heads, units = (*rows[:2], [], [])[:2]
    scales = _scales(heads, units)
    if scales is None:
        span = Span.whole_line(text.name, 1)
        return None, (
            POINT_LIST.at(span, "the columns of the list or their units are not known", hint=_HINT),
        )
    points: list[tuple[str, Coordinates]] = []
    findings: list[Diagnostic] = []
    for number, row in enumerate(rows[2 : 2 + MOST_POINTS], 3):
        values = _numbers(row, scales)
        if values is not None:
            points.append((row[0], values))
        elif any(row):
            message = f"this is no point: {len(scales)} numbers behind a name are needed"
            findings.append(POINT_LIST.at(Span.whole_line(text.name, number), message, hint=_HINT))
    return PointList(name, tuple(points)), tuple(findings)


def points_text(points: Sequence[tuple[str, Coordinates]]) -> str:
    """Return the text of a list; points without pitch and roll leave them empty, a yaw has a column."""
    rows_of = [(name, typed_numbers(point)) for name, point in points]
    has_yaw = any(len(numbers) == 6 for _, numbers in rows_of)
    heads, units = ((*COLUMNS, YAW[0]), (*UNITS, YAW[1])) if has_yaw else (COLUMNS, UNITS)
    rows = [",".join(heads), ",".join(units)]
    for name, numbers in rows_of:
        cells = list(map(short_text, numbers))
        rows.append(",".join([name, *cells, *[""] * (len(heads) - 1 - len(cells))]))
    return "\n".join(rows) + "\n"


def _scales(heads: Sequence[str], units: Sequence[str]) -> tuple[float, ...] | None:
    """Return the factors that convert numbers to millimetres and degrees."""
    if tuple(heads) not in ((*COLUMNS, YAW[0]), COLUMNS, COLUMNS[:4]) or len(units) != len(heads):
        return None
    tables = (SCALES, SCALES, SCALES, DEGREES, DEGREES, DEGREES)
    found = [table.get(unit) for table, unit in zip(tables, units[1:], strict=False)]
    return None if None in found else tuple(one for one in found if one is not None)


def _numbers(row: Sequence[str], scales: Sequence[float]) -> Coordinates | None:
    cells = row[1:]
    while len(cells) > 3 and not cells[-1]:
        cells = cells[:-1]
    try:
        values = [float(cell) for cell in cells]
    except ValueError:
        return None
    if not row[:1] or not row[0] or len(values) not in (3, 5, 6) or len(values) > len(scales):
        return None
    if not all(abs(one) < 1e12 for one in values):
        return None
    return typed_point(tuple(value * scale for value, scale in zip(values, scales, strict=False)))
