"""The key `package` of a cell file: folders of the project by name, and nothing else."""

from pathlib import Path

import pytest

import ropsim
from ropsim.core import Diagnostic

ARM = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:include filename="$(find parts)/part.xacro"/>
<link name="base"/><link name="tool0"/>
<joint name="j" type="revolute"><parent link="base"/><child link="tool0"/><axis xyz="0 0 1"/>
<limit lower="-1" upper="1" velocity="1" effort="10"/></joint></robot>"""
PART = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"/>'
NONE = ARM.replace('<xacro:include filename="$(find parts)/part.xacro"/>', "")


def findings(folder: Path, package: str, arm: str = ARM) -> tuple[Diagnostic, ...]:
    """Return the errors of a project whose cell gives a package."""
    for name in ("programs", "robots", "parts"):
        (folder / name).mkdir(parents=True, exist_ok=True)
    (folder / "parts" / "part.xacro").write_text(PART, "utf-8")
    (folder / "robots" / "arm.xacro").write_text(arm, "utf-8")
    (folder / "cell.toml").write_text(f'[robot]\nmodel = "robots/arm.xacro"\npackage = {package}\n', "utf-8")
    (folder / "programs" / "main.task").write_text("program main\nmov joints(10)\n", "utf-8")
    return tuple(one for one in ropsim.open(folder).diagnostics if one.is_error)


def test_a_package_is_a_folder_of_the_project(tmp_path: Path) -> None:
    assert findings(tmp_path, '{ parts = "parts" }') == ()


@pytest.mark.parametrize(
    ("package", "code", "column", "words"),
    [
        ("{ parts = 5 }", "X804", 21, "`robot.package.parts` is a whole number, needed is text"),
        ("{ parts = true }", "X804", 21, "is true or false"),
        ("true", "X804", 11, "`robot.package` is true or false"),
        ('"parts"', "X804", 11, "`robot.package` is text"),
        ('{ parts = "/etc" }', "U962", 21, "`/etc` leads out of the project folder"),
        ('{ parts = "../parts" }', "U962", 21, "`../parts` leads out of the project folder"),
        ('{ parts = "C:/parts" }', "U962", 21, "leads out of the project folder"),
    ],
)
def test_another_value_is_told_where_it_stands(
    package: str, code: str, column: int, words: str, tmp_path: Path
) -> None:
    (one,) = findings(tmp_path, package, NONE)
    assert one.code == code
    assert one.span is not None
    assert (Path(one.span.source).name, one.span.line, one.span.column) == ("cell.toml", 3, column)
    assert words in one.message


def test_a_link_to_a_folder_elsewhere_opens_none_of_its_files(tmp_path: Path) -> None:
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    (elsewhere / "part.xacro").write_text(PART, "utf-8")
    project = tmp_path / "project"
    project.mkdir()
    (project / "link").symlink_to(elsewhere)
    assert [one.code for one in findings(project, '{ parts = "link" }')] == ["X992"]
