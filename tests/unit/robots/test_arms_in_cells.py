"""Arms of the library in cells: a cell file of two lines opens, simulates, is jogged and drawn."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ropsim
from ropsim import robots
from ropsim.flow import MoveEvent, Recording
from ropsim.kinematics import forward, frames_batch
from ropsim.model import Cell, RobotModel, beside, body_tree, on_track
from ropsim.simulation import RunOptions, run
from ropsim.spatial import Pose
from ropsim.studio.testing import JoggedArm, JogJoints, JogReply, JogTcp
from ropsim.views import scene
from ropsim.workbench import environment_of
from support.cells import one_station

PROGRAMS = {
    "scara": """\
program main
units mm, deg, s
mov (450, 100, 250)
lin (450, -100, 250) speed 200 mm/s
lin (450, -100, 200; down, rz 30) speed 100 mm/s
mov home
""",
    "palletizer": """\
program main
units mm, deg, s
mov (1800, 600, 700)
lin (1800, -600, 700) speed 500 mm/s
lin (1800, -600, 400; down, rz 30) speed 300 mm/s
mov home
""",
    "two_link": """\
program main
units mm, deg, s
mov joints(90, -60)
mov joints(0, 30)
mov home
""",
}
LONGEST_SETTLING = 0.05  # [s]
DEVIATION = 1e-4  # [m] of a line


def opened(name: str, folder: Path) -> "ropsim.workbench.Project":
    folder.joinpath("programs").mkdir()
    folder.joinpath("cell.toml").write_text(
        f'[cell]\nname = "{name}"\n\n[robot]\nmodel = "{name}"\n', "utf-8"
    )
    folder.joinpath("programs", "main.task").write_text(PROGRAMS[name], "utf-8")
    return ropsim.open(folder)


@pytest.mark.parametrize("name", PROGRAMS)
def test_a_program_runs_to_its_end_and_the_arm_follows(name: str, tmp_path: Path) -> None:
    recording = opened(name, tmp_path).simulate()
    assert [str(finding) for finding in recording.findings if finding.is_error] == []
    moves = recording.events_of(MoveEvent)
    assert len(moves) == PROGRAMS[name].count("mov ") + PROGRAMS[name].count("lin ")
    assert max(move.settle for move in moves) < LONGEST_SETTLING
    robot = robots.load(name)
    channels = recording.channels
    np.testing.assert_allclose(channels["q"].values[-1], robot.home, rtol=0, atol=0.2e-3)
    share = np.abs(channels["tau"].values) / robot.max_efforts
    assert 0.0 < share.max() < 1.0


def jogged(cell: Cell) -> JoggedArm:
    return JoggedArm(cell.first, body_tree(cell))


@pytest.mark.parametrize("name", PROGRAMS)
def test_it_is_jogged_by_axes_and_by_its_tool(name: str) -> None:
    robot = robots.load(name)
    arm = jogged(one_station("c", robot, robots.default_controller(robot)))
    here = tuple((robot.home + 0.02).tolist())
    by_axes = arm.to_joints(JogJoints("robot", here, ""))
    assert isinstance(by_axes, JogReply)
    assert by_axes.tcp == pytest.approx(forward(robot, here).as_tuple(), abs=1e-12)
    assert len(by_axes.bodies) == len(robot.joints) + 1
    back = arm.to_pose(JogTcp("robot", tuple(robot.home.tolist()), "", by_axes.tcp))
    assert isinstance(back, JogReply)
    assert back.reached
    assert back.q == pytest.approx(here, abs=1e-7)


@pytest.mark.parametrize("name", PROGRAMS)
def test_every_link_is_drawn_where_it_is(name: str) -> None:
    robot = robots.load(name)
    found: Any = scene(one_station("c", robot, robots.default_controller(robot)), {})
    bodies = {str(body["name"]): body for body in found["bodies"]}
    frames = frames_batch(robot, robot.home[np.newaxis])[0]
    for number in range(1, len(robot.joints) + 1):
        body = bodies[f"link{number}"]
        x, y, z, *_ = body["pose"]
        np.testing.assert_allclose([x, y, z], frames[number - 1, :3, 3], rtol=0, atol=1e-12)
        assert body["shapes"]
    assert [joint["name"] for joint in found["stations"][0]["joints"]] == [
        joint.name for joint in robot.axis_joints
    ]


def station() -> RobotModel:
    arm = on_track(robots.load("puma560"), robots.linear_track(3.0))
    return beside(arm, robots.turntable(0.5), Pose(np.array([0.0, 1.2, 0.0])))


def simulated(robot: RobotModel, text: str) -> Recording:
    cell = one_station("station", robot, robots.default_controller(robot))
    compiled = ropsim.language.compile(text, environment_of(cell))
    assert compiled.icr is not None, [str(one) for one in compiled.diagnostics]
    return run(cell, {"robot": compiled.icr}, RunOptions())


def test_a_station_drives_its_arm_and_its_external_axes_together() -> None:
    """The first move takes track and table along; the line is drawn from there, and both stand still."""
    robot = station()
    text = """\
program main
units mm, deg, s
mov joints(10, 75, -180, 0, -75, 0, 400 mm, 90)
lin (900, -100, 900) speed 200 mm/s
"""
    recording = simulated(robot, text)
    assert [str(finding) for finding in recording.findings if finding.is_error] == []
    q = recording.channels["q"].values
    assert q.shape[1] == 8
    moves = recording.events_of(MoveEvent)
    along = recording.time >= moves[1].time
    assert np.abs(q[along, 6] - 0.4).max() < 0.3e-3
    assert np.abs(q[along, 7] - np.pi / 2.0).max() < 0.3e-3
    np.testing.assert_allclose(forward(robot, q[-1]).position, [0.9, -0.1, 0.9], rtol=0, atol=1e-3)


def test_a_station_is_drawn_and_jogged_with_its_track() -> None:
    robot = station()
    cell = one_station("station", robot, robots.default_controller(robot))
    assert scene(cell, {})["stations"]
    here = (*robot.home.tolist()[:6], 0.5, 0.3)
    arm = jogged(cell)
    by_axes = arm.to_joints(JogJoints("robot", here, ""))
    assert isinstance(by_axes, JogReply)
    x, y, z, qw, qx, qy, qz = by_axes.tcp
    back = arm.to_pose(JogTcp("robot", here, "", (x + 0.01, y, z, qw, qx, qy, qz)))
    assert isinstance(back, JogReply)
    assert (back.reached, back.q[6:]) == (True, (0.5, 0.3))
