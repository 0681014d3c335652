"""A new project bears the name of its folder, whatever that is."""

from pathlib import Path

import pytest

from ropsim import language
from ropsim.language import RESERVED_WORDS
from ropsim.userfiles import example_names
from ropsim.workbench import new_project, open_project
from ropsim.workbench.testing import LONGEST, name_from_folder, name_project

ODD = [
    "my cell",
    "2nd-Zelle",
    "repeat",
    "ä",
    "..x",
    'q"uo\\te',
    "日本",
    "a\nb",
    "-",
    "x" * 200,
    "Task",
    "${x}",
]


@pytest.mark.parametrize(
    ("folder", "name"),
    [
        ("press_line_3", "press_line_3"),
        ("Zelle Süd", "Zelle_Sud"),
        ("2nd cell", "cell_2nd_cell"),
        ("repeat", "cell_repeat"),
        ("日本", "cell"),
        ("", "cell"),
    ],
)
def test_a_folder_gives_a_name_of_the_task_language(folder: str, name: str) -> None:
    assert name_from_folder(folder) == name


@pytest.mark.parametrize("folder", ODD)
def test_a_project_in_an_oddly_named_folder_compiles_and_has_its_name(folder: str, tmp_path: Path) -> None:
    project = open_project(new_project(tmp_path / folder))
    name = name_from_folder(folder)
    assert project.compile().diagnostics == ()
    assert project.cell is not None
    assert project.cell.name == name
    code = project.program().icr
    assert code is not None
    assert code.name == name
    assert len(name) <= LONGEST + len("cell_")


@pytest.mark.parametrize("word", sorted(RESERVED_WORDS))
def test_a_folder_named_like_a_word_of_the_language_gives_a_name_that_a_program_may_have(word: str) -> None:
    name = name_from_folder(word.title())
    found = language.compile(f"program {name}\n").diagnostics
    assert not [one for one in found if one.is_error]


@pytest.mark.parametrize("example", example_names())
def test_an_example_differs_from_its_copy_by_the_name_only(example: str, tmp_path: Path) -> None:
    made, twin = new_project(tmp_path / "mine", example), new_project(tmp_path / example, example)
    for file in sorted(path for path in made.rglob("*") if path.is_file()):
        text = (twin / file.relative_to(made)).read_bytes()
        changed = text.replace(f'name = "{example}"'.encode(), b'name = "mine"', 1)
        changed = changed.replace(f"program {example}\n".encode(), b"program mine\n", 1)
        assert file.read_bytes() == changed
    project = open_project(made)
    assert project.cell is not None
    assert project.cell.name == "mine"


def test_the_folder_in_which_the_command_runs_gives_its_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "station").mkdir()
    monkeypatch.chdir(tmp_path / "station")
    project = open_project(new_project("."))
    assert project.cell is not None
    assert project.cell.name == "station"


def test_comments_and_line_ends_stay(tmp_path: Path) -> None:
    (tmp_path / "programs").mkdir()
    cell, program = tmp_path / "cell.toml", tmp_path / "programs" / "main.task"
    cell.write_bytes(
        b'# first_cell\r\n[cell]\r\n# of the "first_cell"\r\nname = "first_cell"  # here\r\n[robot]\r\n'
    )
    program.write_bytes(b"# program first_cell\r\nprogram first_cell  # first_cell\r\nx = 1\r\n")
    name_project(tmp_path, "mine")
    assert cell.read_bytes() == (
        b'# first_cell\r\n[cell]\r\n# of the "first_cell"\r\nname = "mine"  # here\r\n[robot]\r\n'
    )
    assert program.read_bytes() == b"# program first_cell\r\nprogram mine  # first_cell\r\nx = 1\r\n"


def test_a_program_with_a_name_of_its_own_keeps_it(tmp_path: Path) -> None:
    (tmp_path / "programs").mkdir()
    (tmp_path / "cell.toml").write_text('[cell]\nname = "first"\n')
    (tmp_path / "programs" / "main.task").write_text("program first_of_many\n")
    name_project(tmp_path, "mine")
    assert (tmp_path / "programs" / "main.task").read_text() == "program first_of_many\n"
