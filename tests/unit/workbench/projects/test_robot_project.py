"""New projects for robots: their first program runs at once and moves the arm, whatever the arm is."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import ropsim
from ropsim import robots
from ropsim.cellfile import POINTER
from ropsim.cli.testing import main
from ropsim.flow import Fidelity, Recording
from ropsim.model import BASE_LINK, RobotModel, Shape, Sphere
from ropsim.simulation import RunOptions
from ropsim.spatial import Array, Pose
from ropsim.workbench import find_robot, load_robot, new_robot_project, robots_in, written_robot
from ropsim.workbench.testing import first_way
from support.built_in import WRITTEN
from support.published_arms import TABLES, published_arm
from support.robot_files import PUMA560, TWO_JOINTS

TOOL = Pose(np.array([0.0, 0.0, 0.1]))


def run(folder: Path) -> Recording:
    project = ropsim.open(folder)
    assert project.compile().diagnostics == ()
    return project.simulate(options=RunOptions(Fidelity.KINEMATIC))


def travel(recording: Recording) -> float:
    """Return how far the tool went [m]."""
    steps = np.diff(recording.rows("attained_position"), axis=0)
    return float(np.linalg.norm(steps, axis=1).sum())


@pytest.mark.parametrize("name", [*WRITTEN, "irb120"])
def test_the_first_program_of_a_built_in_robot_runs_and_moves(name: str, tmp_path: Path) -> None:
    recording = run(new_robot_project(tmp_path / "my_cell", name))
    assert recording.ok
    assert [one.code for one in recording.findings] == []
    assert travel(recording) > 0.3
    lines = [event for event in recording.events if getattr(event, "motion", None) == "LIN"]
    assert bool(lines) == (name != "two_link")  # two axes cannot lead a tool without turning it


@pytest.mark.parametrize("name", ["patu655", "manutec_r3"])
def test_the_first_program_of_an_arm_that_swings_keeps_its_limits_with_drives_too(
    name: str, tmp_path: Path
) -> None:
    recording = ropsim.open(new_robot_project(tmp_path / "my_cell", name)).simulate()
    assert recording.ok
    settling, posture_for_lines, slowed = "S725", "M585", "M563"
    assert {one.code for one in recording.findings} <= {settling, posture_for_lines, slowed}


def run_with_drives(name: str, folder: Path) -> None:
    """Run the first program of an arm; only hints are found, and it settles soon."""
    recording = ropsim.open(new_robot_project(folder / name, name)).simulate()
    assert recording.ok
    assert {one.code for one in recording.findings} <= {"S725", "M563", "M585"}
    assert not recording.facts.is_kinematic
    assert travel(recording) > 0.1


@pytest.mark.parametrize("name", ["irb120", "panda", "irb660_180_315", "cobra600"])
def test_the_first_program_of_an_arm_with_estimated_drives_runs_without_a_warning(
    name: str, tmp_path: Path
) -> None:
    run_with_drives(name, tmp_path)


@pytest.mark.slow
@pytest.mark.parametrize("name", robots.names())
def test_the_first_program_of_every_arm_runs_with_drives_without_a_warning(name: str, tmp_path: Path) -> None:
    run_with_drives(name, tmp_path)


def test_a_robot_file_is_copied_with_its_meshes(tmp_path: Path) -> None:
    source = tmp_path / "vendor" / "robots" / "arm.toml"
    source.parent.mkdir(parents=True)
    (tmp_path / "vendor" / "geometry").mkdir()
    (tmp_path / "vendor" / "geometry" / "arm.stl").write_bytes(b"solid\nendsolid\n")
    looks = 'links = [{ shapes = [{ mesh = "geometry/arm.stl" }] }, {}]'
    source.write_text(f"{looks}\n{TWO_JOINTS}", "utf-8")
    made = new_robot_project(tmp_path / "my_cell", str(source))
    assert (made / "geometry" / "arm.stl").is_file()
    assert robots_in(made) == (made / "robots" / "arm.toml",)
    recording = run(made)
    assert recording.ok
    assert travel(recording) > 0.3


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted(TABLES)[::4])
def test_a_way_of_any_published_arm_keeps_its_limits(name: str) -> None:
    robot = published_arm(name)
    corners = first_way(robot, TOOL).corners
    assert len(corners) == 4
    for corner in corners:
        found = ropsim.kinematics.inverse(robot, corner @ TOOL.inverse())
        assert len(found.solutions)
        np.testing.assert_array_equal(corner.orientation, corners[0].orientation)


def test_wrong_files_and_names_make_no_project(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    wrong = tmp_path / "arm.toml"
    wrong.write_text(TWO_JOINTS.replace("limits", "lmits"), "utf-8")
    for robot, code, words in (
        (str(wrong), 1, "X802"),
        (str(tmp_path / "none.toml"), 2, "X840"),
        (str(tmp_path / "arm.pdf"), 2, "X911"),
        ("puma", 2, "did you mean `puma560`"),
    ):
        assert main(["new", str(tmp_path / "made"), "--robot", robot]) == code
        assert words in capsys.readouterr().err
        assert not (tmp_path / "made").exists()


def test_robots_are_loaded_by_name_or_path(tmp_path: Path) -> None:
    assert load_robot("scara") is robots.load("scara")
    (tmp_path / "arm.toml").write_text(PUMA560, "utf-8")
    assert load_robot(tmp_path / "arm.toml").n == 6
    assert ropsim.load_robot is load_robot
    assert find_robot(tmp_path / "arm.toml").text is not None


def test_the_commands_for_robots_know_files(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "robots").mkdir()
    file = tmp_path / "robots" / "arm.toml"
    file.write_text("mass = 9000\n" + TWO_JOINTS, "utf-8")
    assert main(["robot", "list", str(tmp_path)]) == 0
    assert f"{file} 2 axes  arm" in capsys.readouterr().out
    assert main(["robot", "show", str(file)]) == 0
    assert "estimated" in capsys.readouterr().out
    assert main(["robot", "fk", str(file), "0", "90"]) == 0
    assert "x 400.000  y 300.000  z 0.000 mm" in capsys.readouterr().out
    assert main(["robot", "audit", str(file)]) == 0
    told = capsys.readouterr().err
    assert "X864" in told
    assert "mass = 9000" in told
    file.write_text(TWO_JOINTS.replace("[-170, 170]", "[170, -170]"), "utf-8")
    for words in (["show"], ["audit"], ["fk"], ["ik"]):
        numbers = {"fk": ["0", "0"], "ik": ["0"] * 6}.get(words[0], [])
        assert main(["robot", *words, str(file), *numbers]) == 1
        assert "arm.toml:4:23" in capsys.readouterr().err
    assert main(["robot", "list", str(tmp_path)]) == 0
    assert "wrong" in capsys.readouterr().out


def with_ball(robot: RobotModel, link: int, p: Array, radius: float = 0.015) -> RobotModel:
    """Return a robot with a ball at a point of a link, from 0, or of the base, in its frame [m]."""
    ball = Shape(Sphere(radius), Pose(p))
    if link == BASE_LINK:
        return replace(robot, base_shapes=(*robot.base_shapes, ball))
    links = list(robot.links)
    links[link] = replace(links[link], shapes=(*links[link].shapes, ball))
    return replace(robot, links=tuple(links))


def made_project(robot: RobotModel, folder: Path) -> Path:
    (folder / "arm.stp").write_text(written_robot(robot, "arm.stp").text, "utf-8")
    return new_robot_project(folder / "cell", str(folder / "arm.stp"))


def collisions(folder: Path) -> list[str]:
    project = ropsim.open(folder)
    return [one.message for one in project.collisions(project.simulate()).findings if one.is_error]


def test_the_first_program_goes_where_the_arm_does_not_meet_itself(tmp_path: Path) -> None:
    """The best way bends the wrist so that the flange is in a ball on the fourth link."""
    robot = robots.load("irb120")
    bent = ropsim.kinematics.inverse(robot, first_way(robot, POINTER).corners[0] @ POINTER.inverse())
    q = bent.solutions[0]
    in_link = np.linalg.inv(ropsim.kinematics.joint_frames(robot, q)[3])
    flange = (in_link @ np.append(ropsim.kinematics.forward(robot, q).position, 1.0))[:3]
    made = made_project(with_ball(robot, 3, flange), tmp_path)
    assert collisions(made) == []
    best = first_way(robot, POINTER).corners[0].position * 1e3
    assert f"position = [{', '.join(f'{c:g}' for c in best.round(6))}]" not in (made / "cell.toml").read_text(
        "utf-8"
    )


def test_a_first_program_in_which_the_arm_meets_itself_says_so(tmp_path: Path) -> None:
    """Two axes have one way, and it leads the tip into a ball on the base."""
    robot = robots.load("two_link")
    tip = ropsim.kinematics.forward(robot, first_way(robot, POINTER).turns[0]).position
    robot = with_ball(with_ball(robot, BASE_LINK, tip), 1, robot.X_nM.position)
    made = made_project(robot, tmp_path)
    program = (made / "programs" / "main.task").read_text("utf-8")
    assert any(f"this one: {one.partition(',')[0]}, " in program for one in collisions(made))
