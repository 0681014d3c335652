"""`here` in runs: wherever the arm came from, it is where the arm is commanded to stand."""

import re
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from ropsim import icr, robots
from ropsim.cellfile import read_cell
from ropsim.core import SourceText
from ropsim.flow import MessageEvent, MoveEvent, Recording
from ropsim.kinematics import forward
from ropsim.model import Cell, Signal, Tool
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.spatial import Array, Pose
from ropsim.workbench.testing import dry_arm
from support.cells import one_station
from support.compiled import code_of
from support.printed import si_numbers

ROBOT = robots.load("puma560")
START = np.radians([20.0, 30.0, -130.0, 10.0, -60.0, 15.0])
LONG = Pose(np.array([0.0, 0.0, 0.2]))
SIGNALS = {
    "touch": Signal("touch", is_input=True, changes=((1.5, 1.0),)),
    "part": Signal("part", is_input=True),
    "height": Signal("height", is_input=True, analog=True, changes=((0.0, 0.02),)),
}
CELL: Cell = one_station(
    "c",
    ROBOT,
    robots.default_controller("puma560"),
    tools={"": Tool(""), "long": Tool("long", LONG)},
    start=START,
    signals=SIGNALS,
)
EXACT = 1e-6
"""What the polish of inverse kinematics leaves [m | -]."""
SHOWN = 1e-6
"""Six digits of a length below a metre [m]."""
NUMBER = re.compile(r"-?\d[\d.]*(?:e[+-]\d+)?")
JOINTS = "joints(20, 30, -140, 10, -50, 15)"

BEFORE = {
    "the start": (),
    "home": ("mov home",),
    "joint coordinates": (f"mov {JOINTS}",),
    "a line": ("lin (500, 100, 300)",),
    "a condition": ("mov (500, 0, 300)", "lin (500, 0, 100) speed 20 mm/s until touch"),
    "a condition that never comes": ("lin (500, 100, 300) until part timeout 1 s",),
    "a sensor": ("mov (500, 0, 300)", "lin (500, 80, 300) speed 50 mm/s track height = 15 mm"),
    "a part of an arc": ("mov (500, 0, 300)", "circ via (530, 30, 300) to (560, 0, 300) angle 50 deg"),
    "a curve": ("mov (500, 0, 300)", "spline via (530, 30, 300) to (560, 0, 300)"),
    "another tool": ("mov (400, 0, 300)", "set tool long"),
    "another tool after joint coordinates": (f"mov {JOINTS}", "set tool long"),
    "a branch": ("if part", "mov (500, 0, 300)", "else", f"mov {JOINTS}", "endif"),
    "a loop": ("for k = 1 to 3", "lin here offset (0, 10, 0)", "endf"),
    "no motion of a loop": ("while part", "mov (500, 0, 300)", "endw"),
}
CUT = ("a condition", "a condition that never comes", "a sensor")
"""Motions that end elsewhere than at their targets."""


def ran(cell: Cell, *lines: str) -> Recording:
    return run(cell, {"robot": code_of(cell, *lines)}, RunOptions(Fidelity.KINEMATIC))


def end(recording: Recording) -> Array:
    return np.asarray(recording.rows("q_ref" if "q_ref" in recording.channels else "q")[-1])


def begun(recording: Recording, number: int) -> Array:
    """Return the coordinates at which a move, counted from the last one, begins [rad], shape (n,)."""
    move = recording.events_of(MoveEvent)[number]
    return np.asarray(recording.rows("q")[np.searchsorted(recording.time, move.time - 1e-9)])


@pytest.mark.parametrize("lines", BEFORE.values(), ids=BEFORE)
def test_the_arm_goes_up_from_where_it_is(lines: tuple[str, ...]) -> None:
    found = ran(CELL, *lines, "lin here", "wait 0.01 s", "lin here offset (0, 0, 20)")
    assert not [one for one in found.findings if one.is_error]
    np.testing.assert_allclose(begun(found, -1), begun(found, -2), atol=EXACT)
    before, after = forward(ROBOT, begun(found, -1)), forward(ROBOT, end(found))
    np.testing.assert_allclose(after.position - before.position, [0.0, 0.0, 0.02], atol=EXACT)
    np.testing.assert_allclose(after.matrix()[:3, :3], before.matrix()[:3, :3], atol=EXACT)


def test_the_pose_is_that_of_the_tool_and_frame_in_force() -> None:
    lines = ("frame desk = (100, 50, 20; rz 40)", f"mov {JOINTS}", "set tool long")
    found = ran(CELL, *lines, "with frame desk", "print here.x, here.y, here.z", "endwith")
    q = np.radians([20.0, 30.0, -140.0, 10.0, -50.0, 15.0])
    half = np.radians(20.0)
    X_BK = Pose(np.array([0.1, 0.05, 0.02]), np.array([np.cos(half), 0.0, 0.0, np.sin(half)]))
    seen = X_BK.inverse() @ forward(ROBOT, q) @ LONG
    (said,) = found.events_of(MessageEvent)
    assert si_numbers(said.text) == pytest.approx(seen.position.tolist(), abs=SHOWN)


def test_a_pose_is_printed_without_noise() -> None:
    desk = (
        "frame desk = (100, 50, 20; rz 40)",
        "mov (500, 100, 300)",
        "with frame desk",
        "lin (300, 0, 200)",
    )
    found = ran(CELL, *desk, "print here", "endwith", "mov home", "print here")
    numbers = [one for said in found.events_of(MessageEvent) for one in NUMBER.findall(said.text)]
    assert len(numbers) == 12
    assert [one for one in numbers if one == "-0" or 0.0 < abs(float(one)) < 1e-6] == []


