"""Contacts of a run against an independent evaluator: boxes by separating axes, and depths by hand."""

import re
import shutil
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import numpy.typing as npt
import pytest

import ropsim
from ropsim import collision
from ropsim.flow import Contact, Recording
from ropsim.kinematics import body_poses
from ropsim.model import Box, Cell, FixedObject, Shape, body_tree
from ropsim.simulation import Fidelity, RunCollisions, RunOptions, run_collisions
from ropsim.spatial import Array, Pose
from ropsim.views import summarize, verdict
from support.box_depths import PlacedBox, overlap

EXAMPLES = Path(__file__).parents[3] / "examples"
TOO_LOW = 0.06
"""The frame of the pallet lies so much too low [m]."""
FINGER, BOARD = 0.067, 0.014
"""Length of a finger, and thickness of a board of the pallet, both along z [m]."""
TOUCHING = 1e-4
"""Bodies that are no deeper in each other touch [m]."""
FINE = 1e-4
"""Depths are computed to 0.05 mm [m]."""
ROW = 6e-4
"""The gripper sinks so much from one recorded row to the next: 150 mm/s for 4 ms [m]."""


@cache
def too_low(folder: Path) -> tuple[Cell, Recording]:
    shutil.copytree(EXAMPLES / "palletizing", folder / "low")
    text = (folder / "low" / "cell.toml").read_text()
    text, count = re.subn(
        r"position = \[412.5, -147.5, 560\]", f"position = [412.5, -147.5, {560 - 1e3 * TOO_LOW}]", text
    )
    assert count == 1
    (folder / "low" / "cell.toml").write_text(text)
    project = ropsim.open(folder / "low")
    assert project.cell is not None
    recording = project.simulate(options=RunOptions(Fidelity.KINEMATIC))
    return project.cell, project.checked(recording)


@pytest.fixture(scope="module")
def low(tmp_path_factory: pytest.TempPathFactory) -> tuple[Cell, Recording]:
    return too_low(tmp_path_factory.mktemp("contacts"))


@cache
def first_cell() -> tuple[Cell, Recording]:
    project = ropsim.open(EXAMPLES / "first_cell")
    assert project.cell is not None
    return project.cell, project.simulate(options=RunOptions(Fidelity.KINEMATIC))


def boxes(shapes: tuple[Shape, ...], X: Array) -> list[PlacedBox]:
    """Return rotation (k, 3, 3), centre (k, 3) and half edges (3,) of the boxes of a body at poses."""
    found = []
    for shape in shapes:
        if isinstance(shape.solid, Box):
            here = X @ shape.pose.matrix()
            found.append((here[:, :3, :3], here[:, :3, 3], np.array(shape.solid.size) / 2.0))
    return found


def depths(cell: Cell, recording: Recording, rows: npt.NDArray[np.intp]) -> Array:
    """Return how deep the jaws are in the pallet at rows [m], shape (k,), box by box."""
    tree = body_tree(cell)
    bodies = tree.by_name()
    poses = body_poses(tree, {"robot": recording.channels["q"].values[rows]}, ["tool:jaws"])["tool:jaws"]
    pallet = np.tile(bodies["pallet"].X_PB.matrix(), (len(rows), 1, 1))
    every = [
        overlap(one, other)
        for one in boxes(bodies["tool:jaws"].shapes, poses)
        for other in boxes(bodies["pallet"].shapes, pallet)
    ]
    return np.asarray(np.max(every, axis=0))


def deepest(found: tuple[Contact, ...], one: str) -> Contact:
    return min((each for each in found if each.one == one), key=lambda each: each.distance)


