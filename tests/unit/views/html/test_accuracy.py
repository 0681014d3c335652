"""Tables on corners and stops in the HTML report say the same of a line as the terminal does of the run."""

import re
from math import nan

from ropsim.views.testing import CornerFigures, StopFigures, corner_table, stop_table


def rows(table: str) -> list[list[str]]:
    """Return the cells of a table, row by row, without its header."""
    found = [
        re.findall(r"<t[dh][^>]*>(.*?)</t[dh]>", row) for row in re.findall(r"<tr>(.*?)</tr>", table, re.S)
    ]
    return found[1:]


def corner(line: int, time: float, zone: float, rounding: float, overshoot: float) -> CornerFigures:
    return CornerFigures("robot", line, 1, time, zone, 0.5 * zone, rounding, overshoot)


def test_each_figure_of_a_stop_is_the_largest_of_its_line_with_its_own_time() -> None:
    stops = (
        StopFigures("robot", 10, 1, 1.0, 0.076, 0.3e-3),
        StopFigures("robot", 10, 2, 2.0, 0.080, 0.2e-3),
        StopFigures("robot", 7, 1, 3.0, 0.0, 0.0),
    )
    assert rows(stop_table(stops)) == [
        ["7", "1", "0.000", "3.00", "0.000", "3.00"],
        ["10", "2", "0.300", "1.00", "0.080", "2.00"],
    ]


def test_a_line_whose_corners_differ_shows_from_where_to_where() -> None:
    corners = (
        corner(20, 1.0, 16.9e-3, 5e-3, 0.4e-3),
        corner(20, 2.0, 25.9e-3, 4e-3, 0.1e-3),
        corner(20, 3.0, 20.0e-3, 6e-3, nan),
    )
    assert rows(corner_table(corners)) == [
        ["20", "3", "16.9 to 25.9", "8.450 to 12.950", "4.000 to 6.000", "0.400", "1.00"]
    ]


def test_corners_that_agree_show_one_number_and_none_where_there_is_no_overshoot() -> None:
    corners = (corner(17, 1.0, 25e-3, 5e-3, nan), corner(17, 2.0, 25e-3, 5e-3, nan))
    assert rows(corner_table(corners)) == [["17", "2", "25.0", "12.500", "5.000", "–", "–"]]
