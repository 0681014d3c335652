"""Conditions beyond the range of a sensor: said by `ropsim check`."""

from pathlib import Path

import pytest

from ropsim.workbench import open_project

CELL = """
[cell]
name = "c"
[robot]
model = "puma560"
tool = "tip"
[tools.tip]
shapes = [{ cylinder = { radius = 10, length = 100 }, position = [0, 0, 50] }]
[contacts.tip_on_floor]
of = "tip"
with = ["floor"]
stiffness = 50
[signals.force_z]
input = 1
analog = true
sensor = { kind = "force torque", axis = "z", range = 8 }
[signals.height]
input = 2
analog = true
sensor = { kind = "distance", range = 150 }
[signals.free_force]
input = 3
analog = true
sensor = { kind = "force torque", axis = "z" }
"""
PROGRAM = """program main
units mm, deg, s
mov joints(0, 45, 180, 0, 45, 0)
"""


@pytest.mark.parametrize(
    ("condition", "words"),
    [
        ("force_z > 10 N", "is never above 10 N"),
        ("force_z < -8 N", "is never below -8 N"),
        ("height > 150 mm", "is never above 0.15 m"),
        ("height < 151 mm", "is always below 0.151 m"),
        ("force_z > 7 N", ""),
        ("height < 150 mm", ""),
        ("free_force > 1000 N", ""),
    ],
)
def test_a_condition_beyond_the_range_is_found_at_its_line(
    tmp_path: Path, condition: str, words: str
) -> None:
    (tmp_path / "programs").mkdir()
    (tmp_path / "cell.toml").write_text(CELL, "utf-8")
    line = f"lin here offset (0, 0, -20) until {condition}\n"
    (tmp_path / "programs" / "main.task").write_text(PROGRAM + line, "utf-8")
    project = open_project(tmp_path)
    found = project.compile().diagnostics
    assert not any(one.is_error for one in found), found
    told = [one for one in found if one.code == "X932"]
    assert [words in one.message for one in told] == ([True] if words else [])
    assert all(one.span and one.span.line == 4 for one in told)
    (text,) = project.sources.values()
    at = project.workspace.at(
        project.cell_text, str(tmp_path), "", project.robots, project.tasks, project.points
    )
    in_editor = project.workspace.checked(text, {"robot": at}).diagnostics
    assert [one.message for one in in_editor if one.code == "X932"] == [one.message for one in told]
