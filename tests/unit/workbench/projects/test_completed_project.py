"""A new project of a file with masses, torques and friction but no rotors gets these, and runs."""

from pathlib import Path

import numpy as np
import pytest

import ropsim
from ropsim.cli.testing import main
from ropsim.dynamics import rotor_inertias
from ropsim.model import RobotModel
from ropsim.workbench import added_estimates, completed_robot, load_robot, new_robot_project

LINK = (
    '<link name="l{k}"><inertial><origin xyz="{x} 0 {z}"/><mass value="{m}"/>'
    '<inertia ixx="{i}" ixy="0" ixz="0" iyy="{i}" iyz="0" izz="{i}"/></inertial></link>'
)
JOINT = (
    '<joint name="j{k}" type="revolute"><parent link="l{b}"/><child link="l{k}"/><origin xyz="{at}"/>'
    '<axis xyz="{axis}"/><limit lower="-2.5" upper="2.5" effort="{tau}" velocity="3.14"/>{more}</joint>'
)
ROWS = (
    ("0 0 0.27", "0 0 1", 2.2, 5e-3, 50.0),
    ("0 0 0", "0 1 0", 1.7, 2e-2, 50.0),
    ("0 0 0.28", "0 1 0", 1.4, 5e-3, 32.0),
    ("0.07 0 -0.34", "1 0 0", 1.1, 4e-3, 32.0),
    ("0 0 0", "0 1 0", 1.2, 2e-3, 32.0),
    ("0.1 0 0", "1 0 0", 0.11, 8e-5, 20.0),
)
"""Place, axis, mass, moments and effort, about those of a small cobot: joint 6 turns next to nothing."""


def file_of(folder: Path, more: str) -> Path:
    rows = list(enumerate(ROWS, 1))
    links = [LINK.format(k=k, x=0.02, z=0.0, m=m, i=i) for k, (_, _, m, i, _) in rows]
    joints = [JOINT.format(k=k, b=k - 1, at=p, axis=z, tau=t, more=more) for k, (p, z, _, _, t) in rows]
    path = folder / "small.urdf"
    text = f'<robot name="small"><link name="l0"/>{"".join(links)}{"".join(joints)}</robot>'
    path.write_text(text, "utf-8")
    return path


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return file_of(tmp_path, '<dynamics damping="1" friction="1"/>')


def rotors(robot: RobotModel) -> np.ndarray:
    return np.asarray(rotor_inertias(robot, robot.home[None])[0])


def test_the_first_program_runs_with_rotors_by_rule(file: Path, tmp_path: Path) -> None:
    """c·τ/v: 0.018 s of main axes, 0.045 s of the wrist (docs/explanation/estimates.md)."""
    project = ropsim.open(new_robot_project(tmp_path / "cell", str(file)))
    robot = load_robot(tmp_path / "cell" / "robots" / "small.stp")
    expected = np.array([0.018] * 3 + [0.045] * 3) * [50.0, 50.0, 32.0, 32.0, 32.0, 20.0] / 3.14
    np.testing.assert_allclose(rotors(robot), expected, rtol=1e-6)
    assert any("rotors" in one.parameters and one.kind == "estimated" for one in robot.origins)
    recording = project.simulate()
    assert recording.ok
    assert not [one for one in recording.findings if one.severity.value in ("error", "warning")]


def test_without_rotors_the_run_names_the_axis_that_friction_stops(file: Path, tmp_path: Path) -> None:
    place = new_robot_project(tmp_path / "cell", str(file))
    (place / "robots" / "small.urdf").write_text(file.read_text("utf-8"), "utf-8")
    cell = place / "cell.toml"
    text = cell.read_text("utf-8").replace("robots/small.stp", "robots/small.urdf")
    cell.write_text(f"{text}\n[controller]\nplant_steps = 2\n", "utf-8")
    (found,) = (one for one in ropsim.open(place).simulate().findings if one.is_error)
    assert found.code == "S701"
    assert "axis `j6` moves 7.9e-05 kg·m²" in found.message
    assert "d/J·dt is" in found.message


def test_a_file_without_torques_and_friction_stays_as_it_is(tmp_path: Path) -> None:
    path = file_of(tmp_path, "")
    path.write_text(path.read_text("utf-8").replace("effort=", "was="), "utf-8")
    robot = load_robot(path)
    assert completed_robot(robot) is robot
    assert added_estimates(robot) == ()


def test_the_command_says_what_is_estimated(
    file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["new", str(tmp_path / "cell"), "--robot", str(file)]) == 0
    assert "the file has no motors; estimated are rotors and gears (×3)" in capsys.readouterr().out
