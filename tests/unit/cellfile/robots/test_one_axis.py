"""Stations of one axis in the cell file: the key `mechanism` in place of `robot`."""

import numpy as np
import pytest

from ropsim.cellfile import read_cell
from ropsim.core import Diagnostic, SourceText
from ropsim.kinematics import body_poses
from ropsim.model import Cell, body_tree
from support.gains import cascaded

ROUNDING = 1e-12  # [m | -], of some products of poses
HEAD = '[stations.shuttle]\nprogram = "shuttle"\n'
SLIDE = (
    "[stations.shuttle.mechanism]\n"
    'kind = "slide"\nlow = 0\nhigh = 600\nsize = [200, 200, 20]\nmass = 20\n'
    "speed = 600\nacceleration = 1500\n"
)


def read(text: str) -> tuple[Cell | None, tuple[Diagnostic, ...]]:
    return read_cell(SourceText("cell.toml", text), "folder")


def right(text: str) -> Cell:
    cell, findings = read(text)
    assert [str(one) for one in findings] == []
    assert cell is not None
    return cell


GATE = HEAD.replace("shuttle", "gate") + SLIDE.replace("shuttle", "gate")


def test_a_station_may_serve_the_others() -> None:
    text = HEAD + SLIDE + GATE.replace("[stations.gate.", "serves = true\n[stations.gate.")
    assert {name: one.serves for name, one in right(text).stations.items()} == {
        "shuttle": False,
        "gate": True,
    }


@pytest.mark.parametrize("other", ["", HEAD.replace('"shuttle"', '""') + SLIDE])
def test_stations_that_serve_need_one_that_works(other: str) -> None:
    text = GATE.replace("[stations.gate.", "serves = true\n[stations.gate.") + other
    _, (found,) = read(text)
    assert (found.code, found.span and found.span.line) == ("X827", 3)
    assert "`gate` would serve" in found.message


def test_a_cell_may_have_no_arm_at_all() -> None:
    station = right(HEAD + SLIDE).first
    assert (station.name, station.program, station.robot.title) == ("shuttle", "shuttle", "Slide")
    assert station.q_start.tolist() == [0.0]


def test_start_controller_and_override_are_as_for_robots() -> None:
    text = (
        HEAD + "start = [200]\nspeed_override = 0.5\n" + SLIDE + "[stations.shuttle.controller]\nkp = [7]\n"
    )
    station = right(text).first
    assert station.q_start.tolist() == pytest.approx([0.2])
    assert station.controller.speed_override == 0.5
    assert cascaded(station.controller).kp.tolist() == [7.0]


def test_it_begins_at_the_limit_that_is_nearest_to_0() -> None:
    assert right(HEAD + SLIDE.replace("low = 0", "low = 50")).first.q_start.tolist() == pytest.approx([0.05])


def test_objects_hang_on_it_by_the_name_of_the_station() -> None:
    thing = '[[objects]]\nname = "tray"\nparent = "shuttle"\nposition = [0, 0, 30]\nsize = [100, 100, 30]\n'
    assert right(HEAD + SLIDE + thing).objects[0].parent == "shuttle/link1"


FRAME = '[frames.tray]\nposition = [0, 0, 0]\nparent = "shuttle"\n'


@pytest.mark.parametrize(
    ("text", "code", "line", "words"),
    [
        (SLIDE.replace('kind = "slide"\n', ""), "X803", 3, "needs `kind`"),
        (SLIDE.replace('"slide"', '"slid"'), "X808", 4, "slide"),
        (SLIDE.replace("low = 0\n", ""), "X803", 3, "needs `low`"),
        (SLIDE.replace("mass = 20\n", ""), "X803", 3, "needs `mass`"),
        (SLIDE.replace("mass", "inertia"), "X803", 3, "needs `mass`"),
        (SLIDE.replace("high = 600", "high = 0"), "X806", 6, "is not above `low`"),
        (SLIDE.replace("high = 600", "high = nan"), "X807", 6, "`nan`"),
        (SLIDE.replace("speed = 600", "speed = 0"), "X806", 9, "speed"),
        (SLIDE.replace("mass = 20", "mass = 0"), "X806", 8, "kg"),
        (SLIDE.replace("size = [200, 200, 20]\n", ""), "X803", 3, "needs `size`"),
        (SLIDE + "reach = 3\n", "X802", 11, "reach"),
        ('robot = "puma560"\n' + SLIDE, "X812", 3, "both say what the station moves"),
        ("start = [900]\n" + SLIDE, "X815", 3, "`E1` would start at 900 mm"),
        ("track = { length = 1000 }\n" + SLIDE, "X802", 3, "track"),
        ("mechanism = 3\n", "X804", 3, "`stations.shuttle.mechanism`"),
        (SLIDE + FRAME, "X826", 13, "a task frame cannot lie on `shuttle`"),
    ],
)
def test_each_mistake_is_told_at_its_place(text: str, code: str, line: int, words: str) -> None:
    cell, findings = read(HEAD + text)
    assert cell is None
    told = [(one.code, one.span and one.span.line, f"{one.message} {one.hint}") for one in findings]
    assert any(one[:2] == (code, line) and words in one[2] for one in told), told
    assert len(told) <= 2


@pytest.mark.parametrize("s", [0.0, 0.25])
def test_objects_on_a_slide_are_given_in_its_base_frame_at_coordinate_0(s: float) -> None:
    """The axis of its joint points along x of the base frame, which points along y of the world here."""
    thing = '[[objects]]\nname = "tray"\nparent = "shuttle"\nposition = [10, 20, 30]\nsize = [100, 100, 30]\n'
    base = "base = { position = [300, 0, 500], rpy = [0, 0, 90] }\n"
    cell = right(HEAD + base + SLIDE + thing)
    pose = body_poses(body_tree(cell), {"shuttle": np.array([[s]])}, ["tray"])["tray"][0]
    expected = np.array([[0, -1, 0, 0.28], [1, 0, 0, 0.01 + s], [0, 0, 1, 0.53], [0, 0, 0, 1]])
    np.testing.assert_allclose(pose, expected, rtol=0.0, atol=ROUNDING)
