"""Lists of points in files: `points/NAME.csv` with a line of names, one of units and one for each point."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import field
from math import atan2, radians

from ropsim.core import Diagnostic, SourceText, did_you_mean, frozen_dataclass
from ropsim.language import PointTable
from ropsim.spatial import PoseTuple, approach_orientation, quaternion
from ropsim.tasks.findings.text_diagnostics import POINT_LIST, POINT_TWICE
from ropsim.tasks.terms.expression_text import short_text
from ropsim.tasks.terms.point import Coordinates, Numbers, typed_numbers, typed_point
from ropsim.tasks.world.point_cells import (
    LONGEST,
    SEPARATORS,
    CellError,
    Separator,
    cells_of,
    number_of,
    place_of,
    separator_of,
    shown,
)

COLUMNS = ("name", "x", "y", "z", "pitch", "roll")
UNITS = ("", "mm", "mm", "mm", "deg", "deg")
YAW = ("yaw", "deg")
"""A further column, where a point has a yaw, and its unit; empty where it turns with its azimuth."""
SCALES: Mapping[str, float] = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "inch": 25.4}
"""Millimetres per unit of a length."""
DEGREES: Mapping[str, float] = {"deg": 1.0, "rad": 57.29577951308232}
"""Degrees per unit of an angle."""
MOST_POINTS, MOST_FINDINGS = 100_000, 20
LONGEST_NAME = 200
FARTHEST = 1e9
"""Largest number of a point [mm, deg]."""
_QUANTITIES = ("x", "y", "z", "pitch", "roll", YAW[0])
FORM = f"the first line is `{','.join(COLUMNS)}`, the second its units: `{','.join(UNITS)}`; or also yaw"
_WITH_UNIT = re.compile(r"([A-Za-z]+)\s*[\[(]\s*([A-Za-z°]*)\s*[\])]")
"""A title with its unit, such as `x [mm]` or `X (mm)`."""
_SAYS_SEPARATOR = "sep="
"""Begins a line above the titles in which spreadsheets say their separator."""


@frozen_dataclass
class PointList:
    """Named points in their order.

    Attributes:
        name: of the list.
        points: name and numbers [mm, deg]; the name of a point without one is its number, from 1.
        lines: of the points in the text.
        numbers: number of each point that has a name, from 1; of two of one name that of the first.
    """

    name: str
    points: tuple[tuple[str, Coordinates], ...]
    lines: tuple[int, ...] = field(default=(), compare=False)
    numbers: Mapping[str, int] = field(default_factory=dict, compare=False)


def points_of(text: SourceText, name: str) -> tuple[PointList | None, tuple[Diagnostic, ...]]:
    """Return the list of a text, None where its first two lines are wrong; wrong lines are left out."""
    reader = _Reader(text)
    columns = reader.columns()
    if columns is None:
        return None, tuple(reader.findings)
    reader.rows(columns)
    if not reader.findings and not reader.points:
        findings = POINT_LIST.at(text.span(columns.first), "the list has no points", hint=FORM)
        return PointList(name, ()), (findings,)
    return PointList(name, tuple(reader.points), tuple(reader.lines), reader.numbers), tuple(reader.findings)


@frozen_dataclass
class _Columns:
    """Columns of a list.

    Attributes:
        name: index of the one with the names, -1 for none.
        quantities: index and factor to mm or degrees of x, y, z and the angles that there are.
        count: how many columns there are.
        first: number of the first line with a point.
    """

    name: int
    quantities: tuple[tuple[int, float], ...]
    count: int
    first: int


class _Reader:
    """Reads one text; findings beyond `MOST_FINDINGS` are counted only."""

    def __init__(self, text: SourceText) -> None:
        self.text = text
        self.separator = Separator(",")
        self.findings: list[Diagnostic] = []
        self.points: list[tuple[str, Coordinates]] = []
        self.lines: list[int] = []
        self.numbers: dict[str, int] = {}
        self._decimal_sign = ""
        self._wrong = 0

    def columns(self) -> _Columns | None:
        """Read titles and units; None where they are wrong, which is reported."""
        number = self._written(1)
        if self.text.line(number).strip().lower().startswith(_SAYS_SEPARATOR):
            number = self._written(number + 1)
        titles = self.text.line(number).removeprefix("\ufeff")
        self.separator = separator_of(titles)
        try:
            heads, units = self._titles(cells_of(titles, self.separator))
        except CellError as error:
            self._report(number, error)
            return None
        second = self._written(number + 1)
        try:
            cells = cells_of(self.text.line(second), self.separator)
            scales, has_units = self._scales(cells, heads, units)
        except CellError as error:
            self._report(second, error)
            return None
        wanted = tuple(word for word in _QUANTITIES if word in heads)
        places = tuple((heads[word], scales[word]) for word in wanted)
        return _Columns(heads.get("name", -1), places, len(heads), second + has_units)

    def _written(self, number: int) -> int:
        """Return the number of the first line from one on with anything but separators; that one for none."""
        lines = enumerate(self.text.lines[number - 1 :], number)
        return next((k for k, line in lines if line.strip("".join(SEPARATORS) + '\ufeff "\r')), number)

    def rows(self, columns: _Columns) -> None:
        """Read the points."""
        for number, line in enumerate(self.text.lines[columns.first - 1 :], columns.first):
            if not line or line.isspace():
                continue
            if len(self.points) == MOST_POINTS:
                hint = "cut it into several lists"
                self._report(number, CellError(-1, f"a list has at most {MOST_POINTS} points", hint))
                break
            try:
                self._row(number, line, columns)
            except CellError as error:
                self._report(number, error)
        if self._wrong > MOST_FINDINGS:
            message = f"{self._wrong - MOST_FINDINGS} further lines are wrong"
            self.findings.append(POINT_LIST.at(self.text.span(columns.first), message, hint=FORM))

    def _row(self, number: int, line: str, columns: _Columns) -> None:
        if len(line) > LONGEST:
            raise CellError(-1, f"the line has {len(line)} characters, allowed are {LONGEST}", FORM)
        cells = cells_of(line, self.separator)
        if not any(cells):
            return
        if len(cells) > columns.count and any(cells[columns.count :]):
            message = f"{len(cells)} cells found, the list has {columns.count} columns"
            hint = "with decimal commas separate the cells by `;`" if self.separator.sign == "," else FORM
            raise CellError(columns.count, message, hint)
        name = cells[columns.name] if columns.name >= 0 else ""
        if len(name) > LONGEST_NAME:
            message = f"the name has {len(name)} characters, allowed are {LONGEST_NAME}"
            raise CellError(columns.name, message, "shorten it")
        values = self._values(cells, columns)
        self._named(name, number, columns.name)
        self.points.append((name or str(len(self.points) + 1), typed_point(values)))
        self.lines.append(number)

    def _check_sign(self, cell: str, index: int) -> None:
        """Refuse a number with another decimal sign than those before it: it may be one between thousands."""
        sign = "," if "," in cell else "." if "." in cell else ""
        if sign and self._decimal_sign and sign != self._decimal_sign:
            message = f"`{shown(cell)}` has a `{sign}`, numbers before it have a `{self._decimal_sign}`"
            raise CellError(index, message, "use one decimal sign, and none between thousands")
        self._decimal_sign = sign or self._decimal_sign

    def _values(self, cells: Sequence[str], columns: _Columns) -> Numbers:
        """Return the numbers of a point [mm, deg]: angles at its end may be left empty."""
        places = columns.quantities
        given = len(places)
        while given > 3 and not _cell(cells, places[given - 1][0]):
            given -= 1
        if given == 4:
            raise CellError(places[4][0], "pitch and roll stand together", "give both, or leave both empty")
        found = []
        for index, scale in places[:given]:
            cell = _cell(cells, index)
            value = number_of(cell, index, self.separator) * scale
            self._check_sign(cell, index)
            if abs(value) > FARTHEST:
                message = (
                    f"`{shown(cells[index])}` is too large, at most {FARTHEST:g} mm or degrees are allowed"
                )
                raise CellError(index, message, "check the number and its unit")
            found.append(value)
        return tuple(found)

    def _named(self, name: str, line: int, column: int) -> None:
        """Enter the name of the point that comes next; a second one is warned about."""
        if not name:
            return
        known = self.numbers.setdefault(name, len(self.points) + 1)
        if known <= len(self.points) and self._counts():
            message = f"`{shown(name)}` is the name of the point in line {self.lines[known - 1]}, too"
            place = place_of(self.text, line, column, self.separator)
            hint = "names stand for the first point that has them: rename one"
            self.findings.append(POINT_TWICE.at(place, message, hint=hint, data={"found": shown(name)}))

    def _titles(self, cells: Sequence[str]) -> tuple[dict[str, int], dict[str, str]]:
        """Return the index of each column by its title, and the units in titles such as `x [mm]`.

        Raises:
            CellError: a title is unknown or stands twice, or one is missing.
        """
        heads: dict[str, int] = {}
        units: dict[str, str] = {}
        while cells and not cells[-1]:
            cells = cells[:-1]
        for index, cell in enumerate(cells):
            titled = _WITH_UNIT.fullmatch(cell)
            word = (titled[1] if titled else cell).lower()
            allowed = ("name", *_QUANTITIES)
            if word not in allowed:
                hint = did_you_mean(word[:40], allowed) or FORM
                message = f"`{shown(cell)}` is no column of a list, which are {', '.join(allowed)}"
                raise CellError(index, message, hint)
            if word in heads:
                raise CellError(index, f"the column `{word}` stands twice", "leave one out")
            heads[word] = index
            if titled:
                units[word] = titled[2].lower()
        missing = [word for word in ("x", "y", "z") if word not in heads]
        if ("pitch" in heads) != ("roll" in heads) or (YAW[0] in heads and "pitch" not in heads):
            missing += [word for word in ("pitch", "roll") if word not in heads]
        if missing:
            are = "columns {} are" if len(missing) > 1 else "column {} is"
            raise CellError(-1, f"the {are.format(', '.join(missing))} missing", FORM)
        return heads, units

    def _scales(
        self, cells: Sequence[str], heads: Mapping[str, int], titled: Mapping[str, str]
    ) -> tuple[dict[str, float], bool]:
        """Return the factor of each column to mm or degrees, and whether the cells are units.

        They need not be if all titles have their units.

        Args:
            cells: of the line behind the titles.
            heads: index of each column by its title.
            titled: units in titles.

        Raises:
            CellError: a column has no unit, an unknown one, or another one than in its title.
        """
        found: dict[str, float] = {}
        wanted = [one for one in _QUANTITIES if one in heads]
        given = [_cell(cells, heads[one]).lower() for one in wanted]
        named = "name" in heads and _cell(cells, heads["name"])
        has_units = not all(one in titled for one in wanted) or (
            any(given) and not named and all(one in ("", *SCALES, *DEGREES) for one in given)
        )
        without = next((one for one in wanted if one not in titled), "")
        if titled and without and all(_is_number(one, self.separator) for one in given if one):
            kind = "mm" if without in ("x", "y", "z") else "deg"
            message = f"`{without}` has no unit, others have one in their titles"
            raise CellError(heads[without], message, f"write `{without} [{kind}]` as its title")
        for word in wanted:
            index = heads[word]
            unit = (_cell(cells, index) if has_units else "").lower() or titled.get(word, "")
            if unit != titled.get(word, unit):
                message = f"`{word}` is in `{shown(unit)}` here and in `{titled[word]}` by its title"
                raise CellError(index, message, "leave one of the two units out")
            allowed = SCALES if word in ("x", "y", "z") else DEGREES
            if unit not in allowed:
                units = ", ".join(allowed)
                message = f"`{shown(unit)}` is no unit of `{word}`, allowed are {units}"
                if not unit or _is_number(unit, self.separator):
                    message = f"the line below the titles gives no unit of `{word}`, allowed are {units}"
                raise CellError(index, message, FORM)
            found[word] = allowed[unit]
        return found, has_units

    def _counts(self) -> bool:
        """Count one more finding; return whether it is to be reported."""
        self._wrong += 1
        return self._wrong <= MOST_FINDINGS

    def _report(self, number: int, error: CellError) -> None:
        if self._counts():
            place = place_of(self.text, number, error.index, self.separator)
            data = {"line": number, "cell": error.index + 1} if error.index >= 0 else {"line": number}
            self.findings.append(POINT_LIST.at(place, error.message, hint=error.hint or FORM, data=data))


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


def _cell(cells: Sequence[str], index: int) -> str:
    return cells[index] if index < len(cells) else ""


def _is_number(cell: str, separator: Separator) -> bool:
    try:
        number_of(cell, 0, separator)
    except CellError:
        return False
    return True


_DOWN = (0.0, 1.0, 0.0, 0.0)
"""Rx(180°): the tool points straight down in its frame, as for three plain numbers in a program."""


def point_table(listed: PointList, source: str = "") -> PointTable:
    """Return a list as programs use it.

    Poses are those of the same numbers in a program: X Y Z, X Y Z Pitch Roll or X Y Z with pitch, roll and
    yaw of the approach direction. The azimuth of a point with a pitch and no yaw counts in the frame of the
    list.
    """
    poses = tuple([_pose(point) for _, point in listed.points])
    return PointTable(poses, listed.numbers, source, listed.lines)


def _pose(point: Coordinates) -> PoseTuple:
    numbers = typed_numbers(point)
    x, y, z = (one / 1000.0 for one in numbers[:3])
    if len(numbers) == 3:
        return (x, y, z, *_DOWN)
    pitch, roll = radians(numbers[3]), radians(numbers[4])
    yaw = radians(numbers[5]) if len(numbers) == 6 else atan2(y, x)
    return (x, y, z, *quaternion.unit(approach_orientation(pitch, roll, yaw)))
