"""Task frames of a cell file: in the world, on a positioner, on a carriage, and where they cannot lie."""

import math

import pytest

from ropsim.cellfile import read_cell
from ropsim.core import Diagnostic, SourceText
from ropsim.model import Cell
from ropsim.spatial import quaternion
from ropsim.workbench import environment_of

HEAD = (
    '[robot]\nmodel = "puma560"\n'
    "positioner = { radius = 300, height = 600, base = { position = [0, 1000, 0] } }\n"
)
FRAME = '[frames.fixture]\nposition = [100, 0, 20]\nparent = "positioner"\n'
PLACE = '[locations.corner]\nframe = "fixture"\nposition = [10, 20, 30]\n'


def read(text: str) -> tuple[Cell | None, tuple[Diagnostic, ...]]:
    return read_cell(SourceText("cell.toml", HEAD + text), "folder")


def right(text: str) -> Cell:
    cell, findings = read(text)
    assert [str(one) for one in findings] == []
    assert cell is not None
    return cell


def test_a_frame_on_a_positioner_is_given_in_the_frame_of_its_plate() -> None:
    frame = right(FRAME).frames["fixture"]
    assert frame.parent == "link7"
    assert frame.X_PK.position.tolist() == pytest.approx([0.1, 0.0, 0.02])


def test_a_location_in_it_stays_relative() -> None:
    cell = right(FRAME + PLACE)
    assert (cell.located, cell.given) == ({"corner": "fixture"}, {})
    assert cell.locations["corner"].position.tolist() == pytest.approx([0.01, 0.02, 0.03])


def test_a_frame_in_the_world_has_its_locations_there() -> None:
    cell = right(FRAME.replace('parent = "positioner"\n', "") + PLACE)
    assert (cell.located, cell.frames["fixture"].parent) == ({}, "")
    assert cell.given == {"corner": "fixture"}
    assert cell.locations["corner"].position.tolist() == pytest.approx([0.11, 0.02, 0.05])


DEVICE = (
    '[devices.table]\nkind = "turntable"\ndiameter = 300\nsignal = "go"\nstep = 90\nspeed = 90\n'
    "acceleration = 90\n[signals.go]\noutput = 1\n"
)
OBJECT = '[[objects]]\nname = "bench"\nposition = [500, 0, 100]\nsize = [100, 100, 100]\n'
PART = '[[parts]]\nname = "box"\nsize = [50, 50, 50]\nmass = 1\nposition = [500, 0, 50]\n'


@pytest.mark.parametrize(
    ("text", "code", "line", "words"),
    [
        (FRAME.replace("positioner", "positoner"), "X809", 6, "did you mean `positioner`?"),
        (FRAME.replace("positioner", "track"), "X809", 6, "parent `track` is not defined in this cell"),
        (FRAME.replace("positioner", "fixture"), "X809", 6, "parent `fixture` is not defined"),
        (FRAME.replace('"positioner"', "3"), "X804", 6, "`frames.fixture.parent`"),
        (FRAME.replace("position = [100, 0, 20]\n", ""), "X803", 4, "needs `position`"),
        (FRAME.replace("positioner", "table") + DEVICE, "X826", 6, "cannot lie on `table`"),
        (FRAME.replace("positioner", "bench") + OBJECT, "X826", 6, "external axes: `positioner`"),
        (FRAME + '[classic]\nframe = "fixture"\n', "X826", 8, "frame `fixture` moves with an external axis"),
        (
            FRAME + PLACE + PART + 'destination = { location = "corner" }\n',
            "X826",
            15,
            "location `corner` moves with an external axis",
        ),
    ],
)
def test_each_mistake_gets_one_finding(text: str, code: str, line: int, words: str) -> None:
    cell, findings = read(text)
    assert cell is None
    (found,) = findings
    assert (found.code, found.span and found.span.line) == (code, line)
    assert words in f"{found.message} {found.hint}"


def test_a_station_cannot_have_the_name_of_an_external_axis() -> None:
    """`parent = "positioner"` would mean two bodies."""
    slide = (
        "[stations.positioner]\nbase = { position = [3000, 0, 0] }\n[stations.positioner.mechanism]\n"
        'kind = "slide"\nlow = 0\nhigh = 300\nmass = 5\nspeed = 100\nacceleration = 100\nsize = [50, 50, 5]\n'
    )
    cell, (found,) = read(slide)
    assert cell is None
    assert (found.code, found.message) == (
        "X810",
        "`positioner` is the name of an external axis of this cell",
    )


def test_without_external_axes_a_frame_is_told_what_the_station_needs() -> None:
    text = '[robot]\nmodel = "puma560"\n' + FRAME
    _, (found,) = read_cell(SourceText("cell.toml", text), "folder")
    assert (found.code, found.span and found.span.line) == ("X809", 5)
    assert "give the station a `positioner` or a `track`" in found.hint


def test_programs_are_told_in_which_frame_each_location_is_given() -> None:
    """Seen from the base of the robot, which is turned by 90°."""
    turned = HEAD.replace("positioner", "base = { rpy = [0, 0, 90] }\npositioner")
    still = FRAME.replace('parent = "positioner"\n', "rpy = [0, 0, 30]\n")
    free = "[locations.free]\nposition = [400, 0, 0]\n"
    cell, _ = read_cell(SourceText("cell.toml", turned + still + PLACE + free), "folder")
    assert cell is not None
    given = environment_of(cell).given
    angles = {name: math.degrees(quaternion.to_zyx(frame[3:])[0]) for name, frame in given.items()}
    assert angles == pytest.approx({"corner": -60.0, "free": -90.0})


@pytest.mark.parametrize(
    ("rpy", "up"), [("[0, 0, 90]", (0, 0, 1)), ("[180, 0, 0]", (0, 0, -1)), ("[0, 90, 0]", (-1, 0, 0))]
)
def test_programs_are_told_where_up_is(rpy: str, up: tuple[int, int, int]) -> None:
    turned = HEAD.replace("positioner", f"base = {{ rpy = {rpy} }}\npositioner")
    cell, _ = read_cell(SourceText("cell.toml", turned), "folder")
    assert environment_of(cell).up == pytest.approx(up)
