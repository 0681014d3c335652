"""Lists of points in a TOML file: lines, outlines of prisms, profiles of revolved bodies."""

from ropsim.model import Point2, Point3
from ropsim.tomltext import diagnostics as kinds
from ropsim.tomltext.checks import TomlTable
from ropsim.tomltext.poses import ORIGIN
from ropsim.tomltext.quantity import Quantity, Units
from ropsim.tomltext.shape_diagnostics import UNFIT_SHAPE

_MOST_POINTS = 200
_LEAST_AREA = 1e-12  # [m²]


def read_points(table: TomlTable, key: str, units: Units, least: int) -> tuple[Point3, ...]:
    """Return at least `least` points [m]; empty where there are fewer."""
    rows = _rows(table, key, (units.position,) * 3, least)
    return tuple((row[0], row[1], row[2]) for row in rows)


def read_outline(table: TomlTable, key: str, units: Units) -> tuple[Point2, ...]:
    """Return a simple polygon [m], counter-clockwise; empty where it is none."""
    points = _flat(_rows(table, key, (units.position,) * 2, 3))
    if not points:
        return ()
    double = _double_area(points)
    crossing = _crossing(points)
    message = ""
    if crossing:
        first, second = crossing
        message = f"edges {first} and {second} of `{table.name_of(key)}` meet"
    elif abs(double) < _LEAST_AREA:
        message = f"`{table.name_of(key)}` encloses no area"
    if message:
        hint = "go round the outline once, without repeating the first point"
        table.findings.add(UNFIT_SHAPE, table.value_span(key), message, hint)
        return ()
    return points if double > 0.0 else points[::-1]


def read_profile(table: TomlTable, key: str, units: Units) -> tuple[Point2, ...]:
    """Return a profile (r, z) [m] that has its body on the left; empty where it is none."""
    radii = units.extent.within(0.0, units.extent.high)
    points = _flat(_rows(table, key, (radii, units.position), 2))
    if points and max(r for r, _ in points) == 0.0:
        message = f"all radii of `{table.name_of(key)}` are 0"
        table.findings.add(UNFIT_SHAPE, table.value_span(key), message, "each point is `[radius, height]`")
        return ()
    closed = (*points, (0.0, points[-1][1]), (0.0, points[0][1])) if points else ()
    return points if _double_area(closed) >= 0.0 else points[::-1]


def _rows(
    table: TomlTable, key: str, columns: tuple[Quantity, ...], least: int
) -> tuple[tuple[float, ...], ...]:
    value = table.values.get(key, []) if key in table else []
    if not isinstance(value, list):
        table.wrong_type((key,), value, "a list of points")
        return ()
    if key in table and not least <= len(value) <= _MOST_POINTS:
        message = f"`{table.name_of(key)}` has {len(value)} points, allowed are {least} to {_MOST_POINTS}"
        table.findings.add(kinds.WRONG_VALUE_COUNT, table.value_span(key), message)
        return ()
    noted = len(table.findings.items)
    rows = tuple(_row(table, (key, k), row, columns) for k, row in enumerate(value))
    return rows if len(table.findings.items) == noted else ()  # no second complaint about stand-ins


def _row(
    table: TomlTable, steps: tuple[str | int, ...], value: object, columns: tuple[Quantity, ...]
) -> tuple[float, ...]:
    if not isinstance(value, list) or len(value) != len(columns):
        table.numbers_at(steps, value, len(columns), columns[-1], ORIGIN)  # notes errors
        return (0.0,) * len(columns)
    cells = zip(value, columns, strict=True)
    return tuple(table.number_at((*steps, k), cell, column, 0.0) for k, (cell, column) in enumerate(cells))


def _flat(rows: tuple[tuple[float, ...], ...]) -> tuple[Point2, ...]:
    return tuple((row[0], row[1]) for row in rows)


def _double_area(points: tuple[Point2, ...]) -> float:
    """Return twice the area of a polygon [m²], positive if it goes round counter-clockwise."""
    pairs = zip(points, (*points[1:], *points[:1]), strict=True)
    return sum(x1 * y2 - x2 * y1 for (x1, y1), (x2, y2) in pairs)


def _crossing(points: tuple[Point2, ...]) -> tuple[int, int] | None:
    """Return the numbers, from 1, of two edges of a polygon that meet and are no neighbours."""
    count = len(points)
    edges = [(points[k], points[(k + 1) % count]) for k in range(count)]
    for i in range(count):
        for j in range(i + 2, count - (i == 0)):
            if _meet(*edges[i], *edges[j]):
                return i + 1, j + 1
    return None


def _meet(a: Point2, b: Point2, c: Point2, d: Point2) -> bool:
    return (
        _side(a, b, c) * _side(a, b, d) <= 0.0
        and _side(c, d, a) * _side(c, d, b) <= 0.0
        and _overlap(a, b, c, d)
    )


def _side(a: Point2, b: Point2, p: Point2) -> float:
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])


def _overlap(a: Point2, b: Point2, c: Point2, d: Point2) -> bool:
    """Return whether the boxes around two edges touch: parallel edges on one line need it."""
    return all(
        max(min(a[k], b[k]), min(c[k], d[k])) <= min(max(a[k], b[k]), max(c[k], d[k])) for k in range(2)
    )
