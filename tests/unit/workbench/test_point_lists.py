"""Lists of points in projects: read, changed, wrong, and kept for other processes."""

from pathlib import Path

import pytest

import ropsim
from ropsim.core import KeptFiles
from ropsim.flow import MoveEvent
from ropsim.workbench import Project, ProjectError, Workspace, new_project, open_overlaid, open_project
from ropsim.workbench.testing import questions

LIST = "x,y,z\nmm,mm,mm\n500,-100,600\n500,0,600\n500,100,600\n"
PROGRAM = "program seams\nunits mm, deg, s\nlin along seam blend 5 speed 200\n"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    made = new_project(tmp_path / "cell", "first_cell")
    (made / "points").mkdir()
    (made / "points" / "seam.csv").write_text(LIST, "utf-8")
    (made / "programs" / "main.task").write_text(PROGRAM, "utf-8")
    return made


def codes(project: Project) -> list[str]:
    return [one.code for one in project.compile().diagnostics]


def test_a_run_flies_along_the_list_of_a_project(folder: Path) -> None:
    recording = ropsim.open(folder).simulate()
    assert recording.ok
    assert len(recording.events_of(MoveEvent)) == 3


@pytest.mark.parametrize("opened", [open_project, lambda folder: open_overlaid(folder, {})])
def test_a_wrong_cell_is_found_wherever_a_project_is_opened(folder: Path, opened: object) -> None:
    (folder / "points" / "seam.csv").write_text(LIST.replace("100,600", "100,6oo", 1), "utf-8")
    assert callable(opened)
    project = opened(folder)
    found = project.compile().diagnostics
    assert [one.code for one in found] == ["P148", "N226"]
    assert found[0].span is not None
    assert (found[0].span.line, found[0].span.column) == (3, 10)
    assert Path(found[0].span.source).name == "seam.csv"
    assert found[0].span.source in project.texts
    with pytest.raises(ProjectError):
        project.simulate()


def test_a_changed_list_is_read_again(folder: Path) -> None:
    workspace = Workspace()
    assert codes(open_project(folder, workspace)) == []
    (folder / "points" / "seam.csv").write_text("x,y,z\nmm,mm,mm\n500,0,600\n", "utf-8")
    changed = open_project(folder, workspace)
    program = changed.program().icr
    assert program is not None
    assert [len(one.poses) for one in program.lists] == [1]
    (folder / "points" / "seam.csv").unlink()
    assert codes(open_project(folder, workspace)) == ["N226"]


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("pick_up", "`pick_up` is a location of the cell: programs cannot name the list"),
        ("jaws", "`jaws` is a tool of the cell: programs cannot name the list"),
        ("two words", "programs cannot name the list `two words`"),
        ("lin", "programs cannot name the list `lin`"),
        ("fine", "programs cannot name the list `fine`"),
        ("via", "programs cannot name the list `via`"),
        ("track", "programs cannot name the list `track`"),
    ],
)
def test_a_list_that_programs_cannot_name_is_told(folder: Path, name: str, said: str) -> None:
    (folder / "points" / f"{name}.csv").write_text(LIST, "utf-8")
    (found,) = open_project(folder).compile().diagnostics
    assert (found.code, found.message) == ("P163", said)


def test_a_project_without_lists_reads_none(tmp_path: Path) -> None:
    made = new_project(tmp_path / "cell", "first_cell")
    assert not open_project(made).points.texts


def test_answers_with_lists_are_kept_for_other_processes(folder: Path, tmp_path: Path) -> None:
    program = folder / "programs" / "main.task"
    program.write_text(PROGRAM + "# a line\n" * questions.LEAST_LINES, "utf-8")
    kept = KeptFiles("kept", 64_000_000, 16_000_000, lambda: tmp_path)
    first = Workspace(kept)
    wanted = open_project(folder, first).program().icr
    first.keep()
    again = Workspace(kept)
    assert open_project(folder, again).program().icr == wanted
    (folder / "points" / "seam.csv").write_text(LIST.replace("-100", "-90"), "utf-8")
    changed = open_project(folder, again).program().icr
    assert changed is not None
    assert wanted is not None
    assert changed.lists != wanted.lists


def test_a_list_that_cannot_be_read_is_there_all_the_same(folder: Path) -> None:
    """What is wrong is said at the file; the program is not told that the project has no list."""
    (folder / "points" / "seam.csv").write_bytes(b"x;y;z\nmm;mm;mm\n" + b"300;0;300\n" * 2_100_000)
    found = open_project(folder).compile().diagnostics
    assert [one.code for one in found] == ["P148", "N226"]
    assert found[1].message == "the list of points `seam` cannot be used: its text is wrong"
    assert found[1].hint.startswith("mend `")
    assert found[1].hint.endswith("points/seam.csv`")
