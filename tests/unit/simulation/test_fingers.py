"""Tools of several parts: what they weigh, and fingers that close on what they grip."""

from dataclasses import replace

import numpy as np
import pytest

import ropsim
from ropsim import parts, robots
from ropsim.cellfile import read_cell
from ropsim.core import SourceText
from ropsim.flow import GripEvent, Recording, ReleaseEvent
from ropsim.kinematics import body_poses
from ropsim.model import Cell, Gripper, Part, Payload, Tool, ToolPart, body_tree, combine, start_of
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.spatial import Pose
from ropsim.workbench import environment_of
from support.cells import one_station

ARM = robots.load("puma560")
ROW = 0.04 / 0.25 * 0.004
"""How far the fingers go from one row of a recording to the next at most [m]."""
DOWN = np.array([0.0, 1.0, 0.0, 0.0])
X_MT = Pose(np.array([0.01, 0.0, 0.15]), np.array([0.9, 0.1, 0.2, 0.3]))
FINGERS = parts.parallel_fingers(X_MT, 0.08, 0.01, (0.02, 0.006, 0.05))
JAWS = Tool("jaws", X_MT, 1.0, gripper=Gripper(0.25, 0.5, 0.02, FINGERS))


def cell(size: tuple[float, float, float] = (0.05, 0.03, 0.04)) -> Cell:
    part = Part("box", np.array(size), 0.5, Pose(np.array([0.5, 0.0, 0.5])))
    return one_station(
        "c",
        ARM,
        robots.default_controller(ARM),
        tools={"jaws": replace(JAWS, X_MT=Pose(np.array([0.0, 0.0, 0.15])), gripper=_straight())},
        default_tool="jaws",
        parts=(part,),
        locations={"box": Pose(np.array([0.5, 0.0, 0.5]), DOWN)},
    )


def _straight() -> Gripper:
    fingers = parts.parallel_fingers(Pose(np.array([0.0, 0.0, 0.15])), 0.08, 0.01, (0.02, 0.006, 0.05))
    return Gripper(0.25, 0.5, 0.02, fingers)


def ran(cell: Cell, *lines: str) -> Recording:
    text = "\n".join(["program p", "units mm, deg, s", *lines, ""])
    compiled = ropsim.language.compile(text, environment_of(cell))
    assert compiled.icr is not None, [str(one) for one in compiled.diagnostics]
    return run(cell, {"robot": compiled.icr}, RunOptions(Fidelity.KINEMATIC))


def test_the_inner_sides_of_the_fingers_are_apart_along_y_of_the_tool_by_twice_the_coordinate() -> None:
    made = one_station("c", ARM, robots.default_controller(ARM), tools={"jaws": JAWS}, default_tool="jaws")
    for half in (0.005, 0.02, 0.04):
        at = {name: q[np.newaxis] for name, q in start_of(made).items()} | {"tool:jaws": np.array([[half]])}
        poses = body_poses(body_tree(made), at)
        X_WT = poses["tool:jaws"][0] @ X_MT.matrix()
        places = [np.linalg.inv(X_WT) @ poses[f"tool:jaws/finger{k}"][0] for k in (1, 2)]
        np.testing.assert_allclose(places[0][:3, 3], [0.0, half, 0.0], atol=1e-12)
        np.testing.assert_allclose(places[1][:3, 3], [0.0, -half, 0.0], atol=1e-12)
        np.testing.assert_allclose(places[0][:3, 2], [0.0, 1.0, 0.0], atol=1e-12)  # away from each other
        np.testing.assert_allclose(places[1][:3, 2], [0.0, -1.0, 0.0], atol=1e-12)


@pytest.mark.parametrize(
    ("size", "half"), [((0.05, 0.03, 0.04), 0.015), ((0.05, 0.006, 0.04), 0.005), ((0.05, 0.2, 0.04), 0.04)]
)
def test_fingers_close_on_the_sides_of_the_part_within_their_range(
    size: tuple[float, float, float], half: float
) -> None:
    recording = ran(cell(size), "mov box", "close", "mov home", "open")
    (closed,), (opened,) = recording.events_of(GripEvent), recording.events_of(ReleaseEvent)
    name = "tool:jaws/q"
    assert recording.channels[name].unit == "m"
    assert recording.at(name, closed.time).item() == pytest.approx(0.04, abs=ROW)
    assert recording.at(name, closed.end).item() == pytest.approx(half)
    if half < 0.04:
        middle = recording.at(name, (closed.time + closed.end) / 2.0).item()
        assert middle == pytest.approx((0.04 + half) / 2.0, abs=ROW)
    assert recording.at(name, opened.end).item() == pytest.approx(0.04, abs=ROW)


def test_fingers_that_grip_nothing_close_all_the_way() -> None:
    recording = ran(cell(), "close")
    assert recording.channels["tool:jaws/q"].values[-1, 0] == pytest.approx(0.005)


