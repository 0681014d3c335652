from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.dynamics import Limit, LimitSort, chain_of
from ropsim.flow import Channel
from ropsim.model import Cell, CurrentLimitedAmplifier, RobotModel, VoltageAmplifier, ideal_drive
from ropsim.simulation.verdicts import verdicts
from support.cells import one_station, with_station

ROBOT = robots.load("puma560")
CELL = one_station("c", ROBOT, robots.default_controller("puma560"), start=ROBOT.home)
TIME = np.arange(100.0) / 250.0


def quiet() -> dict[str, Channel]:
    """A recording in which nothing happens; the source line counts up."""
    names = {"qd": 0.0, "q_error": 0.0, "tau": 0.0, "current": 0.0, "voltage": 0.0}
    channels = {name: Channel(np.full((100, 6), value), "") for name, value in names.items()}
    channels["q"] = Channel(np.tile(ROBOT.home, (100, 1)), "rad")
    channels["line"] = Channel(np.arange(100.0), "")
    return channels


def test_an_arm_at_rest_breaks_no_limit() -> None:
    assert verdicts(CELL.first.robot, TIME, quiet(), "a.task") == ()


@pytest.mark.parametrize(
    ("channel", "row", "joint", "value", "code"),
    [
        ("tau", 40, 1, -200.0, "S730"),
        ("current", 41, 2, 9.5, "S731"),
        ("qd", 42, 0, 2.0, "S732"),
        ("q", 43, 5, 5.0, "S733"),
        ("q", 43, 5, -5.0, "S733"),
        ("q_error", 44, 3, -0.11, "S735"),
    ],
)
def test_a_peak_beyond_a_limit_is_found_with_joint_and_line(
    channel: str, row: int, joint: int, value: float, code: str
) -> None:
    channels = quiet()
    channels[channel].values[row, joint] = value
    (found,) = verdicts(CELL.first.robot, TIME, channels, "a.task")
    assert found.code == code
    assert found.span is not None
    assert found.span.line == row
    assert f"joint `{joint + 1}`" in found.message


def test_a_limit_of_a_drive_without_a_page_of_its_own_is_told_by_its_quantity(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A block of a drive may bring any quantity and limit: here one by another name."""
    chain = chain_of(ROBOT.drives[0])
    limits = (Limit("spool", LimitSort.PEAK, "max_current"), Limit("spool", LimitSort.LASTING, "max_current"))
    other = replace(chain, amplifier=replace(chain.amplifier, limits=limits))
    monkeypatch.setattr("ropsim.simulation.verdicts.chain_of", lambda _: other)
    channels = {**quiet(), "spool": Channel(np.zeros((100, 6)), "mm")}
    amplifier = ROBOT.drives[2].amplifier
    assert isinstance(amplifier, VoltageAmplifier)
    most = amplifier.max_current
    channels["spool"].values[20:50, 2] = 1.5 * most
    found = verdicts(CELL.first.robot, TIME, channels, "a.task")
    assert [one.code for one in found] == ["S744", "S745"]
    assert f"spool of joint `3` reached {1.5 * most:.4g} mm, the limit is {most:.4g} mm" in found[0].message
    assert "time at full spool of joint `3` reached 0.12 s" in found[1].message


def test_a_servo_may_overshoot_the_speed_limit_by_two_per_cent() -> None:
    channels = quiet()
    channels["qd"].values[10, 0] = 1.019 * ROBOT.max_speeds[0]
    assert verdicts(CELL.first.robot, TIME, channels, "a.task") == ()
    channels["qd"].values[10, 0] = 1.021 * ROBOT.max_speeds[0]
    assert [found.code for found in verdicts(CELL.first.robot, TIME, channels, "a.task")] == ["S732"]


def test_full_voltage_counts_only_when_it_lasts() -> None:
    channels = quiet()
    channels["voltage"].values[20:30, 3] = 40.0
    assert verdicts(CELL.first.robot, TIME, channels, "a.task") == ()
    channels["voltage"].values[20:35, 3] = -40.0
    (found,) = verdicts(CELL.first.robot, TIME, channels, "a.task")
    assert (found.code, found.data["value"]) == ("S734", pytest.approx(0.060))


def _limited() -> RobotModel:
    """Return the arm with an amplifier at joint 3 that holds its current within 8.8 A."""
    third = replace(ROBOT.drives[2], amplifier=CurrentLimitedAmplifier(40.0, 8.8))
    return replace(ROBOT, drives=(*ROBOT.drives[:2], third, *ROBOT.drives[3:]))


def test_a_current_that_is_held_at_its_limit_counts_when_it_lasts() -> None:
    channels = quiet()
    channels["current"].values[20:32, 2] = 0.995 * 8.8
    assert verdicts(_limited(), TIME, channels, "a.task") == ()
    channels["current"].values[20:35, 2] = -0.995 * 8.8
    (found,) = verdicts(_limited(), TIME, channels, "a.task")
    assert (found.code, found.data["joint"], found.data["value"]) == ("S739", 3, pytest.approx(0.060))
    assert "time at full current of joint `3` reached 0.06 s, the limit is 0.05 s" in found.message
    assert found.span is not None
    assert found.span.line == 34


def test_a_current_below_its_limit_may_last() -> None:
    channels = quiet()
    channels["current"].values[:, 2] = 0.98 * 8.8
    assert verdicts(_limited(), TIME, channels, "a.task") == ()


def test_beside_an_amplifier_that_limits_the_current_others_are_told_how_far_they_went() -> None:
    channels = quiet()
    channels["current"].values[41, [2, 3]] = 9.5
    (found,) = verdicts(_limited(), TIME, channels, "a.task")
    assert (found.code, found.data["joint"]) == ("S731", 4)


def _mixed() -> tuple[Cell, dict[str, Channel]]:
    """Return a cell whose second joint has an ideal drive of 30 N·m, and a recording at rest."""
    drives = (ROBOT.drives[0], ideal_drive(30.0), *ROBOT.drives[2:])
    robot = replace(ROBOT, drives=drives)
    channels = quiet()
    others = ("1", "3", "4", "5", "6")
    for name in ("current", "voltage"):
        channels[name] = Channel(np.zeros((100, 5)), "", others)
    channels["command"] = Channel(np.zeros((100, 1)), "", ("2",))
    return with_station(CELL, robot=robot), channels


def test_a_limit_of_a_drive_is_looked_at_where_the_drive_has_it() -> None:
    cell, channels = _mixed()
    assert verdicts(cell.first.robot, TIME, channels, "a.task") == ()
    channels["current"].values[41, 1] = 9.5  # the second of the joints with a motor current is joint 3
    (found,) = verdicts(cell.first.robot, TIME, channels, "a.task")
    assert (found.code, found.data["joint"]) == ("S731", 3)


def test_an_ideal_drive_at_its_limit_counts_only_when_it_lasts() -> None:
    cell, channels = _mixed()
    channels["command"].values[20:30, 0] = 30.0
    assert verdicts(cell.first.robot, TIME, channels, "a.task") == ()
    channels["command"].values[20:35, 0] = -30.0
    (found,) = verdicts(cell.first.robot, TIME, channels, "a.task")
    assert (found.code, found.data["joint"], found.data["value"]) == ("S740", 2, pytest.approx(0.060))
