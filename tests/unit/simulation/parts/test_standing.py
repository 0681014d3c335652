"""Released parts: they hang on what carries them, and what a real part would not do is found."""

from collections.abc import Iterable
from dataclasses import replace

import numpy as np
import pytest

import ropsim
from ropsim import robots
from ropsim.core import Diagnostic
from ropsim.flow import Placement, Recording
from ropsim.model import (
    BeltDrive,
    Box,
    Cell,
    Device,
    FixedObject,
    Gripper,
    Mesh,
    Part,
    Shape,
    SupportLimits,
    Tool,
)
from ropsim.robots import default_controller, load
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.spatial import Pose
from ropsim.workbench import environment_of
from support.cells import one_station, with_station

ARM = load("puma560")
DOWN = np.array([0.0, 1.0, 0.0, 0.0])
NEAR = 1e-6
"""What an ideal arm is off its target [m]."""


def table(name: str, y: float, top: float = 0.3) -> FixedObject:
    return FixedObject(name, Pose(np.array([0.5, y, top - 0.05])), (Shape(Box((0.2, 0.2, 0.1))),))


def part(name: str, y: float, z: float) -> Part:
    return Part(name, np.array([0.06, 0.06, 0.04]), 0.25, Pose(np.array([0.5, y, z])))


CELL = one_station(
    "c",
    ARM,
    default_controller("puma560"),
    tools={"jaws": Tool("jaws", Pose(np.array([0.0, 0.0, 0.12])), 1.0, gripper=Gripper(0.2, 0.2, 0.005))},
    default_tool="jaws",
    parts=(part("a", 0.2, 0.34), part("b", -0.2, 0.34)),
    objects=(table("left", 0.2), table("right", -0.2)),
    start=ARM.home,
)
FETCH = ("mov (500, 200, 440)", "lin (500, 200, 340)", "close", "lin (500, 200, 440)", "mov (500, -150, 460)")


def ran(*lines: str, cell: Cell = CELL) -> Recording:
    text = "\n".join(("program p", "units mm, deg, s", *lines))
    compiled = ropsim.language.compile(text, environment_of(cell))
    assert compiled.icr is not None
    return run(cell, {"robot": compiled.icr}, RunOptions(Fidelity.KINEMATIC))


def put_at(height: float, cell: Cell = CELL) -> Recording:
    """Set part `a` down on the right, beside `b`, with its lower end at a height above the table [m]."""
    return ran(*FETCH, f"lin (500, -110, {340 + 1e3 * height})", "open", "lin (500, -110, 440)", cell=cell)


def last(recording: Recording, name: str) -> Placement:
    return [one for one in recording.placements if one.body == name][-1]


def codes(found: Iterable[Diagnostic]) -> list[str]:
    return [one.code for one in found]


def test_at_the_start_parts_hang_on_what_carries_them() -> None:
    first = {one.body: one.parent for one in ran("wait 1 s").placements}
    assert (first["a"], first["b"]) == ("left", "right")


@pytest.mark.parametrize("height", [0.0, 0.003])
def test_a_part_that_is_set_down_hangs_on_the_support_and_keeps_its_pose(height: float) -> None:
    recording = put_at(height)
    assert codes(recording.findings) == []
    placement = last(recording, "a")
    assert placement.parent == "right"
    X_WO = CELL.objects[1].X_PO @ placement.X_PB
    np.testing.assert_allclose(X_WO.position, [0.5, -0.11, 0.34 + height], atol=NEAR)


def test_a_part_that_is_released_in_the_air_is_found_with_its_height() -> None:
    recording = put_at(0.042)
    (found,) = recording.findings
    assert (found.code, found.is_error) == ("S736", False)
    assert found.message == (
        "part `a` is released 42.0 mm above `right`; a part counts as lying on what is at most 5 mm below it"
    )
    assert found.span is not None
    assert found.span.line == 9
    assert found.data["pass"] == 1
    assert last(recording, "a").parent == ""


def test_where_no_tool_is_in_force_one_is_to_be_chosen() -> None:
    recording = ran("close", cell=with_station(CELL, default_tool=""))
    (found,) = recording.findings
    assert (found.code, "no tool is in force" in found.message) == ("S722", True)
    assert found.hint.startswith("choose a tool with a gripper: `set tool NAME`")


