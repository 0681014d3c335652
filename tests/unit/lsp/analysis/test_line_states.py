"""Whether what was recorded of a line is its result still: told to editors that show it."""

from pathlib import Path
from typing import Any

import pytest

from ropsim.flow import Fidelity, MoveEvent, Recording
from ropsim.lsp import mark
from ropsim.records import write_recording
from ropsim.simulation import RunOptions
from ropsim.workbench import new_project, open_project
from support.editors import Editor, place, uri_of

TEXT = """program main
units mm, s
mov pick_up above 60
lin pick_up
wait 0.5
mov set_down above 60
"""
SHOWS = {"experimental": {"ropsimLineStates": True}}
SHOWN = {"start": place(0, 0), "end": place(99, 0)}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    folder = new_project(tmp_path / "cell", "first_cell")
    (folder / "out").mkdir(exist_ok=True)
    return folder


def record(folder: Path, text: str = TEXT) -> Recording:
    (folder / "programs" / "main.task").write_text(text, "utf-8")
    run = open_project(folder).simulate(options=RunOptions(fidelity=Fidelity.KINEMATIC))
    write_recording(run, folder / "out" / "run.npz")
    return run


def told(editor: Editor) -> list[dict[str, Any]]:
    """Return what is told of the lines of documents that have changed."""
    editor.settle()
    messages: list[dict[str, Any]] = []
    while editor.state.unmarked:
        editor.state, said = mark(editor.state, editor.workshop)
        assert all(one["method"] == "ropsim/lineStates" for one in said)
        messages += [one["params"] for one in said if isinstance(one["params"], dict)]
    return messages


def states(folder: Path, *texts: str) -> list[dict[int, str]]:
    """Type texts one after the other and return what is told of each, by line from 1."""
    editor, uri = Editor(capabilities=SHOWS), uri_of(folder / "programs" / "main.task")
    found = []
    for text in texts:
        editor.tell("textDocument/didOpen", textDocument={"uri": uri, "text": text, "version": 3})
        (one,) = told(editor)
        assert (one["uri"], one["version"]) == (uri, 3)
        found.append({line["line"] + 1: line["state"] for line in one["lines"]})
    return found


def test_comments_leave_every_result_valid(folder: Path) -> None:
    record(folder)
    assert states(folder, TEXT, TEXT.replace("wait", "# a remark\nwait")) == [
        dict.fromkeys((3, 4, 5, 6), "valid"),
        dict.fromkeys((3, 4, 6, 7), "valid"),
    ]


def test_a_changed_target_makes_stale_what_comes_behind_the_stop_before(folder: Path) -> None:
    record(folder)
    assert states(folder, TEXT.replace("set_down above 60", "set_down above 61")) == [
        {3: "valid", 4: "valid", 5: "valid", 6: "stale"}
    ]
    assert states(folder, TEXT.replace("wait 0.5", "wait 0.7")) == [
        {3: "valid", 4: "valid", 5: "stale", 6: "stale"}
    ]


def test_a_text_with_errors_has_no_valid_line(folder: Path) -> None:
    record(folder)
    whole, broken = states(folder, TEXT, TEXT.replace("wait 0.5", "wait"))
    assert set(whole.values()) == {"valid"}
    assert broken == {3: "stale", 4: "stale", 6: "stale"}


def test_a_cell_that_means_something_else_makes_everything_stale(folder: Path) -> None:
    record(folder)
    cell = folder / "cell.toml"
    cell.write_text(cell.read_text("utf-8") + "\n# a remark\n", "utf-8")
    assert set(states(folder, TEXT)[0].values()) == {"valid"}
    cell.write_text(cell.read_text("utf-8") + "\n[signals.new]\ninput = 9\n", "utf-8")
    assert set(states(folder, TEXT)[0].values()) == {"stale"}


def test_of_a_program_that_never_ran_nothing_is_recorded(folder: Path) -> None:
    assert states(folder, TEXT) == [dict.fromkeys((3, 4, 5, 6), "none")]


def test_keys_are_those_of_the_recording(folder: Path) -> None:
    run = record(folder)
    editor, uri = Editor(capabilities=SHOWS), uri_of(folder / "programs" / "main.task")
    editor.tell("textDocument/didOpen", textDocument={"uri": uri, "text": TEXT, "version": 1})
    (one,) = told(editor)
    assert {line["line"] + 1: line["content"] for line in one["lines"]} == run.content.results["robot"]


def test_an_editor_that_does_not_show_it_is_not_told(folder: Path) -> None:
    editor, uri = Editor(), uri_of(folder / "programs" / "main.task")
    editor.open(uri, TEXT)
    assert not editor.state.unmarked


def test_lines_that_are_valid_keep_their_times_behind_an_edit(folder: Path) -> None:
    run = record(folder)
    editor, uri = Editor(), uri_of(folder / "programs" / "main.task")
    editor.open(uri, "# moved\n" + TEXT.replace("wait 0.5", "wait 0.7"))
    found = editor.ask("textDocument/inlayHint", textDocument={"uri": uri}, range=SHOWN)
    first, second, _ = (move.duration for move in run.events_of(MoveEvent))
    assert [(one["position"]["line"], one["label"].split(",")[0]) for one in found] == [
        (3, f"{first:.2f} s"),
        (4, f"{second:.2f} s"),
    ]
    assert "whose program was the same up to here" in found[0]["tooltip"]