@pytest.mark.slow
def test_a_gripper_that_goes_too_deep_is_one_finding_for_all_passes(low: tuple[Cell, Recording]) -> None:
    _, recording = low
    found = [one for one in recording.findings if one.code == "S751"]
    words = [re.sub(r"\d+\.\d mm", "… mm", one.message) for one in found]
    assert words == [
        "collision box – pallet, … mm deep, line 17 (36 passes)",
        "collision jaws – pallet, … mm deep, line 18 (36 passes)",
    ]
    assert all(one.is_error for one in found)
    judged = verdict(summarize(recording))
    assert judged.text.startswith("failed: collision on lines 17 and 18: jaws – pallet, ")
    assert not recording.ok


@pytest.mark.slow
def test_the_depth_is_that_of_the_boxes_by_separating_axes_and_by_hand(low: tuple[Cell, Recording]) -> None:
    cell, recording = low
    assert recording.facts.ways is not None
    contact = deepest(recording.facts.ways.contacts, "tool:jaws")
    near = np.flatnonzero(np.abs(recording.time - contact.time) < 0.1)
    by_axes = depths(cell, recording, near)
    assert -contact.distance == pytest.approx(by_axes.max(), abs=FINE)
    assert recording.time[near[np.argmax(by_axes)]] == pytest.approx(contact.time, abs=0.011)
    # half of both heights is the greatest depth on the way through: the same shift up and down
    assert -contact.distance == pytest.approx((FINGER + BOARD) / 2.0, abs=ROW)
    every = depths(cell, recording, np.arange(0, len(recording.time), 5))
    assert every.max() <= -contact.distance + FINE


def test_contacts_last_from_the_first_to_the_last_row_in_the_pallet(low: tuple[Cell, Recording]) -> None:
    cell, recording = low
    assert recording.facts.ways is not None
    found = [one for one in recording.facts.ways.contacts if one.one == "tool:jaws"]
    assert [one.visit for one in found] == list(range(1, 37))
    for one in found[::12]:
        inside = (recording.time >= one.begin - 0.05) & (recording.time <= one.end + 0.05)
        rows = np.flatnonzero(inside)
        deep = rows[depths(cell, recording, rows) > TOUCHING]
        assert (recording.time[deep[0]], recording.time[deep[-1]]) == pytest.approx((one.begin, one.end))


def test_the_place_of_a_contact_lies_in_both_bodies(low: tuple[Cell, Recording]) -> None:
    cell, recording = low
    assert recording.facts.ways is not None
    for one in recording.facts.ways.contacts:
        assert one.begin <= one.time <= one.end
        if one.one != "tool:jaws":
            continue
        row = np.array([np.searchsorted(recording.time, one.time)])
        tree = body_tree(cell)
        X = body_poses(tree, {"robot": recording.channels["q"].values[row]}, ["tool:jaws"])["tool:jaws"]
        place = np.array(one.place)
        for name, poses in (("tool:jaws", X), ("pallet", tree.by_name()["pallet"].X_PB.matrix()[None])):
            there = [
                np.abs(R[0].T @ (place - c[0])) - h for R, c, h in boxes(tree.by_name()[name].shapes, poses)
            ]
            assert min(float(each.max()) for each in there) <= FINE


def with_stand(rise: float, clearance: float = 0.0) -> RunCollisions:
    """Return the collisions of first_cell with the stand that takes the box higher by `rise` [m]."""
    cell, recording = first_cell()
    (stand,) = [one for one in cell.objects if one.name == "stand_right"]
    X_WS = Pose(np.array([0.0, 0.0, rise])) @ stand.X_PO
    objects = tuple(replace(one, X_PO=X_WS) if one is stand else one for one in cell.objects)
    placements = tuple(
        replace(one, X_PB=X_WS) if one.body == stand.name else one for one in recording.placements
    )
    changed = replace(cell, objects=objects, clearance=clearance)
    return run_collisions(replace(recording, placements=placements), changed)


def test_a_part_that_is_set_down_touches_and_may_be_as_deep_as_supports_allow() -> None:
    assert with_stand(0.0).findings == ()
    assert with_stand(0.0019).findings == ()


