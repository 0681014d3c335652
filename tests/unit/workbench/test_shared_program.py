"""A program that several stations run is checked at each of them."""

from pathlib import Path

import pytest

from ropsim.workbench import Project, open_project
from support.editors import Editor, uri_of

CELL = """\
[stations.left]
robot = "puma560"
tool = "jaws"
program = "both"
tools = ["jaws", "pen"]

[stations.right]
robot = "puma560"
base = { position = [1200, 0, 0], rpy = [0, 0, 180] }
tool = "jaws"
program = "both"
tools = ["jaws"]

[tools.jaws]
position = [0, 0, 150]

[tools.pen]
position = [0, 0, 100]
"""


@pytest.fixture
def project(tmp_path: Path) -> Project:
    (tmp_path / "programs").mkdir()
    (tmp_path / "cell.toml").write_text(CELL)
    (tmp_path / "programs" / "both.task").write_text(
        "program both\nunits mm, deg\nmov (500, 0, 300) tool pen\n"
    )
    return open_project(tmp_path)


def test_what_only_one_of_them_lacks_is_found_once(project: Project) -> None:
    assert project.diagnostics == ()
    found = project.compile().diagnostics
    assert [(one.severity.value, one.span and one.span.line) for one in found] == [("error", 3)]
    assert "pen" in found[0].message
    assert found[0].notes == ("at station `right` only",)


def test_what_all_of_them_lack_names_no_station(project: Project) -> None:
    place = project.folder / "programs" / "both.task"
    place.write_text("program both\nunits mm, deg\nmov (500, 0, 300) tool pne\nmov (500, 0, 300) tool pen\n")
    found = open_project(project.folder).compile().diagnostics
    assert [(one.span.line if one.span else 0, one.message.split("`")[1], one.notes) for one in found] == [
        (3, "pne", ()),
        (4, "pen", ("at station `right` only",)),
    ]


def test_an_editor_is_told_the_same(project: Project) -> None:
    place = project.folder / "programs" / "both.task"
    (found,) = Editor().open(uri_of(place), place.read_text())
    assert found["range"]["start"]["line"] == 2
    assert found["message"].splitlines()[1] == "at station `right` only"