def test_above_the_floor_the_height_is_that_above_the_floor() -> None:
    recording = ran(*FETCH, "mov (500, 0, 300)", "open")
    (found,) = recording.findings
    assert "260.0 mm above the floor" in found.message


def test_above_a_belt_the_conveyor_is_named() -> None:
    device = Device(
        "feeder",
        robots.conveyor(1.0, 0.2, 0.1),
        BeltDrive(0.1, 1.0, "", 1.0),
        Pose(np.array([0.2, 0.0, 0.25])),
    )
    recording = ran(*FETCH, "mov (500, 0, 320)", "open", cell=replace(CELL, devices={"feeder": device}))
    (found,) = recording.findings
    assert "is released 30.0 mm above the belt `feeder`; " in found.message


def test_below_everything_nobody_is_told_to_go_lower() -> None:
    raised = replace(CELL, objects=CELL.objects[:1])
    recording = ran(*FETCH, "mov (500, -110, -30)", "open", cell=raised)
    (found,) = [one for one in recording.findings if one.code == "S736"]
    assert "70.0 mm below the floor; " in found.message
    assert found.hint == "set it down on something, or put what carries it into the cell file"


@pytest.mark.parametrize(("height", "expected"), [(-0.0015, []), (-0.004, ["S737"])])
def test_a_part_that_is_pressed_into_the_support_is_found(height: float, expected: list[str]) -> None:
    recording = put_at(height)
    assert codes(recording.findings) == expected
    assert last(recording, "a").parent == "right"
    for found in recording.findings:
        assert "in `right`, 4.0 mm deep, allowed are 2 mm" in found.message


@pytest.mark.parametrize("height", [-0.05, -0.12])
def test_a_part_in_a_body_does_not_hang_in_the_air_too(height: float) -> None:
    """In the second case its lower end is below the table, with nothing but the floor below."""
    (found,) = put_at(height).findings
    assert found.code == "S737"
    assert f"in `right`, {-height * 1e3:.1f} mm deep" in found.message
    assert found.hint.startswith("set it down higher or elsewhere; ")


def test_the_limits_are_those_of_the_cell() -> None:
    wide = replace(CELL, supports=SupportLimits(gap=0.05, depth=0.01))
    assert codes(put_at(0.042, wide).findings) == []
    assert codes(put_at(-0.008, wide).findings) == []
    assert codes(put_at(0.003, replace(CELL, supports=SupportLimits(gap=0.001))).findings) == ["S736"]


def test_without_objects_or_with_a_mesh_nobody_can_know() -> None:
    drawn = FixedObject("m", Pose(), (Shape(Mesh("m.stl")),))
    assert codes(put_at(0.042, replace(CELL, objects=())).findings) == []
    assert codes(put_at(0.042, replace(CELL, objects=(*CELL.objects, drawn))).findings) == []


def test_a_part_that_is_set_on_another_one_comes_along_when_that_is_taken() -> None:
    lines = (
        *FETCH,
        "mov (500, -200, 460)",
        "lin (500, -200, 380)",
        "open",
        "lin (500, -200, 460)",
        "mov (500, -150, 460)",
    )
    stacked = ran(*lines)
    assert codes(stacked.findings) == []
    assert last(stacked, "a").parent == "b"
    # the gripper takes `b` from the side: its grasp point is below `a`
    wide = replace(CELL.first.tools["jaws"], gripper=Gripper(0.2, 0.2, 0.005))
    cell = with_station(CELL, tools={"jaws": wide})
    carried = ran(
        *lines, "mov (500, -200, 460)", "lin (500, -200, 340)", "close", "lin (500, -200, 460)", cell=cell
    )
    moved = [one.body for one in carried.placements if one.time > 0.0]
    assert moved == ["a", "a", "b"]
    assert carried.channels["payload"].values[-1] == pytest.approx(1.5)


def test_an_object_elsewhere_changes_no_bit_of_a_run() -> None:
    far = FixedObject("far", Pose(np.array([3.0, 3.0, 0.1])), (Shape(Box((0.1, 0.1, 0.1))),))
    one, other = put_at(0.0), put_at(0.0, replace(CELL, objects=(far, *CELL.objects)))
    for name, channel in one.channels.items():
        np.testing.assert_array_equal(channel.values, other.channels[name].values)
    assert [placement for placement in other.placements if placement.body != "far"] == list(one.placements)
