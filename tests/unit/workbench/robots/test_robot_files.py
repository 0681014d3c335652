"""Projects whose robots come from files: read from inside the folder, run with or without drives."""

from pathlib import Path

import numpy as np
import pytest

import ropsim
from ropsim.core import Severity
from ropsim.flow import Fidelity, Recording
from ropsim.model import ControllerKind
from ropsim.simulation import RunOptions
from ropsim.views import Style
from ropsim.workbench import ROBOT_FORMATS, Project, open_overlaid
from support.robot_files import PUMA560, TWO_JOINTS

LIMITS = """
[controller]
joint_speed = [110, 86, 137, 305, 291, 328]
joint_acceleration = [340, 280, 510, 1400, 1400, 1400]
joint_jerk = [3400, 2800, 5100, 14000, 14000, 14000]
path_acceleration = 2000
path_jerk = 20000
orientation_speed = 60
orientation_acceleration = 340
orientation_jerk = 3400
"""
PROGRAM = "program main\nunits mm, deg, s\nmov (450, 150, 500)\nlin (450, 50, 450)\n"
BENT = "program main\nunits mm, deg, s\nmov joints(30, 60)\nmov joints(-40, 90)\n"


def project(folder: Path, cell: str, program: str = PROGRAM, **robots: str) -> Project:
    """Return a project; its robots are texts by the names of their files."""
    (folder / "programs").mkdir(parents=True)
    (folder / "robots").mkdir()
    (folder / "cell.toml").write_text(cell, "utf-8")
    (folder / "programs" / "main.task").write_text(program, "utf-8")
    for name, text in robots.items():
        (folder / "robots" / f"{name}.toml").write_text(text, "utf-8")
    return ropsim.open(folder)


def codes(made: Project) -> list[str]:
    return [one.code for one in made.diagnostics]


def notes(recording: Recording) -> list[str]:
    return [one.code for one in recording.findings]


def test_a_robot_of_a_file_runs_bit_for_bit_as_the_built_in_one_of_the_same_numbers(tmp_path: Path) -> None:
    own = project(tmp_path / "own", f'[robot]\nmodel = "robots/puma.toml"\n{LIMITS}', puma=PUMA560)
    built_in = project(tmp_path / "built_in", f'[robot]\nmodel = "puma560"\n{LIMITS}')
    assert codes(own) == []
    one, other = own.simulate(), built_in.simulate()
    assert one.ok
    assert other.ok
    assert one.channels.keys() == other.channels.keys()
    for name in one.channels:
        np.testing.assert_array_equal(one.rows(name), other.rows(name), err_msg=name)


def test_a_robot_without_drives_runs_without_dynamics_and_says_so(tmp_path: Path) -> None:
    made = project(tmp_path / "c", '[robot]\nmodel = "robots/arm.toml"\n', BENT, arm=TWO_JOINTS)
    assert made.cell is not None
    assert made.cell.first.controller.kind is ControllerKind.IDEAL
    recording = made.simulate()
    assert recording.ok
    assert notes(recording) == ["S750"]
    assert recording.facts.is_kinematic
    text = made.report(recording).text(Style.PLAIN)
    assert "torques, drives, servo" in text
    assert "dynamics are not simulated" in text
    asked = made.simulate(options=RunOptions(Fidelity.KINEMATIC))
    assert notes(asked) == []
    np.testing.assert_array_equal(asked.rows("q"), recording.rows("q"))
    assert np.abs(np.gradient(recording.rows("q")[:, 0], recording.time)).max() <= np.radians(120.0) * 1.001


def test_robots_with_and_without_drives_work_in_one_cell(tmp_path: Path) -> None:
    cell = (
        '[stations.left]\nrobot = "scara"\nprogram = ""\n'
        '[stations.right]\nrobot = "robots/arm.toml"\nbase = { position = [2000, 0, 0] }\nprogram = "main"\n'
    )
    made = project(tmp_path / "c", cell, BENT, arm=TWO_JOINTS)
    recording = made.simulate()
    assert recording.ok
    assert notes(recording) == ["S750"]
    assert not recording.facts.is_kinematic
    assert {one.name: bool(one.law) for one in recording.facts.stations} == {"left": True, "right": False}
    assert "left/tau" in recording.channels
    assert "right/tau" not in recording.channels
    assert "its dynamics are not simulated" in made.report(recording).html()