def test_a_part_that_is_pressed_into_what_carries_it_collides() -> None:
    (found,) = with_stand(0.005).findings
    assert re.fullmatch(r"collision box – stand_right, 5\.0 mm deep, line \d+", found.message)
    assert found.is_error


def test_a_tool_that_is_in_something_at_the_start_and_leaves_it_collides_from_the_start() -> None:
    cell, recording = first_cell()
    place = cell.first.X_WB.matrix()[:3, :3] @ recording.channels["attained_position"].values[0]
    block = FixedObject("block", Pose(place + cell.first.X_WB.position), (Shape(Box((0.07, 0.07, 0.02))),))
    found = run_collisions(recording, replace(cell, objects=(*cell.objects, block)))
    assert found.facts.contacts[0].begin == 0.0
    assert found.facts.contacts[0].bodies == "jaws – block"
    assert found.facts.met == ()


def test_what_is_drawn_into_a_link_all_the_time_is_not_checked_and_named() -> None:
    cell, recording = first_cell()
    collar = FixedObject("collar", cell.first.X_WB, (Shape(Box((0.1, 0.1, 1.3))),))
    found = run_collisions(recording, replace(cell, objects=(*cell.objects, collar)))
    assert "collar" not in {name for one in found.facts.contacts for name in (one.one, one.other)}
    assert {"collar"} <= {one.other for one in found.facts.met} | {one.one for one in found.facts.met}


def test_too_near_is_counted_like_a_collision_and_never_beside_it() -> None:
    cell, recording = first_cell()
    plain = run_collisions(recording, cell)
    assert plain.facts.clearance is not None
    least = plain.facts.clearance.distance
    found = run_collisions(recording, replace(cell, clearance=least + 1e-3))
    assert {one.code for one in found.findings} == {"S770"}
    assert min(one.distance for one in found.facts.near) == pytest.approx(least, abs=1e-6)
    assert found.facts.required == pytest.approx(least + 1e-3)
    assert run_collisions(recording, replace(cell, clearance=least - 1e-3)).facts.near == ()
    deep = with_stand(0.02, 0.01)
    assert deep.facts.contacts
    pairs = {(one.bodies, one.line, one.visit) for one in deep.facts.contacts}
    assert pairs.isdisjoint((one.bodies, one.line, one.visit) for one in deep.facts.near)


def test_an_arm_alone_in_its_cell_that_goes_through_itself_collides(tmp_path: Path) -> None:
    (tmp_path / "cell.toml").write_text('[robot]\nmodel = "puma560"\n', "utf-8")
    (tmp_path / "programs").mkdir()
    text = "program p\nunits mm, deg, s\nmov joints (-78, -35, -192, 18, -51, -34)\nmov home\n"
    (tmp_path / "programs" / "main.task").write_text(text, "utf-8")
    project = ropsim.open(tmp_path)
    assert project.cell is not None
    recording = project.simulate(options=RunOptions(Fidelity.KINEMATIC))
    assert "collisions" not in recording.facts.checked
    checked = project.checked(recording)
    assert not checked.ok
    assert {one.code for one in checked.findings if one.is_error} == {"S751"}
    assert checked.facts.ways is not None
    worst = min(one.distance for one in checked.facts.ways.contacts)
    q = np.radians([-78.0, -35.0, -192.0, 18.0, -51.0, -34.0])
    assert worst <= collision.distance(project.cell, q).distance + FINE
    assert worst == pytest.approx(-0.0385, abs=2e-3)
    solids = collision.Collisions(project.cell)
    for one in checked.facts.ways.contacts:
        first, last = (int(np.searchsorted(recording.time, at - 1e-9)) for at in (one.begin, one.end))
        pair = {one.one, one.other}
        for row, is_deep in ((first, True), (first - 1, False), (last, True), (last + 1, False)):
            there = solids.meetings(recording.channels["q"].values[row])
            depth = max((-each.distance for each in there if {*each.pair} == pair), default=0.0)
            assert depth > 0.0 if is_deep else depth <= TOUCHING, (one.bodies, row)
