"""Destinations in the cell file: poses, locations and grids of places, and what a wrong one is answered."""

import math

import numpy as np
import pytest

from ropsim import icr
from ropsim.cellfile import read_cell
from ropsim.core import Diagnostic, SourceText
from ropsim.model import Destination, Part
from ropsim.spatial import Pose
from support.tasks import compiled

ROBOT = '[robot]\nmodel = "puma560"\n[locations.there]\nposition = [100, 200, 300]\n'
PART = '[[parts]]\nname = "box"\nsize = [60, 60, 40]\nmass = 0.5\nposition = [500, 0, 40]\n'
SUPPLY = PART.replace("parts", "supplies") + "count = 4\n"
LENGTH = 1e-12


def parts_of(text: str) -> tuple[Part, ...]:
    cell, findings = read_cell(SourceText("cell.toml", ROBOT + text), "folder")
    assert findings == ()
    assert cell is not None
    return cell.parts


def goal(text: str) -> Destination:
    (part,) = parts_of(PART + f"destination = {{ {text} }}\n")
    assert part.destination is not None
    return part.destination


def one(text: str) -> Diagnostic:
    _, (found,) = read_cell(SourceText("cell.toml", ROBOT + text), "folder")
    return found


def places(parts: tuple[Part, ...]) -> np.ndarray:
    return np.array([part.destination.X_WO.position for part in parts if part.destination])


def test_without_the_key_a_part_may_end_anywhere() -> None:
    assert [part.destination for part in parts_of(PART + SUPPLY.replace("box", "pin"))] == [None] * 5


def test_a_pose_counts_with_its_orientation() -> None:
    found = goal("position = [1, 2, 3], rpy = [0, 0, 90]")
    assert found.X_WO.position == pytest.approx([0.001, 0.002, 0.003], abs=LENGTH)
    assert found.X_WO.rotation()[:, 0] == pytest.approx([0.0, 1.0, 0.0], abs=LENGTH)
    assert found.distance == pytest.approx(0.005)
    assert found.turn == pytest.approx(math.radians(5.0))


def test_of_a_location_only_the_place_counts_unless_more_is_said() -> None:
    found = goal('location = "there"')
    assert found.X_WO.position == pytest.approx([0.1, 0.2, 0.3], abs=LENGTH)
    assert found.turn is None
    assert goal('location = "there", turn = 10').turn == pytest.approx(math.radians(10.0))
    assert goal('location = "there", rpy = [0, 0, 30]').turn == pytest.approx(math.radians(5.0))


def test_the_parts_of_a_grid_keep_their_distances_and_those_of_a_supply_have_one_place() -> None:
    grid = "grid = { counts = [2, 2], step = [[100, 0, 0], [0, 70, 0]] }\n"
    found = places(parts_of(PART + grid + "destination = { position = [0, 0, 40] }\n"))
    assert found == pytest.approx(
        np.array([[0, 0, 0.04], [0.1, 0, 0.04], [0, 0.07, 0.04], [0.1, 0.07, 0.04]]), abs=LENGTH
    )
    assert len(np.unique(places(parts_of(SUPPLY + "destination = { position = [0, 0, 40] }\n")), axis=0)) == 1


def test_each_part_of_a_supply_has_its_place_in_a_grid() -> None:
    grid = "grid = { counts = [3, 2], step = [[10, 0, 0], [0, 20, 0]] }"
    found = places(parts_of(SUPPLY + f"destination = {{ position = [0, 0, 40], {grid} }}\n"))
    expected = [[0, 0, 0.04], [0.01, 0, 0.04], [0.02, 0, 0.04], [0, 0.02, 0.04]]
    assert found == pytest.approx(np.array(expected), abs=LENGTH)


