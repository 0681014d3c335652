"""Points of a program, for other arms and other places of the base."""

import json
from pathlib import Path

import numpy as np
import pytest

import ropsim
from ropsim.cli.testing import main
from ropsim.spatial import Pose
from ropsim.workbench import Project, new_project, program_points

CELL = """[robot]
model = "puma560"
tool = "pin"
[tools.pin]
position = [0, 0, 100]
[locations.side]
position = [500, 0, 600]
rpy = [180, 0, 0]
"""
TASK = """program main
units mm, deg, s
mov (500, 100, 600; rpy 180 0 0)
for k = 1 to 3
  lin side
end
circ via (450, 50, 600; rpy 180 0 0) to (500, 100, 600; rpy 180 0 0)
mov home
"""


def project(folder: Path, task: str = TASK) -> Project:
    (folder / "programs").mkdir(parents=True)
    (folder / "cell.toml").write_text(CELL, "utf-8")
    (folder / "programs" / "main.task").write_text(task, "utf-8")
    return ropsim.open(folder)


def test_targets_and_points_on_the_way_count_once_with_the_tool_that_is_asked_for(tmp_path: Path) -> None:
    points, told = program_points(project(tmp_path / "c"), Pose(np.array([0.0, 0.0, 0.1])))
    assert [one.name for one in points] == ["line 3", "line 5", "line 7"]
    places = [one.position for one in points]
    np.testing.assert_allclose(places, [[0.5, 0.1, 0.6], [0.5, 0.0, 0.6], [0.45, 0.05, 0.6]], atol=1e-12)
    assert [one.code for one in told] == ["W112"]
    assert "1 move of" in told[0].message


def test_without_a_tool_they_are_where_the_flange_is_put(tmp_path: Path) -> None:
    points, _ = program_points(project(tmp_path / "c"))
    np.testing.assert_allclose([one.position[2] for one in points], [0.7] * 3, atol=1e-12)


def test_a_program_with_mistakes_or_without_points_says_so(tmp_path: Path) -> None:
    points, told = program_points(project(tmp_path / "a", TASK.replace("lin side", "lin astray")))
    assert not points
    assert any(one.is_error for one in told)
    points, told = program_points(project(tmp_path / "b", "program main\nmov home\n"))
    assert [one.code for one in told] == ["W112", "W111"]


def test_the_command_asks_a_robot_for_the_points_of_an_example(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    new_project(tmp_path / "cell", "first_cell")
    assert main(["robot", "workspace", "scara", "--points", str(tmp_path / "cell"), "--json"]) == 1
    ranking = json.loads(capsys.readouterr().out)["ranking"]
    assert [one["name"] for one in ranking[0]["points"]] == ["line 6", "line 7", "line 10", "line 11"]
