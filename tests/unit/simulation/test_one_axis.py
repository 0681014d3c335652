"""Stations of one axis: a slide and a turntable with drives, moved by their own programs."""

from functools import cache

import numpy as np
import pytest

from ropsim import language
from ropsim.cellfile import read_cell
from ropsim.core import SourceText
from ropsim.flow import Recording
from ropsim.kinematics import body_poses
from ropsim.model import Cell, JointType, audit, body_tree
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.workbench import environment_of

SLIDE = """
[stations.shuttle]
base = { position = [0, 300, 500], rpy = [0, 0, 90] }
[stations.shuttle.mechanism]
kind = "slide"
low = -100
high = 900
size = [300, 200, 20]
mass = 15
speed = 800
acceleration = 2000
"""
TABLE = """
[stations.table]
base = { position = [1000, 0, 400] }
[stations.table.mechanism]
kind = "turntable"
low = -360
high = 360
diameter = 400
inertia = 2
speed = 180
acceleration = 400
"""
REST = """
[[parts]]
name = "box"
size = [60, 60, 40]
mass = 0.5
position = [50, 350, 540]
[[parts]]
name = "disc"
size = [60, 60, 40]
mass = 0.5
position = [1100, 0, 440]
[[objects]]
name = "post"
parent = "table"
position = [-100, 0, 100]
size = [40, 40, 100]
[signals.there]
output = 1
"""
HEAD = "program main\nunits mm, deg, s\n"
GO = "mov joints(500)\nset there on\n"
TURN = "wait until there\nmov joints(90)\n"
EXACT = 1e-9  # [m]


@cache
def cell_of(text: str = SLIDE + TABLE + REST) -> Cell:
    cell, findings = read_cell(SourceText("cell.toml", text), "axes")
    assert [str(one) for one in findings] == []
    assert cell is not None
    return cell


def ran(fidelity: Fidelity, **programs: str) -> Recording:
    cell, codes = cell_of(), {}
    for name, lines in programs.items():
        code = language.compile(HEAD + lines, environment_of(cell, cell.stations[name]), name=f"{name}.task")
        assert [str(one) for one in code.diagnostics] == []
        assert code.icr is not None
        codes[name] = code.icr
    return run(cell, codes, RunOptions(fidelity=fidelity))


@pytest.mark.parametrize("name", ["shuttle", "table"])
def test_its_mechanism_is_sound_and_its_one_axis_external(name: str) -> None:
    robot = cell_of().stations[name].robot
    assert [str(one) for one in audit(robot) if one.is_error] == []
    assert (robot.n, robot.external, robot.has_arm) == (1, (0,), False)
    assert robot.axis_joints[0].name == "E1"
    assert {origin.kind for origin in robot.origins} == {"estimated"}


def test_it_has_the_limits_of_the_file() -> None:
    slide, table = (cell_of().stations[name].robot.axis_joints[0] for name in ("shuttle", "table"))
    assert (slide.measure, slide.lower, slide.upper) == (JointType.PRISMATIC, -0.1, 0.9)
    assert (slide.max_speed, slide.max_acceleration) == (0.8, 2.0)
    assert table.measure is JointType.REVOLUTE
    assert table.upper == pytest.approx(2.0 * np.pi)


@pytest.mark.parametrize("fidelity", list(Fidelity))
def test_programs_move_it_and_parts_and_objects_come_along(fidelity: Fidelity) -> None:
    recording = ran(fidelity, shuttle=GO, table=TURN)
    assert [str(one) for one in recording.findings] == []
    q = {name: recording.channels[f"{name}/q"].values[-1:] for name in ("shuttle", "table")}
    within = {name: one.controller.in_position[0] for name, one in cell_of().stations.items()}
    assert q["shuttle"][0, 0] == pytest.approx(0.5, abs=within["shuttle"])
    assert q["table"][0, 0] == pytest.approx(np.pi / 2.0, abs=within["table"])
    elsewhere = {
        one.body: (one.parent, one.X_PB) for one in recording.placements if one.body in {"box", "disc"}
    }
    found = body_poses(body_tree(cell_of()), q, ["box", "disc", "post"], elsewhere)
    s, a = q["shuttle"][0, 0], q["table"][0, 0]
    expected = {
        "box": [0.05, 0.35 + s, 0.54],  # x of the base of the shuttle points along y of the world
        "disc": [1.0 + 0.1 * np.cos(a), 0.1 * np.sin(a), 0.44],
        "post": [1.0 - 0.1 * np.cos(a), -0.1 * np.sin(a), 0.5],
    }
    for name, place in expected.items():
        np.testing.assert_allclose(found[name][0, :3, 3], place, rtol=0.0, atol=EXACT)


def test_the_table_waits_for_the_signal_of_the_shuttle() -> None:
    recording = ran(Fidelity.KINEMATIC, shuttle=GO, table=TURN)
    arrived = recording.time[np.flatnonzero(recording.channels["shuttle/q"].values[:, 0] > 0.5 - EXACT)[0]]
    began = recording.time[np.flatnonzero(recording.channels["table/q"].values[:, 0] > EXACT)[0]]
    assert began >= arrived


@pytest.mark.parametrize(
    ("line", "code", "words"),
    [
        ("mov (100, 0, 0)", "M518", "a pose needs an arm, this station has the axis `E1` only"),
        ("lin (100, 0, 0)", "M518", "a straight line needs an arm"),
        ("mov joints(1000)", "M502", "`E1`"),
    ],
)
def test_what_it_cannot_do_is_told_on_its_line(line: str, code: str, words: str) -> None:
    recording = ran(Fidelity.KINEMATIC, shuttle=f"mov joints(100)\n{line}\n")
    (found,) = recording.findings
    assert (found.code, found.span and found.span.line) == (code, 4)
    assert words in found.message


def test_home_is_its_coordinate_0() -> None:
    recording = ran(Fidelity.KINEMATIC, shuttle="mov joints(100)\nmov home\n")
    assert recording.channels["shuttle/q"].values[-1, 0] == pytest.approx(0.0, abs=EXACT)


def test_an_upright_slide_holds_its_load() -> None:
    """The drive has what it takes against gravity: x of the base points up."""
    text = SLIDE.replace("rpy = [0, 0, 90]", "rpy = [0, -90, 0]")
    cell = cell_of(text)
    code = language.compile(HEAD + "mov joints(600)\nwait 0.2\n", environment_of(cell), name="main.task")
    assert code.icr is not None
    recording = run(cell, {"shuttle": code.icr}, RunOptions(fidelity=Fidelity.DYNAMIC))
    assert [str(one) for one in recording.findings] == []
    effort = recording.channels["shuttle/tau"].values[-1, 0]
    assert abs(effort) == pytest.approx(15.0 * 9.81, rel=0.1)  # up to the dry friction
