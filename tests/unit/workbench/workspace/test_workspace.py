"""One place asks for what is made of texts: what an edit does not reach is not made again."""

from math import radians
from pathlib import Path

import pytest

from ropsim.core import SourceText
from ropsim.query import Outcome
from ropsim.workbench import (
    Project,
    Workspace,
    moves_by_line,
    new_project,
    open_overlaid,
    open_project,
    places_of,
)
from support.robot_files import PUMA560

CELL = SourceText(
    "cell.toml",
    '[cell]\nname = "c"\nprogram = "p"\n[robot]\nmodel = "puma560"\n'
    "[locations.bin]\nposition = [300, 200, 500]\n",
)
PROGRAM = SourceText("p.task", "program p\nmov bin\n")


class Watched:
    """A project that is opened again and again, and what ran for it."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.workspace = Workspace()
        self.workspace.watch()

    def opened(self, **texts: str) -> Project:
        """Open and compile the project with texts that are not saved."""
        assert self.workspace.events is not None
        self.workspace.events.clear()
        names = {"cell": "cell.toml", "main": "programs/main.task"}
        unsaved = {names[name]: text for name, text in texts.items()}
        project = open_overlaid(self.folder, unsaved, self.workspace)
        fresh = open_overlaid(self.folder, unsaved)
        assert project == fresh
        assert project.compile() == fresh.compile()
        return project

    def ran(self) -> list[str]:
        """Return which functions gave new answers."""
        return [one.function for one in self.workspace.events or [] if one.outcome is Outcome.RAN]


@pytest.fixture
def watched(tmp_path: Path) -> Watched:
    """Return a project that was compiled."""
    new_project(tmp_path / "p")
    made = Watched(tmp_path / "p")
    made.opened()
    return made


def text_of(watched: Watched, name: str) -> str:
    return (watched.folder / name).read_text(encoding="utf-8")


def test_a_project_that_is_opened_again_is_neither_read_nor_compiled(watched: Watched) -> None:
    watched.opened()
    assert watched.ran() == []


def test_a_comment_in_the_cell_file_compiles_nothing(watched: Watched) -> None:
    watched.opened(cell=text_of(watched, "cell.toml") + "\n# done\n")
    assert watched.ran() == []


def test_an_edit_of_a_program_does_not_read_the_cell(watched: Watched) -> None:
    watched.opened(main=text_of(watched, "programs/main.task") + "\nopen\n")
    assert set(watched.ran()) == {"made", "code", "program", "checked", "compiled"}


def test_findings_of_an_edit_need_no_program() -> None:
    workspace = Workspace()
    workspace.watch()
    at = workspace.at(CELL, "c", "")
    for text in (PROGRAM.text, PROGRAM.text.replace("mov", "lin")):
        events = workspace.events
        assert events is not None
        events.clear()
        assert workspace.checked(SourceText("p.task", text), {"": at}).diagnostics == ()
        ran = {one.function for one in events if one.outcome is Outcome.RAN}
        assert {"made", "checked"} <= ran
        assert not ran & {"code", "program", "verified", "compiled"}
    assert workspace.compiled(SourceText("p.task", text), at).icr is not None


def test_what_the_cell_names_reaches_the_programs(watched: Watched) -> None:
    more = "\n[locations.elsewhere]\nposition = [300, 200, 50]\n"
    watched.opened(cell=text_of(watched, "cell.toml") + more)
    assert {"cell", "environment"} <= set(watched.ran())


def test_a_project_answers_for_its_own_texts_after_others_were_opened(watched: Watched) -> None:
    before = watched.opened()
    found = before.compile()
    after = watched.opened(main="program other\nmov nowhere\n")
    assert [one.code for one in after.compile().diagnostics] == ["N202"]
    assert before.compile() == found


def test_findings_code_and_names_of_a_text_come_from_one_compilation() -> None:
    workspace = Workspace()
    at = workspace.at(CELL, "c", "")
    workspace.watch()
    assert (
        workspace.compiled(PROGRAM, at).diagnostics == workspace.checked(PROGRAM, {"": at}).diagnostics == ()
    )
    assert workspace.code_id(PROGRAM, at)
    code = workspace.code(PROGRAM, at)
    assert code is not None
    (target,) = places_of(moves_by_line(code)[2].first[0], workspace.environment(at))
    assert target is not None
    assert target.X_BT.position.tolist() == pytest.approx([0.3, 0.2, 0.5])
    assert [one.function for one in workspace.events or []].count("translated") == 1


def test_a_text_that_is_forgotten_is_made_anew() -> None:
    workspace = Workspace()
    at = workspace.at(CELL, "c", "")
    found = workspace.compiled(PROGRAM, at)
    workspace.forget(PROGRAM.name)
    assert workspace.compiled(PROGRAM, at) == found


def test_a_project_on_the_disk_keeps_what_was_made_of_it(watched: Watched) -> None:
    workspace = Workspace()
    first = open_project(watched.folder, workspace)
    again = open_project(watched.folder, workspace)
    assert first == again
    assert first.cell is again.cell
    assert first.program().icr is again.program().icr


def test_an_edit_of_a_robot_file_reaches_the_cell(tmp_path: Path) -> None:
    new_project(tmp_path / "p")
    (tmp_path / "p" / "robots").mkdir()
    (tmp_path / "p" / "robots" / "arm.toml").write_text(PUMA560, "utf-8")
    cell = (tmp_path / "p" / "cell.toml").read_text("utf-8").replace('"puma560"', '"robots/arm.toml"')
    (tmp_path / "p" / "cell.toml").write_text(cell, "utf-8")
    watched = Watched(tmp_path / "p")
    assert not any(one.is_error for one in watched.opened().compile().diagnostics)
    narrower = PUMA560.replace("limits = [-160, 160]", "limits = [-150, 150]")
    changed = open_overlaid(watched.folder, {"robots/arm.toml": narrower}, watched.workspace)
    assert changed.cell is not None
    assert changed.cell.first.robot.axis_joints[0].upper == pytest.approx(radians(150.0))
    assert not any(one.is_error for one in watched.opened().compile().diagnostics)
    assert watched.ran() != []
    watched.opened()
    assert watched.ran() == []
