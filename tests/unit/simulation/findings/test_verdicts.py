import math
from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.core import Diagnostic
from ropsim.dynamics import Column, Limit, LimitSort, chain_of, structure_of
from ropsim.model import CurrentLimitedAmplifier, RobotModel, VoltageAmplifier, ideal_drive
from ropsim.simulation.testing import (
    FinishedStation,
    LogLayout,
    Tally,
    Track,
    full_values,
    judged,
    torn_oil,
    verdicts,
)
from ropsim.spatial import Array

ROBOT = robots.load("puma560")
SCARA = robots.load("scara")
"""Its third joint slides."""
HZ, TICKS = 250, 100


def quiet(robot: RobotModel = ROBOT) -> dict[str, Array]:
    """What is judged of a run in which nothing happens, tick by tick, a column for each joint that has it."""
    layout = judged(structure_of(robot).drives)
    return {field.name: np.zeros((TICKS, len(field.axes))) for field in layout}


def found_in(rows: dict[str, Array], robot: RobotModel = ROBOT) -> tuple[Diagnostic, ...]:
    """Return the verdicts on such a run; the line in force at a tick has its number."""
    layout, full = judged(structure_of(robot).drives), full_values(robot)
    table = np.zeros((TICKS, len(full)))
    for field in layout:
        table[:, field.place] = rows[field.name]
    tally, lines = Tally(layout, len(full)), Track()
    for first in range(0, TICKS, 7):  # however it is cut into slices
        tally.enter(first, table[first : first + 7], full)
    for tick in range(TICKS):
        lines.set(tick - 1, tick)
    station = FinishedStation(robot, "a.task", HZ, TICKS / HZ, tally, lines, Track(), ())
    return (*verdicts(station), *torn_oil(station))


def test_an_arm_at_rest_breaks_no_limit() -> None:
    assert found_in(quiet()) == ()


@pytest.mark.parametrize(
    ("quantity", "tick", "joint", "value", "code"),
    [
        ("tau", 40, 1, -200.0, "S730"),
        ("current", 41, 2, 9.5, "S731"),
        ("qd", 42, 0, 2.0, "S732"),
        ("overrun", 43, 5, 0.3, "S733"),
        ("q_error", 44, 3, -0.11, "S735"),
    ],
)
def test_a_peak_beyond_a_limit_is_found_with_joint_line_and_time(
    quantity: str, tick: int, joint: int, value: float, code: str
) -> None:
    rows = quiet()
    rows[quantity][tick, joint] = value
    (found,) = found_in(rows)
    assert found.code == code
    assert found.span is not None
    assert found.span.line == tick
    assert found.data["time_s"] == tick / HZ
    assert f"joint `{joint + 1}`" in found.message