def test_a_part_turned_in_the_gripper_is_as_wide_as_its_sides_are_there() -> None:
    turned = cell()
    where = {"box": Pose(np.array([0.5, 0.0, 0.5]), np.array([0.0, 1.0, 1.0, 0.0]))}  # a quarter turn about z
    recording = ran(replace(turned, locations=where), "mov box", "close")
    assert recording.channels["tool:jaws/q"].values[-1, 0] == pytest.approx(0.025)


def test_a_tool_weighs_what_its_parts_weigh_together() -> None:
    adapter = Payload(0.6, np.array([0.0, 0.0, 0.02]), np.diag([2e-4, 3e-4, 4e-4]))
    turn = Pose(np.array([0.0, 0.01, 0.03]), np.array([0.5, 0.5, 0.5, 0.5]))  # x to y, y to z, z to x
    tool = Tool("t", mass=1.0, com=np.array([0.0, 0.0, 0.1]), parts=(ToolPart("adapter", turn, adapter),))
    whole = combine(tool.loads)
    assert whole.mass == pytest.approx(1.6)
    np.testing.assert_allclose(whole.com, (np.array([0, 0, 0.1]) + 0.6 * np.array([0.02, 0.01, 0.03])) / 1.6)
    (_, part) = tool.loads
    np.testing.assert_allclose(np.diag(part.inertia), [4e-4, 2e-4, 3e-4], atol=1e-18)


FILE = """
[robot]
model = "puma560"
tool = "jaws"

[tools.jaws]
position = [0, 0, 200]
mass = 1.0
gripper = { fingers = { open = 70, closed = 4, size = [20, 6, 50] } }

[[tools.jaws.parts]]
name = "adapter"
mass = 0.4
com = [0, 0, 15]
shapes = [{ cylinder = { radius = 40, length = 30 }, position = [0, 0, 15] }]
"""


def test_the_cell_file_gives_parts_and_fingers() -> None:
    made, findings = read_cell(SourceText("cell.toml", FILE), "c")
    assert findings == ()
    assert made is not None
    tool = made.first.tools["jaws"]
    assert tool.fingers is not None
    assert (tool.fingers.opened, tool.fingers.closed) == (0.035, 0.002)
    assert combine(tool.loads).mass == pytest.approx(1.4)
    assert len(tool.look) == 1


@pytest.mark.parametrize(
    ("wrong", "code", "line"),
    [
        (("open = 70, closed = 4", "open = 70, closed = 80"), "X806", 9),
        (("open = 70, ", ""), "X803", 9),
        (("closed = 4", "shut = 4"), "X802", 9),
        (('name = "adapter"\n', ""), "X803", 11),
        (("mass = 0.4", "mass = -0.4"), "X806", 13),
    ],
)
def test_what_is_wrong_with_parts_and_fingers_is_said_at_its_place(
    wrong: tuple[str, str], code: str, line: int
) -> None:
    made, findings = read_cell(SourceText("cell.toml", FILE.replace(*wrong)), "c")
    assert made is None
    (found,) = findings
    assert found.span is not None
    assert (found.code, found.span.line) == (code, line)


@pytest.mark.parametrize(
    ("size", "said"),
    [
        ((0.3, 0.2, 0.04), True),
        ((0.3, 0.08, 0.04), False),
        ((0.05, 0.0801, 0.04), True),
        ((0.2, 0.03, 0.1), False),
    ],
)
def test_a_part_wider_than_the_open_fingers_is_taken_with_a_warning(
    size: tuple[float, float, float], said: bool
) -> None:
    """The fingers open to 80 mm along y of the tool, which is that of the part."""
    found = [one for one in ran(cell(size), "lin box", "close").findings if one.code == "S726"]
    assert bool(found) is said
    if said:
        (one,) = found
        assert one.span is not None
        assert one.span.line == 4
        assert (
            f"{size[1] * 1e3:.4g} mm wide between the fingers of `jaws`, which open to 80 mm" in one.message
        )


def test_a_line_that_grips_wide_parts_again_is_named_once() -> None:
    lines = ("repeat 3", "  lin box", "  close", "  open", "endr")
    assert [one.code for one in ran(cell((0.3, 0.2, 0.04)), *lines).findings].count("S726") == 1


def test_grippers_without_fingers_take_parts_of_any_width() -> None:
    made = cell((0.3, 0.2, 0.04))
    station = made.first
    jaws = station.tools["jaws"]
    assert jaws.gripper is not None
    cup = replace(jaws, gripper=replace(jaws.gripper, fingers=None))
    bare = replace(made, stations={"robot": replace(station, tools={"jaws": cup})})
    assert not [one for one in ran(bare, "lin box", "close").findings if one.code == "S726"]