def test_mistakes_of_a_robot_file_are_findings_of_the_project_at_their_places(tmp_path: Path) -> None:
    wrong = TWO_JOINTS.replace("limits", "lmits")
    made = project(tmp_path / "c", '[robot]\nmodel = "robots/arm.toml"\n', arm=wrong)
    assert made.is_broken
    assert {"X802"} == set(codes(made))
    span = made.diagnostics[0].span
    assert span is not None
    assert Path(span.source) == made.folder / "robots" / "arm.toml"
    assert "lmits" in made.texts[span.source].line(span.line)


@pytest.mark.parametrize(
    ("path", "code", "words"),
    [
        ("robots/other.toml", "X840", "did you mean `arm.toml`"),
        ("../arm.toml", "U962", "leads out of the project folder"),
        ("/etc/arm.toml", "U962", "leads out of the project folder"),
        ("C:\\\\arm.toml", "U962", "leads out of the project folder"),
        ("robots/link.toml", "U962", "is a link"),
        ("robots/arm.pdf", "X911", "`.toml`"),
        ("robots/arm", "X911", "did you mean `arm.toml`"),
        ("robots/\\u0000.toml", "X841", "cannot be opened"),
        ("robots", "X860", "`puma560`"),
    ],
)
def test_a_path_that_gives_no_robot_is_told_in_the_cell_file(
    tmp_path: Path, path: str, code: str, words: str
) -> None:
    made = project(tmp_path / "c", "[robot]\nmodel = 'scara'\n", arm=TWO_JOINTS)
    (tmp_path / "arm.toml").write_text(TWO_JOINTS, "utf-8")
    (made.folder / "robots" / "link.toml").symlink_to(tmp_path / "arm.toml")
    (made.folder / "cell.toml").write_text(f'[robot]\nmodel = "{path}"\n', "utf-8")
    (found,) = ropsim.open(made.folder).diagnostics
    assert found.code == code
    assert found.severity is Severity.ERROR
    assert words in f"{found.message} {found.hint}"
    assert found.span is not None
    assert (found.span.line, found.span.column) == (2, 9)


def test_unsaved_texts_of_robots_count_before_their_files(tmp_path: Path) -> None:
    made = project(tmp_path / "c", '[robot]\nmodel = "robots/arm.toml"\n', BENT, arm=TWO_JOINTS)
    longer = open_overlaid(made.folder, {"robots/arm.toml": TWO_JOINTS.replace("400", "500")})
    assert longer.cell is not None
    assert longer.cell.first.robot.joints[1].placement.position[0] == 0.5


def test_two_stations_share_a_file_and_its_findings_are_told_once(tmp_path: Path) -> None:
    cell = "".join(f'[stations.{name}]\nrobot = "robots/arm.toml"\nprogram = ""\n' for name in "ab")
    doubtful = TWO_JOINTS.replace("alpha = 180", "alpha = 3.1416")
    made = project(tmp_path / "c", cell, arm=doubtful)
    assert codes(made) == ["X822"]
    assert made.cell is not None
    one, other = made.cell.stations.values()
    assert one.robot == other.robot


@pytest.mark.parametrize("ending", [".toml", ".urdf", ".xml"])
def test_a_cell_runs_a_robot_of_each_format_that_is_written(tmp_path: Path, ending: str) -> None:
    written = ROBOT_FORMATS[ending].write
    assert written is not None
    text = written(ropsim.load_robot("puma560")).text
    built_in = project(tmp_path / "built_in", '[robot]\nmodel = "puma560"\n')
    made = project(tmp_path / "made", f'[robot]\nmodel = "robots/arm{ending}"\n')
    (made.folder / "robots" / f"arm{ending}").write_text(text, "utf-8")
    ends = []
    for one in (built_in, made):
        recording = ropsim.open(one.folder).simulate(options=RunOptions(Fidelity.KINEMATIC))
        assert recording.ok
        ends.append(recording.rows("q")[-1])
    np.testing.assert_allclose(ends[1], ends[0], atol=1e-9)
