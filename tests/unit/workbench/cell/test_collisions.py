"""What is in the way of an arm at a place: postures, depths that are allowed, what is not looked at."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from ropsim.cellfile import read_cell
from ropsim.collision import COARSE, Collisions
from ropsim.core import SourceText
from ropsim.kinematics import frames_batch, inverse
from ropsim.model import Cell
from ropsim.spatial import Array
from ropsim.workbench import CellGeometry, world_state
from ropsim.workbench.testing import CellCollisions, part_places
from support.meshes import stl

CELL = """\
[cell]
name = "c"
[units]
length = "mm"
angle = "deg"
[robot]
model = "puma560"
tool = "jaws"
[tools.jaws]
position = [0, 0, 145]
gripper = {}
shapes = [{ cylinder = { radius = 10, length = 65 }, position = [0, 0, 112.5] }]
[locations]
lies = { position = [400, 100, -200], rpy = [180, 0, 0] }
there = { position = [400, -100, -200], rpy = [180, 0, 0] }
[[parts]]
name = "bolt"
size = [20, 20, 20]
mass = 0.1
position = [400, 100, -200]
"""
TABLE = """
[[objects]]
name = "table"
position = [400, -100, {top}]
shapes = [{{ box = [{width}, {width}, 10], position = [0, 0, -5] }}]
"""
LOOSE = """
[[parts]]
name = "nut"
size = [20, 20, 20]
mass = 0.1
position = [400, -100, -210]
"""


def cell_of(more: str = "") -> Cell:
    cell, findings = read_cell(SourceText("cell.toml", CELL + more), "c")
    assert cell is not None, findings
    return cell


def ball(name: str, place: Array) -> str:
    """Return an object that is a ball at a place [m]."""
    at = [round(1e3 * float(one), 6) for one in place]
    return f'[[objects]]\nname = "{name}"\nposition = {at}\nshapes = [{{ sphere = {{ radius = 20 }} }}]\n'


def in_the_way(more: str) -> str:
    return str(CellGeometry(cell_of(more)).obstruction("arm", "bolt", "there") or "")


@pytest.mark.parametrize(
    ("top", "words"),
    [
        (-220.0, ""),
        (-218.5, ""),
        (-217.0, "the part `bolt` would be 3.0 mm deep in `table`"),
    ],
)
def test_a_part_stands_on_a_table_as_deep_as_the_cell_allows(top: float, words: str) -> None:
    assert in_the_way(TABLE.format(top=top, width=100)) == words


def test_a_cell_says_how_deep_parts_may_stand_in_what_carries_them() -> None:
    table = TABLE.format(top=-217.0, width=100)
    assert in_the_way(table + "[supports]\ndepth = 3.5\n") == ""
    assert in_the_way(table + "[supports]\ndepth = 2.5\n") != ""


def test_what_is_in_each_other_at_the_start_already_refuses_nothing() -> None:
    column = '[[objects]]\nname = "column"\nposition = [0, 0, 0]\nshapes = [{ box = [60, 60, 1500] }]\n'
    assert ("link1", "column") in [one.pair for one in Collisions(cell_of(column)).meetings({})]
    assert in_the_way(column) == ""


def test_of_two_parts_at_one_location_one_lies_there() -> None:
    twin = LOOSE.replace("-100, -210", "100, -198")
    assert part_places(cell_of(twin)) == {"bolt": "lies"}


def test_a_part_that_lies_at_no_location_stands_in_the_way_and_one_that_tasks_move_does_not() -> None:
    assert in_the_way(LOOSE) == "the part `bolt` would be 10.0 mm deep in the part `nut`"
    assert in_the_way(LOOSE.replace("-100, -210", "-100, -200")) == ""


POST = """
[[objects]]
name = "post"
position = [{x}, 100, -160]
shapes = [{{ cylinder = {{ radius = 5, length = 60 }} }}]
"""
STAND = """
[[objects]]
name = "stand"
position = [400, 100, -218]
shapes = [{ box = [100, 100, 10], position = [0, 0, -5] }]
"""


@pytest.mark.parametrize(
    ("more", "words"),
    [
        ("", ""),
        (STAND, ""),  # it is drawn 2 mm deep in it
        (POST.format(x=415.5), ""),
        (POST.format(x=412), "the tool `jaws` would be 3.0 mm deep in `post`"),
    ],
)
def test_who_takes_a_part_meets_what_stands_beside_it_not_what_it_stands_on(more: str, words: str) -> None:
    assert str(CellGeometry(cell_of(more)).obstruction("arm", "bolt", "lies") or "") == words


def test_a_part_that_waits_in_a_supply_is_taken_as_the_first_one_is() -> None:
    lying = CELL[CELL.index("[[parts]]") :]
    queue = lying.replace("[[parts]]", "[[supplies]]") + "count = 2\nrpy = [0, 0, 40]\n"
    cell, findings = read_cell(SourceText("cell.toml", CELL.replace(lying, queue) + STAND), "c")
    assert cell is not None, findings
    state, geometry = world_state(cell), CellGeometry(cell)
    assert [state.holds(one) for one in ("at(bolt_1, lies)", "follows(bolt_2, bolt_1)")] == [True] * 2
    assert [geometry.obstruction("arm", one, "lies") for one in ("bolt_1", "bolt_2")] == [None] * 2


def test_one_posture_that_is_free_is_enough_and_else_the_least_deep_one_is_told() -> None:
    cell = cell_of()
    station, jaws = cell.first, cell.first.tools["jaws"]
    postures = inverse(station.robot, cell.locations["there"] @ jaws.X_MT.inverse()).solutions
    assert len(postures) == 2
    elbows = [ball(f"ball{k}", frames_batch(station.robot, [q])[0, 2, :3, 3]) for k, q in enumerate(postures)]
    assert in_the_way(elbows[0]) == in_the_way(elbows[1]) == ""
    both = cell_of("".join(elbows))
    deepest = [Collisions(both).meetings(q)[0] for q in postures]
    least = max(deepest, key=lambda one: one.distance)
    assert (
        in_the_way("".join(elbows))
        == f"`{least.one}` would be {-1e3 * least.distance:.1f} mm deep in `{least.other}`"
    )


@pytest.mark.parametrize("turn", [0, 30, 40, 120])
def test_parts_beside_each_other_are_as_deep_in_each_other_as_they_are_turned(turn: int) -> None:
    geometry = CellGeometry(cell_of(f"rpy = [0, 0, {turn}]"))
    sides = sorted(map(abs, (np.cos(np.radians(turn)), np.sin(np.radians(turn)))))
    found = geometry.overlap("arm", "bolt", 0.012, 0.0)
    assert found is not None
    assert found.depth == pytest.approx(0.020 - 0.012 * sides[1], abs=COARSE)
    assert found.length == pytest.approx(0.020 / sides[1], abs=COARSE)
    assert geometry.overlap("arm", "bolt", 0.0, found.length) is None
    assert geometry.overlap("arm", "bolt", found.length - 0.0018, 0.0) is None  # a cell allows 2 mm
    assert geometry.overlap("arm", "bolt", found.length - 0.0029, 0.0) is not None
    assert geometry.overlap("nobody", "bolt", 0.012, 0.0) is geometry.overlap("arm", "no", 0.012, 0.0) is None


def test_of_a_place_that_is_unknown_or_out_of_reach_nothing_is_said() -> None:
    geometry = CellGeometry(cell_of(TABLE.format(top=-190.0, width=100)))
    assert geometry.obstruction("arm", "bolt", "there") is not None
    assert geometry.obstruction("arm", "bolt", (400.0, -100.0, -200.0, 180.0, 0.0, 0.0)) is not None
    others = ("lies", "nowhere", "here", (4000.0, 0.0, 0.0))
    assert [geometry.obstruction("arm", "bolt", one) for one in others] == [None] * len(others)
    assert geometry.obstruction("nobody", "bolt", "there") is None


def test_what_is_not_looked_at_is_said() -> None:
    ways = ("collisions on the way between places", "collisions with parts at other places")
    assert CellGeometry(cell_of()).unchecked == ways
    cell = cell_of()
    robot = cell.first.robot
    bare = replace(robot, links=tuple(replace(one, shapes=()) for one in robot.links), base_shapes=())
    undrawn = replace(cell, stations={"robot": replace(cell.first, robot=bare)})
    assert CellGeometry(undrawn).unchecked == (*ways, "collisions of the arm without a known shape")
    wrist = ball("lamp", frames_batch(robot, [cell.first.q_start])[0, 5, :3, 3])
    met = CellGeometry(cell_of(wrist)).unchecked[len(ways) :]
    assert "`link5` in `lamp`, as at the start" in met
    assert all(one.endswith("in `lamp`, as at the start") for one in met)


def test_a_mesh_of_the_project_is_looked_at_and_one_that_is_missing_is_said(tmp_path: Path) -> None:
    mesh = '[[objects]]\nname = "block"\nposition = [400, -100, -205]\nshapes = [{ mesh = "block.stl" }]\n'
    cell = cell_of(mesh)
    assert "collisions of `block` without a known shape" in CellGeometry(cell, tmp_path).unchecked
    corners = np.array([[x, y, z] for x in (-5.0, 5.0) for y in (-5.0, 5.0) for z in (-5.0, 5.0)])
    soup = corners[[[0, 1, 2], [3, 4, 5], [5, 6, 7]]]
    (tmp_path / "block.stl").write_bytes(stl(soup))
    found = CellGeometry(cell, tmp_path).obstruction("arm", "bolt", "there")
    assert str(found) == "the part `bolt` would be 10.0 mm deep in `block`"


def test_barrel_and_rod_of_a_cylinder_are_of_their_arm_and_called_after_the_link_that_it_turns() -> None:
    cell, _ = read_cell(SourceText("cell.toml", '[robot]\nmodel = "patu655"\n'), "c")
    assert cell is not None
    looked = CellCollisions(cell, {})
    assert looked.words("link2/rod") == "the rod of the cylinder that turns `link2`"
    for name in ("link1/barrel", "link1/rod", "link2/barrel", "link2/rod"):
        assert looked.is_moved(cell.first, name, "")
    assert not looked.is_moved(cell.first, "base", "")
