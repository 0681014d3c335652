"""Ways of a run: what meets is told with its line, what comes near with its distance."""

from dataclasses import replace
from functools import cache
from itertools import product
from pathlib import Path

import numpy as np
import pytest

import ropsim
from ropsim.collision import Collisions
from ropsim.flow import Recording
from ropsim.model import Box, Cell, FixedObject, Mesh, Prism, Shape
from ropsim.simulation import Fidelity, RunOptions, run, run_collisions
from ropsim.spatial import Pose
from ropsim.workbench import environment_of

EXAMPLES = Path(__file__).parents[3] / "examples"


@cache
def carried_out() -> tuple[Cell, Recording]:
    project = ropsim.open(EXAMPLES / "first_cell")
    assert project.cell is not None
    return project.cell, project.simulate()


def tcp(fraction: float) -> tuple[float, np.ndarray]:
    """Return a recorded time [s], and where the TCP is then in the world [m], shape (3,)."""
    cell, recording = carried_out()
    row = int(fraction * len(recording.time))
    place = recording.channels["attained_position"].values[row]
    return float(recording.time[row]), cell.first.X_WB.matrix()[:3, :3] @ place + cell.first.X_WB.position


def with_block(size: float, place: np.ndarray) -> Cell:
    cell, _ = carried_out()
    block = FixedObject("block", Pose(place), (Shape(Box((size, size, size))),))
    return replace(cell, objects=(*cell.objects, block))


def test_what_is_taken_and_put_down_meets_nothing_on_its_way() -> None:
    cell, recording = carried_out()
    found = run_collisions(recording, cell)
    assert found.findings == ()
    assert found.facts.clearance is not None
    assert found.facts.clearance.distance > 0.0


def test_a_block_on_the_way_is_met_on_a_line_and_at_a_time_of_the_program() -> None:
    _, recording = carried_out()
    time, place = tcp(0.5)
    found = run_collisions(recording, with_block(0.06, place))
    assert {one.code for one in found.findings} == {"S751"}
    assert all("block" in (one.data["one"], one.data["other"]) and one.span for one in found.findings)
    assert any(float(str(one.data["time_s"])) <= time for one in found.findings)
    assert found.facts.clearance is not None
    assert found.facts.clearance.distance < 0.0


@pytest.mark.parametrize("height", [0.25, 0.6])
def test_the_least_distance_is_that_of_every_recorded_state_looked_at_alone(height: float) -> None:
    _, recording = carried_out()
    _, place = tcp(0.5)
    beside = with_block(0.02, place + np.array([0.0, 0.0, height]))
    found = run_collisions(recording, beside)
    assert found.facts.clearance is not None
    alone = Collisions(beside)
    least = np.inf
    for link in ("link4", "link5", "link6"):
        absent = [one.name for one in alone.tree.bodies if one.name not in (link, "block")]
        for q in recording.channels["q"].values[::10]:
            least = min(least, alone.separation(q, absent=absent).distance)
    assert found.facts.clearance.distance <= least + 1e-9


def standing(command: str) -> Recording:
    cell, _ = carried_out()
    compiled = ropsim.language.compile(f"program stand\nunits s\n{command}", environment_of(cell))
    assert compiled.icr is not None
    return run(cell, {cell.first.name: compiled.icr}, RunOptions(Fidelity.KINEMATIC))


def test_a_run_that_takes_no_time_is_checked_where_the_arm_stands() -> None:
    cell, recording = carried_out()
    still, waiting = standing("print 1"), standing("wait 0.1 s")
    assert len(still.time) == 1
    free, later = (run_collisions(one, cell).facts.clearance for one in (still, waiting))
    assert free is not None
    assert later is not None
    assert (free.one, free.other, free.distance) == (later.one, later.other, later.distance)
    place = recording.channels["attained_position"].values[0]
    at_tip = with_block(0.1, cell.first.X_WB.matrix()[:3, :3] @ place + cell.first.X_WB.position)
    met = run_collisions(still, at_tip).facts.met
    assert any("block" in (pair.one, pair.other) for pair in met)
    assert met == run_collisions(waiting, at_tip).facts.met


def test_a_collision_with_a_mesh_says_that_its_hollows_are_filled() -> None:
    cell, recording = carried_out()
    _, place = tcp(0.5)
    mesh = Mesh("block.stl")
    corners = np.array(list(product((-0.03, 0.03), repeat=3)))
    drawn = replace(cell, objects=(*cell.objects, FixedObject("block", Pose(place), (Shape(mesh),))))
    found = run_collisions(recording, drawn, {mesh: corners})
    same = run_collisions(recording, with_block(0.06, place))
    assert [one.message for one in found.findings] == [one.message for one in same.findings]
    assert all("`block` counts without its hollows" in " ".join(one.notes) for one in found.findings)
    assert found.facts.filled == ("block",)
    assert not any(one.notes for one in same.findings)


def test_an_arm_works_in_the_hollow_of_a_prism() -> None:
    """Three walls around the cell, from one outline: their hull would hold the whole arm."""
    cell, recording = carried_out()
    inner, outer = 3.0, 3.2
    outline = (
        (-outer, -outer), (outer, -outer), (outer, outer), (inner, outer),
        (inner, -inner), (-inner, -inner), (-inner, outer), (-outer, outer),
    )  # fmt: skip
    walls = FixedObject("walls", Pose(np.array([0.0, 0.0, -1.0])), (Shape(Prism(outline, 4.0)),))
    found = run_collisions(recording, replace(cell, objects=(*cell.objects, walls)))
    assert found.findings == ()
    assert not any("walls" in (one.one, one.other) for one in found.facts.met)
    place = tcp(0.5)[1] + np.array([0.0, inner + 0.1, -2.0])
    near = FixedObject("walls", Pose(place), walls.shapes)
    touched = run_collisions(recording, replace(cell, objects=(*cell.objects, near)))
    assert any("walls" in one.message for one in touched.findings)


def test_bodies_without_a_shape_are_told() -> None:
    cell, recording = carried_out()
    bare = replace(
        cell.first,
        robot=replace(
            cell.first.robot, links=tuple(replace(one, shapes=()) for one in cell.first.robot.links)
        ),
    )
    undrawn = replace(cell, stations={"robot": bare})
    assert {"link1", "link6"} <= {*run_collisions(recording, undrawn).facts.unseen}
