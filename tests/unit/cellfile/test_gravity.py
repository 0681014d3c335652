"""`gravity` of the section `cell`: the acceleration of free fall of all stations."""

import numpy as np
import pytest

from ropsim import dynamics
from ropsim.cellfile import asked_in_cell_file, read_cell
from ropsim.core import Diagnostic, SourceText
from ropsim.model import Cell

ROUNDING = 1e-12  # [m/s²], of a rotation
ONE = '[robot]\nmodel = "puma560"\n'
TWO = """
[stations.left]
robot = "puma560"
[stations.right]
robot = "irb120"
base = { position = [1000, 0, 0], rpy = [0, 90, 0] }
[stations.lift]
mechanism = { kind = "slide", low = 0, high = 1, speed = 1, acceleration = 1, mass = 30, size = [99, 99, 9] }
"""
MOON = "[cell]\ngravity = [0, 0, -1.62]\n"


def read(text: str) -> tuple[Cell | None, tuple[Diagnostic, ...]]:
    return read_cell(SourceText("cell.toml", text), "folder")


def cell_of(text: str) -> Cell:
    cell, findings = read(text)
    assert [str(found) for found in findings] == []
    assert cell is not None
    return cell


def test_without_it_things_fall_with_9_81_metres_per_second_squared() -> None:
    np.testing.assert_array_equal(cell_of(ONE).first.robot.gravity, [0.0, 0.0, -9.81])


def test_on_the_moon_an_arm_is_held_with_a_sixth_of_the_torque() -> None:
    here, there = cell_of(ONE).first.robot, cell_of(ONE + MOON).first.robot
    np.testing.assert_allclose(
        dynamics.gravity(there, there.home), dynamics.gravity(here, here.home) * 1.62 / 9.81, atol=1e-9
    )


def test_it_is_that_of_every_station_in_its_own_base_frame() -> None:
    stations = cell_of(TWO + MOON).stations
    np.testing.assert_allclose(stations["left"].robot.gravity, [0.0, 0.0, -1.62], atol=ROUNDING)
    np.testing.assert_allclose(stations["lift"].robot.gravity, [0.0, 0.0, -1.62], atol=ROUNDING)
    # its x axis points down
    np.testing.assert_allclose(stations["right"].robot.gravity, [1.62, 0.0, 0.0], atol=ROUNDING)


def test_it_may_point_anywhere_and_be_nothing() -> None:
    np.testing.assert_array_equal(
        cell_of(ONE + "[cell]\ngravity = [1, -2, 3]\n").first.robot.gravity, [1.0, -2.0, 3.0]
    )
    robot = cell_of(ONE + "[cell]\ngravity = [0, 0, 0]\n").first.robot
    np.testing.assert_allclose(dynamics.gravity(robot, robot.home), np.zeros(6), atol=1e-12)


@pytest.mark.parametrize(
    ("value", "words"),
    [
        ("[0, 0, -981]", "-981 m/s²"),
        ("[0, 0]", "needed are 3"),
        ("-9.81", "a list of numbers"),
        ("[0, 0, nan]", "nan"),
        ('[0, 0, "down"]', "number"),
    ],
)
def test_a_wrong_one_is_a_finding_at_its_place(value: str, words: str) -> None:
    cell, findings = read(f"{ONE}[cell]\ngravity = {value}\n")
    assert cell is None
    (found,) = findings
    assert words in f"{found.message} {found.hint}"
    assert found.span
    assert found.span.line == 4


def test_editors_propose_it() -> None:
    questions, _ = asked_in_cell_file(SourceText("cell.toml", ONE + MOON))
    assert questions["cell", "gravity"].count == 3