def test_a_limit_of_a_drive_without_a_page_of_its_own_is_told_by_its_quantity(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A block of a drive may bring any quantity and limit: here one by another name."""
    chain = chain_of(ROBOT.drives[0])
    limits = (Limit("spool", LimitSort.PEAK, "max_current"), Limit("spool", LimitSort.LASTING, "max_current"))
    states = (*chain.motor.states, Column("spool", "mm", "place of a spool"))
    other = replace(
        chain,
        amplifier=replace(chain.amplifier, limits=limits),
        motor=replace(chain.motor, states=states),
    )
    for module in ("findings.verdicts", "servo.judged"):
        monkeypatch.setattr(f"ropsim.simulation.{module}.chain_of", lambda _: other)
    monkeypatch.setattr(LogLayout, "of", lambda _, of=LogLayout.of: of((other,) * ROBOT.n))
    rows = quiet()
    amplifier = ROBOT.drives[2].amplifier
    assert isinstance(amplifier, VoltageAmplifier)
    most = amplifier.max_current
    rows["spool"][20:50, 2] = 1.5 * most
    found = found_in(rows)
    assert [one.code for one in found] == ["S744", "S745"]
    assert f"spool of joint `3` reached {1.5 * most:.4g} mm, the limit is {most:.4g} mm" in found[0].message
    assert "time at full spool of joint `3` reached 0.12 s" in found[1].message


def test_a_servo_may_overshoot_the_speed_limit_by_two_per_cent() -> None:
    rows = quiet()
    rows["qd"][10, 0] = 1.019 * ROBOT.max_speeds[0]
    assert found_in(rows) == ()
    rows["qd"][10, 0] = 1.021 * ROBOT.max_speeds[0]
    assert [found.code for found in found_in(rows)] == ["S732"]


@pytest.mark.parametrize(("error", "codes"), [(0.0999, []), (-0.0999, []), (0.1001, ["S735"])])
def test_a_following_error_is_a_finding_beyond_a_tenth_of_a_radian(error: float, codes: list[str]) -> None:
    rows = quiet()
    rows["q_error"][10, 0] = error
    assert [found.code for found in found_in(rows)] == codes


@pytest.mark.parametrize(("ticks", "codes"), [(12, []), (13, ["S734"])])
def test_full_voltage_may_last_for_fifty_milliseconds(ticks: int, codes: list[str]) -> None:
    rows = quiet()  # 12 ticks of 4 ms are 48 ms
    rows["voltage"][20 : 20 + ticks, 3] = 40.0
    assert [found.code for found in found_in(rows)] == codes


@pytest.mark.parametrize(
    ("quantity", "joint", "value", "told"),
    [
        ("qd", 0, math.radians(1000.0), "speed of joint `1` reached 1000 °/s"),
        ("qd", 2, 2.5, "speed of joint `3` reached 2500 mm/s"),
        ("overrun", 0, math.radians(3.0), "overrun of joint `1` reached 3 °"),
        ("overrun", 2, 0.25, "overrun of joint `3` reached 250 mm"),
        ("q_error", 2, 0.125, "following error of joint `3` reached 125 mm, the limit is 100 mm"),
        ("tau", 0, 5000.0, "torque of joint `1` reached 5000 N·m"),
        ("tau", 2, 5000.0, "torque of joint `3` reached 5000 N,"),
    ],
)
def test_joints_that_turn_are_told_in_degrees_and_those_that_slide_in_millimetres(
    quantity: str, joint: int, value: float, told: str
) -> None:
    rows = quiet(SCARA)
    rows[quantity][10, joint] = value
    (found,) = found_in(rows, SCARA)
    assert told in found.message


def test_full_voltage_counts_only_when_it_lasts() -> None:
    rows = quiet()
    rows["voltage"][20:30, 3] = 40.0
    assert found_in(rows) == ()
    rows["voltage"][20:35, 3] = -40.0
    (found,) = found_in(rows)
    assert (found.code, found.data["value"]) == ("S734", pytest.approx(0.060))


def _limited() -> RobotModel:
    """Return the arm with an amplifier at joint 3 that holds its current within 8.8 A."""
    third = replace(ROBOT.drives[2], amplifier=CurrentLimitedAmplifier(40.0, 8.8))
    return replace(ROBOT, drives=(*ROBOT.drives[:2], third, *ROBOT.drives[3:]))


def test_a_current_that_is_held_at_its_limit_counts_when_it_lasts() -> None:
    rows = quiet()
    rows["current"][20:32, 2] = 0.995 * 8.8
    assert found_in(rows, _limited()) == ()
    rows["current"][20:35, 2] = -0.995 * 8.8
    (found,) = found_in(rows, _limited())
    assert (found.code, found.data["joint"], found.data["value"]) == ("S739", 3, pytest.approx(0.060))
    assert (
        "drive saturated, time at full current of joint `3` reached 0.06 s, the limit is 0.05 s"
        in found.message
    )
    assert found.span is not None
    assert found.span.line == 34


def test_a_current_below_its_limit_may_last() -> None:
    rows = quiet()
    rows["current"][:, 2] = 0.98 * 8.8
    assert found_in(rows, _limited()) == ()


def test_beside_an_amplifier_that_limits_the_current_others_are_told_how_far_they_went() -> None:
    rows = quiet()
    rows["current"][41, [2, 3]] = 9.5
    (found,) = found_in(rows, _limited())
    assert (found.code, found.data["joint"]) == ("S731", 4)


MIXED = replace(ROBOT, drives=(ROBOT.drives[0], ideal_drive(30.0), *ROBOT.drives[2:]))
"""Its second joint has an ideal drive of 30 N·m, without current and voltage."""


def test_a_limit_of_a_drive_is_looked_at_where_the_drive_has_it() -> None:
    rows = quiet(MIXED)
    assert found_in(rows, MIXED) == ()
    rows["current"][41, 1] = 9.5  # the second of the joints with a motor current is joint 3
    (found,) = found_in(rows, MIXED)
    assert (found.code, found.data["joint"]) == ("S731", 3)


def test_an_ideal_drive_at_its_limit_counts_only_when_it_lasts() -> None:
    rows = quiet(MIXED)
    rows["command"][20:30, 0] = 30.0
    assert found_in(rows, MIXED) == ()
    rows["command"][20:35, 0] = -30.0
    (found,) = found_in(rows, MIXED)
    assert (found.code, found.data["joint"], found.data["value"]) == ("S740", 2, pytest.approx(0.060))
