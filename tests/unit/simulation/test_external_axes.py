"""External axes in a run: joint moves take them along, poses leave them where they are."""

from functools import cache

import numpy as np
import pytest

from ropsim import language
from ropsim.cellfile import read_cell
from ropsim.core import SourceText
from ropsim.flow import Recording
from ropsim.kinematics import forward
from ropsim.model import Cell
from ropsim.program import Constant, Move
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.workbench import environment_of

CELL = (
    '[robot]\nmodel = "puma560"\ntrack = { length = 3000 }\n'
    "positioner = { radius = 400, height = 600, base = { position = [0, 2000, 0] } }\n"
    "[locations.far]\nposition = [1500, 300, 1000]\n"
    "[locations.stock]\nposition = [-100, 300, 1000]\nexternal = [-800, -45]\n"
)
PROGRAM = """program main
units mm, deg, s
mov joints(0, 75, -180, 0, -75, 0, 800, 90)
wait 0.1
mov far
lin far offset (0, 100, 0)
wait 0.1
mov home
"""
SHORT = 1e-9  # [rad | m], rounding of coordinates in a plan


@cache
def cell() -> Cell:
    found, findings = read_cell(SourceText("cell.toml", CELL), "track")
    assert findings == ()
    assert found is not None
    return found


def compiled(text: str) -> language.Compiled:
    return language.compile(text, environment_of(cell()), name="main.task")


@cache
def recording() -> Recording:
    code = compiled(PROGRAM)
    assert code.diagnostics == ()
    assert code.icr is not None
    return run(cell(), {"robot": code.icr}, RunOptions(fidelity=Fidelity.KINEMATIC))


def test_a_joint_move_takes_the_external_axes_along_and_all_axes_arrive_together() -> None:
    q = recording().channels["q"].values
    assert recording().ok
    arrived = np.flatnonzero(np.abs(q[:, 6] - 0.8) < SHORT)[0]
    turned = np.flatnonzero(np.abs(q[:, 7] - np.pi / 2.0) < SHORT)[0]
    assert arrived == turned
    moving = slice(1, arrived - 1)
    assert (np.diff(q[moving, 6]) > 0.0).all()
    assert q[moving, 7] / q[moving, 6] == pytest.approx(np.pi / 2.0 / 0.8)  # synchronous: in proportion


def test_poses_are_reached_by_the_arm_while_the_external_axes_stand() -> None:
    q = recording().channels["q"].values
    there = np.flatnonzero(np.abs(q[:, 6] - 0.8) < SHORT)
    assert q[there, 6:] == pytest.approx(np.broadcast_to([0.8, np.pi / 2.0], (len(there), 2)), abs=SHORT)
    robot = cell().first.robot
    goal = cell().locations["far"].position
    gaps = [float(np.linalg.norm(forward(robot, row).position - goal)) for row in q[there[::5]]]
    assert min(gaps) < 1e-6  # [m], the polish of inverse kinematics


def test_home_is_home_of_all_axes() -> None:
    assert recording().channels["q"].values[-1] == pytest.approx(cell().first.robot.home, abs=SHORT)


@pytest.mark.parametrize("value", ["800", "800 mm", "80 cm"])
def test_a_coordinate_of_a_track_is_a_length(value: str) -> None:
    code = compiled(f"program main\nunits mm, deg, s\nmov joints(0, 75, -180, 0, -75, 0, {value}, 90 deg)\n")
    assert code.diagnostics == ()
    assert code.program is not None
    (move,) = code.program.main
    assert isinstance(move, Move)
    assert isinstance(move.target, Constant)
    assert isinstance(move.target.value, tuple)
    assert move.target.value[6:] == pytest.approx((0.8, np.pi / 2.0))


def test_a_coordinate_of_the_wrong_sort_is_a_mistake_of_the_program() -> None:
    code = compiled("program main\nunits mm, deg, s\nmov joints(0, 75, -180, 0, -75, 0, 80 deg, 90)\n")
    (found,) = [one for one in code.diagnostics if one.is_error]
    assert found.message == "joint 7 must be a length, found an angle"
    code = compiled("program main\nunits mm, deg, s\nmov joints(0, 75 mm, -180, 0, -75, 0, 800, 90)\n")
    (found,) = [one for one in code.diagnostics if one.is_error]
    assert found.message == "joint 2 must be an angle, found a length"


def test_coordinates_that_lack_the_external_axes_are_told() -> None:
    code = compiled("program main\nunits mm, deg, s\nmov joints(0, 75, -180, 0, -75, 0)\n")
    (found,) = code.diagnostics
    assert (found.code, found.message) == ("T335", "`joints(…)` has 6 coordinates, 8 are needed")


def ran(*lines: str) -> Recording:
    code = compiled("program main\nunits mm, deg, s\n" + "\n".join(lines) + "\n")
    assert code.icr is not None, [str(one) for one in code.diagnostics]
    return run(cell(), {"robot": code.icr}, RunOptions(fidelity=Fidelity.KINEMATIC))


def test_a_location_takes_the_external_axes_along_and_a_line_leaves_them_there() -> None:
    recording = ran(
        "mov stock above 50", "lin stock", "wait 0.1", "mov far external (800, 90)", "lin here rel (0, 0, 20)"
    )
    assert (recording.ok, [str(one) for one in recording.findings]) == (True, [])
    q, robot = recording.channels["q"].values, cell().first.robot
    at_stock = np.array([-0.8, -np.pi / 4.0])
    there = np.flatnonzero((np.abs(q[:, 6:] - at_stock) < SHORT).all(axis=1))
    goal = cell().locations["stock"].position
    assert min(float(np.linalg.norm(forward(robot, row).position - goal)) for row in q[there]) < 1e-6
    assert q[-1, 6:] == pytest.approx([0.8, np.pi / 2.0], abs=SHORT)


def test_a_line_to_a_location_takes_the_external_axes_there() -> None:
    recording = ran(
        "mov stock above 50 external (-750, 0)",
        "lin stock",
        "wait 0.1",
        "lin here above 50 external (-700, 20)",
    )
    assert recording.ok
    assert {one.code for one in recording.findings} == {"S727"}  # they move further than the tool
    q, robot = recording.channels["q"].values, cell().first.robot
    assert q[-1, 6:] == pytest.approx([-0.7, np.radians(20.0)], abs=SHORT)
    there = np.flatnonzero((np.abs(q[:, 6:] - [-0.8, -np.pi / 4.0]) < SHORT).all(axis=1))
    goal = cell().locations["stock"].position
    assert min(float(np.linalg.norm(forward(robot, row).position - goal)) for row in q[there]) < 1e-6


@pytest.mark.parametrize("values", ["(800)", "(800, 90, 0)"])
def test_another_number_of_values_is_told_on_its_line(values: str) -> None:
    (found,) = ran("wait 0.1", f"mov far external {values}").findings
    assert found.code == "M520"
    assert found.span is not None
    assert found.span.line == 4
    assert "has 2 (E1, E2)" in found.message
