"""The speed that tool paths reach, and what limits it, in the reports."""

import math
from dataclasses import replace

import pytest

from ropsim.flow import CriticalLimit, LimitQuantity, ReachedSpeed, SpeedCause
from ropsim.views import PathLine, PathMove, PathSummary
from ropsim.views.testing import SpeedFigures, limited_by, path_table, slow_lines

GIVEN = 0.4
FAST = PathMove("robot", 0, 7, 1, 0.0, math.nan, math.nan, math.nan, SpeedFigures(command=GIVEN), GIVEN)
SHORT = replace(
    FAST,
    line=8,
    speeds=SpeedFigures(command=0.1),
    critical=CriticalLimit("", LimitQuantity.JERK, 0.8),
)
"""From stop to stop: no time is lost, and the speed is not reached."""
ZONE = ReachedSpeed(0.2, 0.1, 0.0, 0.25, SpeedCause.ZONE, 0.002, 1.5)
SLOW = replace(FAST, line=9, speeds=SpeedFigures(command=0.2), reached=ZONE)


def lines(*moves: PathMove) -> PathSummary:
    return PathSummary(tuple(PathLine(move.station, move.line, (move,)) for move in moves))


@pytest.mark.parametrize(
    ("move", "words"),
    [
        (FAST, ""),
        (SHORT, "path jerk"),
        (SLOW, "zone"),
        (
            replace(
                SLOW,
                reached=replace(
                    ZONE,
                    cause=SpeedCause.JOINT,
                    joint="4",
                    quantity=LimitQuantity.SPEED,
                    singularity="wrist",
                ),
            ),
            "joint 4 speed, wrist singular",
        ),
    ],
)
def test_a_move_says_what_limits_its_speed(move: PathMove, words: str) -> None:
    assert limited_by(move) == words


def test_the_terminal_names_the_least_share_with_its_limit_and_the_time_that_is_lost() -> None:
    shown = slow_lines(lines(FAST, SHORT, SLOW))
    plain = [one.strip().replace("\xa0", " ") for one in shown]
    assert plain[-3] == "given speed not reached in 2 moves: 100 mm/s of 400 mm/s (line 8 pass 1)"
    assert plain[-2] == "limited by path jerk"
    assert plain[-1] == "time lost against it: 0.25 s; most (line 9 pass 1), zone"
    assert not any("lost" in one for one in slow_lines(lines(FAST, SHORT)))


def test_the_table_has_speed_share_limit_and_lost_time_of_every_line() -> None:
    rows = path_table(lines(FAST, SHORT, SLOW), None).split("<tr>")
    speeds = ("400 of 400, 100 %", "100 of 400, 25 %", "200 of 400, 50 %")
    for shown, row in zip(speeds, rows[2:], strict=True):
        assert shown in row.replace("\xa0", " ")
    assert "path jerk" in rows[3]
    assert "zone" in rows[4]
    assert "0.25" in rows[4]
