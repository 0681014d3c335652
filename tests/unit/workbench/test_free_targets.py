"""Targets that an arm with two axes reaches with free orientation only: said by `ropsim check`."""

from pathlib import Path

import pytest

from ropsim.core import Diagnostic
from ropsim.workbench import open_project

CELL = '[cell]\nname = "c"\n[robot]\nmodel = "{model}"\n[signals.far]\ninput = 1\n'
TURNED = "(850, 0, 700)"


def findings(folder: Path, lines: str, model: str = "two_link") -> list[Diagnostic]:
    (folder / "programs").mkdir()
    (folder / "cell.toml").write_text(CELL.format(model=model), "utf-8")
    text = f"program main\nunits mm, deg, s\n{lines}\n"
    (folder / "programs" / "main.task").write_text(text, "utf-8")
    project = open_project(folder)
    found = project.compile().diagnostics
    assert not any(one.is_error for one in found), found
    return [one for one in found if one.code == "X931"]


def test_a_target_with_constant_numbers_is_found_at_its_line(tmp_path: Path) -> None:
    found = findings(tmp_path, f"mov {TURNED}\nlin (850, 0, 900) free\nmov {TURNED} free")
    assert [one.span.line for one in found if one.span] == [3]
    assert "write `free`" in (found[0].hint or "")
    assert not found[0].is_error  # a run goes on without the move


@pytest.mark.parametrize(
    ("lines", "model"),
    [
        (f"mov {TURNED}", "puma560"),
        ("mov (9850, 0, 700)", "two_link"),
        (
            "var high: length = 600 mm\nfor k = 1 to 3\n    mov (850, 0, high)\n    high = high + 50 mm\nend",
            "two_link",
        ),
        (
            "signal far = input 1\nvar high: length = 700 mm\nif far then high = 750 mm\nmov (850, 0, high)",
            "two_link",
        ),
        ("mov joints(10, 20)", "two_link"),
    ],
    ids=["six axes", "out of reach", "other numbers each time", "numbers by an input", "joints"],
)
def test_what_is_reached_or_not_known_is_left_to_the_run(tmp_path: Path, lines: str, model: str) -> None:
    assert not findings(tmp_path, lines, model)


def test_the_editor_says_it_and_a_run_does_not_repeat_it(tmp_path: Path) -> None:
    findings(tmp_path, f"mov {TURNED}")
    project = open_project(tmp_path)
    (text,) = project.sources.values()
    assert project.cell
    at = project.workspace.at(
        project.cell_text, str(tmp_path), "", project.robots, project.tasks, project.points
    )
    checked = project.workspace.checked(text, {"robot": at})
    assert [one.code for one in checked.diagnostics] == ["X931"]
    assert not project.program().diagnostics
