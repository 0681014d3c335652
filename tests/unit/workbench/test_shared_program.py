"""A program that several stations run is checked at each of them."""

from pathlib import Path

import pytest

from ropsim.simulation import Fidelity, RunOptions
from ropsim.views import group_findings
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


def test_what_is_found_when_it_runs_names_each_station(project: Project) -> None:
    """Nothing is there to be gripped; passes of a loop at one station are still one finding."""
    cell = project.folder / "cell.toml"
    cell.write_text(CELL.replace("[tools.jaws]\n", "[tools.jaws]\ngripper = {}\n"))
    place = project.folder / "programs" / "both.task"
    place.write_text("program both\nunits mm, deg, s\nrepeat 2\nclose\nopen\nendr\n")
    recording = open_project(project.folder).simulate(options=RunOptions(Fidelity.KINEMATIC))
    groups = group_findings(one for one in recording.findings if one.code == "S721")
    assert [(one.count, one.passes, one.first.notes) for one in groups] == [
        (2, (1, 2), ("at station `left`",)),
        (2, (1, 2), ("at station `right`",)),
    ]
    assert [one.first.data["station"] for one in groups] == ["left", "right"]


def test_two_that_wait_in_vain_are_two_findings(project: Project) -> None:
    cell = project.folder / "cell.toml"
    cell.write_text(CELL + "[signals.go]\noutput = 1\n")
    place = project.folder / "programs" / "both.task"
    place.write_text("program both\nunits mm, deg, s\nwait until go\n")
    recording = open_project(project.folder).simulate(options=RunOptions(Fidelity.KINEMATIC))
    groups = group_findings(recording.findings)
    assert [(one.first.code, one.count, one.first.message[:8]) for one in groups] == [
        ("S742", 1, "`left` w"),
        ("S742", 1, "`right` "),
    ]


def test_what_is_found_at_a_station_with_a_program_of_its_own_needs_no_name(project: Project) -> None:
    cell = project.folder / "cell.toml"
    own = CELL.replace('program = "both"\ntools = ["jaws"]', 'program = ""\ntools = ["jaws"]')
    cell.write_text(own.replace("[tools.jaws]\n", "[tools.jaws]\ngripper = {}\n"))
    place = project.folder / "programs" / "both.task"
    place.write_text("program both\nunits mm, deg, s\nclose\n")
    recording = open_project(project.folder).simulate(options=RunOptions(Fidelity.KINEMATIC))
    assert [(one.code, one.notes) for one in recording.findings if one.code == "S721"] == [("S721", ())]


def test_an_editor_is_told_the_same(project: Project) -> None:
    place = project.folder / "programs" / "both.task"
    (found,) = Editor().open(uri_of(place), place.read_text())
    assert found["range"]["start"]["line"] == 2
    assert found["message"].splitlines()[1] == "at station `right` only"
