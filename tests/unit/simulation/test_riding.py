"""What lies on a device comes along: parts on a turntable, on a fixture that hangs on one, on a slide."""

import numpy as np
import pytest

from ropsim import language
from ropsim.cellfile import read_cell
from ropsim.core import SourceText
from ropsim.flow import Placement, Recording
from ropsim.kinematics import body_poses
from ropsim.model import Cell, body_tree, start_of
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.workbench import environment_of

CELL = """
[robot]
model = "puma560"
tool = "jaws"
[tools.jaws]
position = [0, 0, 150]
gripper = {}
[devices.table]
kind = "turntable"
base = { position = [500, 0, 500] }
diameter = 400
signal = "next"
step = 90
speed = 180
acceleration = 720
in_place = "stands"
[devices.shuttle]
kind = "slide"
base = { position = [400, -400, 500], rpy = [0, 0, -90] }
size = [200, 200, 20]
signal = "push"
on = 300
speed = 500
acceleration = 2000
is_on = "pushed"
[[objects]]
name = "fixture"
parent = "table"
position = [120, 0, 20]
size = [80, 80, 20]
[[objects]]
name = "tray"
parent = "shuttle"
position = [0, 50, 10]
size = [100, 60, 10]
[[parts]]
name = "carried"
size = [40, 40, 40]
mass = 0.2
position = [450, -400, 550]
[[parts]]
name = "set_down"
size = [40, 40, 40]
mass = 0.2
position = [300, 300, 540]
[[objects]]
name = "stand"
position = [300, 300, 500]
size = [80, 80, 500]
[signals.next]
output = 1
[signals.push]
output = 2
[signals.stands]
input = 1
[signals.pushed]
input = 2
"""
PROGRAM = """program main
units mm, deg, s
set push on
mov (300, 300, 540) above 50
lin (300, 300, 540) speed 100
close
lin (300, 300, 540) above 100
mov (620, 0, 560) above 50
lin (620, 0, 560) speed 100
open
lin (620, 0, 560) above 100
wait until pushed
wait until stands
set next on
wait 0.1
wait until stands
"""
ROUNDING = 1e-9  # [m]


@pytest.fixture(scope="module")
def ridden() -> tuple[Cell, Recording]:
    cell, findings = read_cell(SourceText("cell.toml", CELL), "riding")
    assert findings == ()
    assert cell is not None
    code = language.compile(PROGRAM, environment_of(cell), name="main.task")
    assert code.icr is not None
    recording = run(cell, {"robot": code.icr}, RunOptions(fidelity=Fidelity.KINEMATIC))
    assert [str(found) for found in recording.findings] == []
    return cell, recording


def at_the_end(cell: Cell, recording: Recording, name: str) -> np.ndarray:
    """Return where a part is when the run ends, by the channels and placements of the recording."""
    last: dict[str, Placement] = {one.body: one for one in recording.placements}
    elsewhere = {one.body: (one.parent, one.X_PB) for one in last.values() if one.body == name}
    Q = {
        "robot": recording.channels["q"].values[-1:],
        "table": recording.channels["table/q"].values[-1:],
        "shuttle": recording.channels["shuttle/q"].values[-1:],
    }
    return np.asarray(body_poses(body_tree(cell), Q, [name], elsewhere)[name][0])


def test_a_part_that_is_set_down_on_a_fixture_of_a_turning_table_comes_along(
    ridden: tuple[Cell, Recording],
) -> None:
    pose = at_the_end(*ridden, "set_down")
    assert pose[:3, 3] == pytest.approx([0.5, 0.12, 0.56], abs=1e-5)  # a quarter turn further
    assert pose[:3, 0] == pytest.approx([0.0, 1.0, 0.0], abs=1e-5)
    _, recording = ridden
    assert [one.parent for one in recording.placements if one.body == "set_down"][-1] == "fixture"


def test_objects_are_given_in_the_base_frame_of_a_slide_at_its_coordinate_0(
    ridden: tuple[Cell, Recording],
) -> None:
    cell, _ = ridden
    rest = {name: q[None] for name, q in start_of(cell).items()}
    tray = body_poses(body_tree(cell), rest)["tray"][0]
    assert tray[:3, 3] == pytest.approx([0.45, -0.4, 0.51], abs=ROUNDING)
    assert tray[:3, 2] == pytest.approx([0.0, 0.0, 1.0], abs=ROUNDING)


def test_a_part_on_a_tray_of_a_slide_comes_along(ridden: tuple[Cell, Recording]) -> None:
    assert at_the_end(*ridden, "carried")[:3, 3] == pytest.approx([0.45, -0.7, 0.55], abs=ROUNDING)
