"""Programs on arms with closed chains: points and lines, and what is said where a chain locks."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import ropsim
from ropsim.exchange import write_nirox
from ropsim.flow import Fidelity, Recording
from ropsim.kinematics import forward, forward_batch
from ropsim.model import RobotModel
from ropsim.robotfile import write_robot_file
from ropsim.simulation import RunOptions
from ropsim.spatial import Pose
from ropsim.workbench import new_robot_project
from support.closed_arms import (
    delta,
    five_bar,
    palletizer,
    six_axis_with_cylinders,
    two_link_with_cylinders,
)

POINTER = Pose(np.array([0.0, 0.0, 0.1]))


def project_of(robot: RobotModel, folder: Path) -> Path:
    file = folder / "arm.stp"
    file.write_text(write_nirox(replace(robot, drives=())).text, encoding="utf-8")
    return new_robot_project(folder / "cell", str(file))


def run(folder: Path) -> Recording:
    return ropsim.open(folder).simulate(options=RunOptions(Fidelity.KINEMATIC))


def codes(recording: Recording) -> set[str]:
    return {one.code for one in recording.findings}


@pytest.mark.parametrize(
    "make", [palletizer, six_axis_with_cylinders, pytest.param(delta, marks=pytest.mark.slow)]
)
def test_the_first_program_leads_the_tool_along_lines(make: Callable[[], RobotModel], tmp_path: Path) -> None:
    robot = make()
    recording = run(project_of(robot, tmp_path))
    assert recording.ok
    assert sum(getattr(event, "motion", None) == "LIN" for event in recording.events) >= 4
    joints = recording.rows("q")
    places = forward_batch(robot, joints[::50]) @ POINTER.matrix()
    np.testing.assert_allclose(places[:, :3, 3], recording.rows("attained_position")[::50], atol=1e-9)


@pytest.mark.parametrize("make", [five_bar, two_link_with_cylinders])
def test_the_first_program_of_a_planar_arm_goes_where_its_chains_follow(
    make: Callable[[], RobotModel], tmp_path: Path
) -> None:
    recording = run(project_of(make(), tmp_path))
    assert recording.ok
    assert codes(recording) <= {"S750", "X972"}


def test_task_text_runs_on_a_robot_file_with_loops(tmp_path: Path) -> None:
    """The corners of a line of the tool, by the robot file of an arm with two cylinders."""
    robot = replace(six_axis_with_cylinders(), drives=())
    bare = replace(
        robot, links=tuple(replace(one, mass=0.0, inertia=0.0 * one.inertia) for one in robot.links)
    )
    file = tmp_path / "arm.toml"
    file.write_text(write_robot_file(bare).text, encoding="utf-8")
    folder = new_robot_project(tmp_path / "cell", str(file))
    recording = program(
        folder, "mov home", "lin here offset (0, 120, 0)", "lin here offset (0, -120, 60)", "mov home"
    )
    assert recording.ok, recording.findings
    path = recording.rows("attained_position")
    assert np.ptp(path[:, 1]) == pytest.approx(0.12, abs=1e-3)


def program(folder: Path, *lines: str) -> Recording:
    text = "\n".join(("program main", "units mm, deg, s", "", *lines, ""))
    (folder / "programs" / "main.task").write_text(text, encoding="utf-8")
    return run(folder)


def test_a_target_at_which_a_chain_is_open_is_refused_with_its_gap(tmp_path: Path) -> None:
    recording = program(project_of(two_link_with_cylinders(), tmp_path), "mov joints(700, 700)")
    assert not recording.ok
    found = next(one for one in recording.findings if "gap of closed chain 1" in one.message)
    assert found.code == "M502"
    assert "the limit is 0.0 mm" in found.message


def test_a_move_whose_chain_locks_on_the_way_is_refused(tmp_path: Path) -> None:
    """Both bars of a five-bar that swing apart straighten the two others between them: a dead centre."""
    recording = program(project_of(five_bar(), tmp_path), "mov joints(170, -10)", "mov home")
    found = [one for one in recording.findings if one.is_error]
    assert found
    assert {one.code for one in found} <= {"M502", "M556"}


def corners(robot: RobotModel) -> list[str]:
    """Return points 40 mm beside the TCP at home in task text, and one far away."""
    x, y, z = (1e3 * (forward(robot, robot.home) @ POINTER).position).tolist()
    up = 20.0 if robot.n == 3 else 0.0
    places = ((40.0, 10.0, up), (-40.0, 10.0, up), (-40.0, -20.0, 0.0), (0.0, 900.0, 0.0), (0.0, 10.0, 15.0))
    return [f"({x + dx:.3f}, {y + dy:.3f}, {z + dz:.3f})" for dx, dy, dz in places]


@pytest.mark.parametrize("make", [five_bar, delta])
def test_points_and_lines_with_free_orientation(make: Callable[[], RobotModel], tmp_path: Path) -> None:
    robot = make()
    first, second, third, _, _ = corners(robot)
    folder = project_of(robot, tmp_path)
    recording = program(
        folder, "mov home", f"mov {first} free", f"lin {second} free", f"lin {third} free", "mov home"
    )
    assert recording.ok, recording.findings
    path = 1e3 * recording.rows("attained_position")
    for place in (first, second, third):
        point = np.array([float(one) for one in place[1:-1].split(",")])
        assert np.linalg.norm(path - point, axis=1).min() < 0.01
    lines = [event for event in recording.events if getattr(event, "motion", None) == "LIN"]
    assert len(lines) == 2
    begin, end = (np.array([float(one) for one in text[1:-1].split(",")]) for text in (first, second))
    near = np.flatnonzero(np.linalg.norm(path - begin, axis=1) < 0.01)[-1]
    last = np.flatnonzero(np.linalg.norm(path - end, axis=1) < 0.01)[0]
    beside = np.cross(path[near:last] - begin, (end - begin) / np.linalg.norm(end - begin))
    assert np.abs(beside).max() < 1e-3


@pytest.mark.parametrize(("make", "away"), [(five_bar, 677.25), (delta, 364.52)])
def test_a_point_out_of_reach_is_refused_with_its_distance(
    make: Callable[[], RobotModel], away: float, tmp_path: Path
) -> None:
    """The nearest place of the delta is that of its spheres and circles, by SLSQP; ours is a bit farther."""
    robot = make()
    far = corners(robot)[3]
    found = [one for one in program(project_of(robot, tmp_path), f"mov {far} free").findings if one.is_error]
    assert [one.code for one in found] == ["M501"]
    assert found[0].data["distance_m"] == pytest.approx(1e-3 * away, abs=0.01)


def test_a_point_beside_the_plane_of_a_five_bar_is_refused(tmp_path: Path) -> None:
    robot = five_bar()
    beside = corners(robot)[4]
    recording = program(project_of(robot, tmp_path), f"lin {beside} free")
    found = [one for one in recording.findings if one.is_error]
    assert [one.code for one in found] == ["M530"]
    assert "15.00 mm beside the plane" in found[0].message