def test_a_grid_goes_up_in_layers_and_may_be_a_row() -> None:
    layers = "grid = { counts = [2, 1, 2], step = [[10, 0, 0], [0, 20, 0], [0, 0, 30]] }"
    found = places(parts_of(SUPPLY + f"destination = {{ position = [0, 0, 40], {layers} }}\n"))
    expected = [[0, 0, 0.04], [0.01, 0, 0.04], [0, 0, 0.07], [0.01, 0, 0.07]]
    assert found == pytest.approx(np.array(expected), abs=LENGTH)
    flat = layers.replace("2, 1, 2", "2, 2, 1")
    found = places(parts_of(SUPPLY + f"destination = {{ position = [0, 0, 40], {turned(flat, 'snake')} }}\n"))
    expected = [[0, 0, 0.04], [0.01, 0, 0.04], [0.01, 0.02, 0.04], [0, 0.02, 0.04]]
    assert found == pytest.approx(np.array(expected), abs=LENGTH)
    found = places(
        parts_of(SUPPLY + f"destination = {{ position = [0, 0, 40], {turned(layers, 'snake')} }}\n")
    )
    expected = [[0, 0, 0.04], [0.01, 0, 0.04], [0.01, 0, 0.07], [0, 0, 0.07]]
    assert found == pytest.approx(np.array(expected), abs=LENGTH)
    row = "grid = { counts = [3], step = [[0, 20, 0]] }\n"
    assert [part.X_WO.position[1] for part in parts_of(PART + row)] == pytest.approx([0.0, 0.02, 0.04])


def turned(grid: str, order: str) -> str:
    return grid.replace(" }", f', order = "{order}" }}')


@pytest.mark.parametrize("order", ["row", "column", "snake"])
def test_the_places_of_a_grid_are_those_of_a_pattern_in_the_same_order(order: str) -> None:
    supply = SUPPLY.replace("count = 4", "count = 18")
    grid = "grid = { counts = [2, 3, 3], step = [[10, 0, 0], [0, 20, 0], [0, 0, 30]] }"
    found = places(parts_of(supply + f"destination = {{ position = [0, 0, 40], {turned(grid, order)} }}\n"))
    steps = "(10, 0, 0), (0, 20, 0), (0, 0, 30)"
    pattern = f"units mm\npattern g = grid 2 x 3 x 3 from (0, 0, 40) step {steps} order {order}\n"
    code = compiled(pattern + "for each q in g\nlin q\nendf\n").icr
    assert code is not None
    targets = [move.target for move in icr.run(code).moves]
    assert found == pytest.approx(
        np.array([one.position for one in targets if isinstance(one, Pose)]), abs=LENGTH
    )
    assert len(targets) == 18


@pytest.mark.parametrize(
    ("text", "code", "words"),
    [
        ('location = "their"', "X809", "location `their` is not defined"),
        ('location = "there", position = [0, 0, 0]', "X812", "both say where"),
        ("tolerance = 5", "X803", "position"),
        ("position = [0, 0, 0], tolerance = -1", "X806", "tolerance"),
        ("position = [0, 0, 0], tolerance = nan", "X807", "tolerance"),
        ("position = [0, 0, 0], turn = -1", "X806", "turn"),
        ("position = [0, inf, 0]", "X807", "position"),
        ("position = [0, 0, 0], tollerance = 1", "X802", "tollerance"),
        ("position = [0, 0, 0], grid = { counts = [1, 2] }", "X803", "step"),
    ],
)
def test_a_wrong_destination_is_answered_at_its_line(text: str, code: str, words: str) -> None:
    found = one(PART + f"destination = {{ {text} }}\n")
    assert (found.code, found.severity.value) == (code, "error")
    assert words in found.message
    assert found.span is not None
    assert found.span.line == 10


def test_a_grid_may_have_ten_thousand_places() -> None:
    grid = "grid = { counts = [100, 100], step = [[10, 0, 0], [0, 20, 0]] }"
    assert len(parts_of(SUPPLY + f"destination = {{ position = [0, 0, 40], {grid} }}\n")) == 4


def test_too_few_places_are_answered() -> None:
    grid = "grid = { counts = [3, 1], step = [[10, 0, 0], [0, 20, 0]] }"
    found = one(SUPPLY + f"destination = {{ position = [0, 0, 40], {grid} }}\n")
    assert (found.code, found.message) == ("X805", "`supplies.destination.grid` has 3 places for 4 parts")


def test_a_destination_that_is_no_table_is_answered() -> None:
    assert one(PART + "destination = 3\n").code == "X804"
