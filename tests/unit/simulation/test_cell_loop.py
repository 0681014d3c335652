"""The loop of a run in a cell with three tools: which is in force, which grips, what is recorded of them."""

from dataclasses import replace

import numpy as np
import pytest

import ropsim
from ropsim.flow import GripEvent, MoveEvent, Recording, ReleaseEvent
from ropsim.kinematics import forward
from ropsim.model import Cell, Frame, Gripper, Part, Tool
from ropsim.robots import default_controller, load
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.spatial import Pose
from ropsim.workbench import environment_of
from support.cells import one_station, with_station

JAWS = Tool("jaws", Pose(np.array([0.0, 0.0, 0.12])), 2.0, gripper=Gripper(0.2, 0.3, 0.005))
CUP = Tool("cup", Pose(np.array([0.05, 0.0, 0.2])), 0.75, gripper=Gripper(0.4, 0.5, 0.005))
PROBE = Tool("probe", Pose(np.array([0.0, 0.0, 0.15])), 0.1)
PLACE = (0.45, -0.15, 0.1)
DOWN = np.array([0.0, 1.0, 0.0, 0.0])
WIDE = 0.06
"""Edge of the part [m]; its mass is 0.5 kg."""
STRAIGHT = 1e-5
"""An ideal arm leaves the line by what joint splines between two interpolation ticks do [m]."""
FREE = 6.0
"""Ends of all joint ranges, out of the way [rad]."""
ROUNDING = 1e-12
"""Of the end of an event, which is the sum of its time and its duration [s]."""
NEAR = 1e-9
"""Rounding of a pose that goes to joint coordinates and back [m]."""


@pytest.fixture(scope="module")
def cell() -> Cell:
    robot = load("puma560")
    robot = replace(robot, joints=tuple(replace(one, lower=-FREE, upper=FREE) for one in robot.joints))
    part = Part("box", np.full(3, WIDE), 0.5, Pose(np.array(PLACE)))
    tools = {tool.name: tool for tool in (JAWS, CUP, PROBE)}
    return one_station(
        "c",
        robot,
        default_controller("puma560"),
        tools=tools,
        default_tool="jaws",
        parts=(part,),
        start=robot.home,
    )


def ran(cell: Cell, *lines: str) -> Recording:
    text = "\n".join(("program p", "units mm, deg, s", *lines))
    compiled = ropsim.language.compile(text, environment_of(cell))
    assert [str(found) for found in compiled.diagnostics if found.is_error] == []
    assert compiled.icr is not None
    return run(cell, {"robot": compiled.icr}, RunOptions(Fidelity.KINEMATIC, record_hz=1000))


def at(recording: Recording, name: str, time: float) -> np.ndarray:
    """Return the row of a channel that is the first one at or after a time."""
    return np.asarray(recording.rows(name)[np.searchsorted(recording.time, time - 1e-9)])


def codes(recording: Recording) -> list[str]:
    return [found.code for found in recording.findings]


def test_the_payload_follows_each_change_of_tool(cell: Cell) -> None:
    recording = ran(
        cell,
        "wait 1 s",
        "set tool cup",
        "wait 1 s",
        "set tool probe",
        "wait 1 s",
        "set tool jaws",
        "wait 1 s",
    )
    masses = [float(at(recording, "payload", time)) for time in (0.5, 1.5, 2.5, 3.5)]
    assert masses == [2.0, 0.75, 0.1, 2.0]


def test_each_tool_brings_its_own_tip_to_the_place(cell: Cell) -> None:
    recording = ran(cell, "mov (450, -150, 300)", "set tool cup", "mov (450, -150, 300)")
    first, second = recording.events_of(MoveEvent)
    for move, tool in ((first, JAWS), (second, CUP)):
        end = move.time + move.duration
        np.testing.assert_allclose(at(recording, "command_position", end), [0.45, -0.15, 0.3], atol=NEAR)
        flange = forward(cell.first.robot, at(recording, "q_ref", end))
        np.testing.assert_allclose((flange @ tool.X_MT).position, [0.45, -0.15, 0.3], atol=NEAR)


def test_the_pose_is_that_of_the_tool_in_force_from_its_change_on(cell: Cell) -> None:
    """Also where no move follows: the arm stands, the recorded tip is another one."""
    recording = ran(cell, "wait 1 s", "set tool cup", "wait 1 s", "set tool jaws", "mov (450, -150, 300)")
    flange = forward(cell.first.robot, at(recording, "q_ref", 0.0))
    for time, tool in ((0.5, JAWS), (1.5, CUP), (2.0, CUP)):
        tip = (flange @ tool.X_MT).position
        np.testing.assert_allclose(at(recording, "command_position", time), tip, atol=NEAR)
    after = recording.rows("command_position")[np.searchsorted(recording.time, 2.0, side="right")]
    assert np.linalg.norm(after - (flange @ CUP.X_MT).position) > 0.01


def test_the_path_error_is_that_of_the_tip_of_the_tool_in_force(cell: Cell) -> None:
    recording = ran(cell, "set tool cup", "mov (450, -150, 300)", "lin (450, 50, 300)")
    error = recording.channels["path_error"].values
    assert np.isfinite(error).any()
    assert np.nanmax(error) < STRAIGHT