def test_the_pose_of_a_tool_is_that_of_the_cell_whatever_the_program_says_of_it() -> None:
    """The code gives `long` another length; that of the cell counts, also where the tool changes."""
    code = code_of(CELL, "mov (400, 0, 300)", "set tool long", "lin here")
    wrong = replace(code, tools=tuple(replace(one, pose=Pose().as_tuple()) for one in code.tools))
    found = run(CELL, {"robot": wrong}, RunOptions(Fidelity.KINEMATIC))
    np.testing.assert_allclose(end(found), begun(found, -1), atol=EXACT)


@pytest.mark.parametrize("target", ["home", JOINTS, "(500, 0, 300)"])
def test_where_the_target_tells_the_pose_the_arm_need_not_stop_for_it(target: str) -> None:
    recording = ran(CELL, f"mov {target} blend 20", "lin here offset (0, 0, -80)")
    moves = recording.events_of(MoveEvent)
    assert moves[0].flown > 0.0
    assert [one.code for one in recording.findings if "pose of the arm" in one.message] == []


def test_only_where_it_does_not_tell_it_the_arm_stops() -> None:
    arc = "circ via (530, 30, 300) to (560, 0, 300) angle 50 deg blend 20"
    recording = ran(CELL, "mov (500, 0, 300)", arc, "lin here offset (0, 0, -80)")
    assert recording.events_of(MoveEvent)[1].flown == 0.0
    assert any("asks for the pose of the arm next" in one.message for one in recording.findings)


def test_runs_with_it_are_the_same_to_the_bit() -> None:
    lines = (*BEFORE["a condition"], "lin here offset (0, 0, 20)", "p = here", "mov home", "lin p")
    one, other = ran(CELL, *lines), ran(CELL, *lines)
    assert one.rows("q").tobytes() == other.rows("q").tobytes()


def test_a_task_sees_where_its_callers_have_come() -> None:
    lines = (
        "task Up(rise: length)",
        "lin here offset (0, 0, rise)",
        "endp",
        "Up 20 mm",
        "mov home",
        "Up -30 mm",
        f"mov {JOINTS}",
        "Up 10 mm",
    )
    moves = ran(CELL, *lines).events_of(MoveEvent)
    heights = [one.target[2] for one in moves if one.motion == "LIN"]
    poses = [
        forward(ROBOT, q).position[2] for q in (START, ROBOT.home, np.radians([20, 30, -140, 10, -50, 15]))
    ]
    assert heights == pytest.approx(
        [a + b for a, b in zip(poses, (0.02, -0.03, 0.01), strict=True)], abs=EXACT
    )


def test_it_can_be_given_to_a_task() -> None:
    lines = ("task Over(p: loc)", "lin p offset (0, 0, 20)", "endp", "mov home", "Over here")
    after = forward(ROBOT, end(ran(CELL, *lines)))
    np.testing.assert_allclose(
        after.position - forward(ROBOT, ROBOT.home).position, [0.0, 0.0, 0.02], atol=EXACT
    )


MOVING = """
[robot]
model = "puma560"
positioner = { radius = 250, height = 500, base = { position = [600, 150, 0] } }
[frames.fixture]
parent = "positioner"
position = [0, 100, 20]
[locations.corner]
frame = "fixture"
position = [30, 0, 40]
"""


@cache
def moving_cell() -> Cell:
    cell, findings = read_cell(SourceText("cell.toml", MOVING), "moving")
    assert cell is not None, findings
    return cell


@pytest.mark.parametrize(
    "lines",
    [
        (),
        ("mov joints(0, 75, -180, 0, -75, 0, 90)",),
        ("mov home",),
        ("mov joints(0, 75, -180, 0, -75, 0, 40)", "mov corner above 80"),
        ("mov corner above 80 external (30)",),
    ],
)
def test_external_axes_stay_where_they_are(lines: tuple[str, ...]) -> None:
    found = ran(moving_cell(), *lines, "lin here", "wait 0.1 s")
    assert not [str(one) for one in found.findings if one.is_error]
    np.testing.assert_allclose(end(found), begun(found, -1), atol=EXACT)


@pytest.mark.parametrize("name", [one for one in BEFORE if one not in CUT])
def test_a_dry_run_in_the_cell_goes_where_the_run_goes(name: str) -> None:
    lines = (*BEFORE[name], "lin here offset (0, 0, 20)")
    code, found = code_of(CELL, *lines), ran(CELL, *lines)
    last = icr.run(code, icr.StillWorld(arm=dry_arm(CELL, CELL.first))).moves[-1]
    assert isinstance(last.target, Pose)
    wanted = found.events_of(MoveEvent)[-1].target
    assert (last.modal.X_BK @ last.target).position.tolist() == pytest.approx(list(wanted), abs=EXACT)


@pytest.mark.parametrize("axis", [0.0, 40.0])
def test_a_dry_run_knows_where_the_axes_have_brought_a_frame(axis: float) -> None:
    cell = moving_cell()
    lines = (
        f"mov corner above 80 external ({axis})",
        "with frame fixture",
        "mov here",
        "endwith",
        "mov home",
    )
    code = code_of(cell, *lines)
    _, there, _ = icr.run(code, icr.StillWorld(arm=dry_arm(cell, cell.first))).moves
    assert there.target == icr.run(code, icr.StillWorld()).moves[0].target
