"""Projects with unsaved texts."""

from pathlib import Path

import pytest

from ropsim.workbench import ProjectError, new_project, open_overlaid, open_project

PROGRAM = "program p\nunits mm, deg\nmov home\n"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    new_project(tmp_path / "cell", "first_cell")
    return tmp_path / "cell"


def test_without_unsaved_texts_it_is_the_project_of_the_files(folder: Path) -> None:
    overlaid, opened = open_overlaid(folder, {}), open_project(folder)
    assert {name: text.text for name, text in overlaid.sources.items()} == {
        name: text.text for name, text in opened.sources.items()
    }
    assert overlaid.cell_text is not None
    assert opened.cell_text is not None
    assert overlaid.cell_text.text == opened.cell_text.text


def test_an_unsaved_text_counts_instead_of_its_file_and_the_file_stays(folder: Path) -> None:
    file = folder / "programs" / "main.task"
    before = file.read_bytes()
    project = open_overlaid(folder, {"programs/main.task": PROGRAM})
    assert project.sources["main"].text == PROGRAM
    assert file.read_bytes() == before


def test_findings_name_a_text_by_its_place_in_the_project(folder: Path) -> None:
    project = open_overlaid(folder, {"programs/main.task": "program p\nmoov home\n"})
    (found, *_) = project.program("main").diagnostics
    assert found.span is not None
    assert (found.span.source, found.span.line) == ("programs/main.task", 2)


def test_a_program_that_is_no_file_yet_belongs_to_the_project(folder: Path) -> None:
    project = open_overlaid(folder, {"programs/other.task": PROGRAM})
    assert set(project.sources) == {"main", "other"}


def test_places_outside_the_project_are_left_out(folder: Path) -> None:
    texts = {"../x.task": PROGRAM, "x.task": PROGRAM, "programs/deep/x.task": PROGRAM, "programs/x.py": ""}
    assert set(open_overlaid(folder, texts).sources) == {"main"}


def test_a_broken_unsaved_cell_file_is_a_finding_with_its_line(folder: Path) -> None:
    project = open_overlaid(folder, {"cell.toml": "[robot]\nmodel = 3\n"})
    assert project.cell is None
    (found, *_) = project.diagnostics
    assert found.span is not None
    assert (found.span.source, found.span.line) == ("cell.toml", 2)


def test_a_folder_without_a_cell_file_is_no_project(tmp_path: Path) -> None:
    with pytest.raises(ProjectError, match=r"has no `cell\.toml`"):
        open_overlaid(tmp_path, {})


def test_an_unsaved_cell_file_is_enough(tmp_path: Path) -> None:
    assert open_overlaid(tmp_path, {"cell.toml": '[robot]\nmodel = "puma560"\n'}).cell is not None