def test_a_tool_that_is_not_the_first_grips_at_its_own_tip_in_its_own_time(cell: Cell) -> None:
    lines = ("set tool cup", "mov (450, -150, 100)", "close", "mov (450, 0, 300)", "open", "wait 1 s")
    recording = ran(cell, *lines)
    assert codes(recording) == []
    (gripped,), (released,) = recording.events_of(GripEvent), recording.events_of(ReleaseEvent)
    assert (gripped.part, released.part) == ("box", "box")
    assert [gripped.duration, released.duration] == pytest.approx([0.5, 0.4])
    masses = [
        float(at(recording, "payload", time)) for time in (gripped.time, released.time, recording.duration)
    ]
    assert masses == [0.75, 1.25, 0.75]


def test_a_gripper_that_is_named_grips_though_another_tool_is_in_force(cell: Cell) -> None:
    # the tip of the cup is brought there; that of the jaws is 80 mm above and 50 mm beside it
    beside = ran(cell, "set tool cup", "mov (450, -150, 100)", "close jaws")
    assert codes(beside) == ["S721"]
    named = ran(cell, "mov (450, -150, 100)", "set tool probe", "close jaws", "open jaws")
    assert codes(named) == []
    assert [event.part for event in named.events_of(GripEvent)] == ["box"]
    assert [event.part for event in named.events_of(ReleaseEvent)] == ["box"]


def test_each_gripper_of_a_flange_holds_a_part_of_its_own(cell: Cell) -> None:
    """A double gripper: the empty one opens without letting go of what the other one holds."""
    (box,) = cell.parts
    other = Part("lid", box.size, 0.3, Pose(np.array([0.45, 0.0, 0.1])))
    two = replace(cell, parts=(box, other))
    take = ("mov (450, -150, 100)", "close", "mov (450, -150, 300)", "open cup", "set tool cup")
    recording = ran(
        two, *take, "mov (450, 0, 100)", "close cup", "mov (450, 0, 300)", "open jaws", "wait 1 s"
    )
    assert [event.part for event in recording.events_of(GripEvent)] == ["box", "lid"]
    assert [event.part for event in recording.events_of(ReleaseEvent)] == ["", "box"]
    assert float(recording.rows("payload")[-1]) == pytest.approx(CUP.mass + other.mass)


@pytest.mark.parametrize("line", ["close", "open", "close probe"])
def test_a_tool_without_a_gripper_grips_nothing_and_takes_no_time(cell: Cell, line: str) -> None:
    recording = ran(cell, "set tool probe", "mov (450, -150, 100)", line)
    assert codes(recording) == ["S722"]
    assert (*recording.events_of(GripEvent), *recording.events_of(ReleaseEvent)) == ()
    assert recording.duration == pytest.approx(recording.events_of(MoveEvent)[0].duration)


def test_the_gripper_channel_says_closed_from_the_end_of_closing_to_the_end_of_opening(cell: Cell) -> None:
    recording = ran(cell, "mov (450, -150, 100)", "close", "wait 1 s", "open", "wait 1 s")
    (gripped,), (released,) = recording.events_of(GripEvent), recording.events_of(ReleaseEvent)
    gripper = recording.channels["gripper"]
    assert gripper.times is not None
    assert gripper.times.tolist() == pytest.approx([0.0, gripped.end, released.end], abs=ROUNDING)
    assert gripper.values.tolist() == [0.0, 1.0, 0.0]


def test_an_arm_without_drives_can_be_run_kinematically(cell: Cell) -> None:
    lines = ("mov (450, -150, 100)", "close", "lin (450, -150, 200)")
    bare = ran(with_station(cell, robot=replace(cell.first.robot, drives=())), *lines)
    driven = ran(cell, *lines)
    assert codes(bare) == []
    np.testing.assert_array_equal(bare.channels["q"].values, driven.channels["q"].values)
    assert bare.events == driven.events


def test_a_cell_that_is_moved_as_a_whole_makes_the_same_run(cell: Cell) -> None:
    """The program speaks in the base frame: nothing of the run tells where in the world the base stands."""
    moved = Pose(np.array([1.5, -0.7, 0.4]), np.array([0.8, 0.0, 0.0, 0.6]))
    (box,) = cell.parts
    here = replace(cell, frames={"k": Frame(Pose(np.array([0.45, 0.0, 0.3])))})
    there = replace(
        with_station(here, X_WB=moved),
        parts=(replace(box, X_WO=moved @ box.X_WO),),
        frames={name: Frame(moved @ one.X_PK) for name, one in here.frames.items()},
    )
    lines = ("mov (450, -150, 100)", "close", "mov (0, 0, 20) in k", "open", "mov home")
    one, other = ran(here, *lines), ran(there, *lines)
    assert codes(one) == codes(other) == []
    for name in ("q", "attained_position", "payload", "gripper"):
        np.testing.assert_allclose(one.channels[name].values, other.channels[name].values, atol=NEAR)
