"""Times of tasks from recorded runs."""

import os
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from ropsim import icr, language
from ropsim.flow import Recording, RunFacts, StationFacts, TaskEvent
from ropsim.lsp import Workshop
from ropsim.lsp.testing import MOST
from ropsim.records import write_recording
from ropsim.workbench import environment_of, new_project, open_project
from support.editors import Editor, uri_of

TEXT = "program main\nunits mm\ntask Go(q: loc)\n  mov q above 60\nendp\nGo pick_up\nGo set_down\n"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    folder = tmp_path / "cell"
    new_project(folder, "first_cell")
    (folder / "out").mkdir(exist_ok=True)
    return folder


def record(folder: Path, name: str, text: str, *durations: float) -> Path:
    """Write a recording of a run of a text in which a task took these times."""
    code = language.compile(text, environment_of(open_project(folder).cell)).icr
    assert code is not None
    station = StationFacts("robot", "main", "programs/main.task", icr.program_id(code))
    calls = [
        TaskEvent(float(k), one, "robot", name="Go", serial=k + 1, depth=1) for k, one in enumerate(durations)
    ]
    run = Recording(np.arange(3.0), {}, tuple(calls), (), 2.0, RunFacts(stations=(station,)))
    place = folder / "out" / name
    write_recording(run, place)
    return place


def lenses(folder: Path, text: str = TEXT, editor: Editor | None = None) -> list[tuple[int, str]]:
    editor = editor or Editor()
    uri = uri_of(folder / "programs" / "main.task")
    editor.open(uri, text)
    found: list[dict[str, Any]] = editor.ask("textDocument/codeLens", textDocument={"uri": uri})
    return [(one["range"]["start"]["line"] + 1, one["command"]["title"]) for one in found]


def test_a_task_has_the_times_of_its_calls(folder: Path) -> None:
    record(folder, "run.npz", TEXT, 1.25, 0.75)
    assert lenses(folder) == [(3, "0.75 to 1.25 s, 2 times, 2.00 s in the last recorded run")]


def test_one_call_has_one_time_wherever_the_header_stands_now(folder: Path) -> None:
    record(folder, "run.npz", TEXT, 1.25)
    assert lenses(folder, "# moved\n" + TEXT) == [(4, "1.25 s in the last recorded run")]


def test_of_another_program_nothing_is_told(folder: Path) -> None:
    record(folder, "run.npz", TEXT, 1.25)
    assert lenses(folder, TEXT.replace("60", "61")) == []
    assert lenses(folder, TEXT + "lin nobody\n") == []


def test_without_a_recording_nothing_is_compiled(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[str] = []
    monkeypatch.setattr(Workshop, "code_id", lambda *_: asked.append("code"))
    assert lenses(folder) == []
    assert asked == []


def test_a_recording_that_is_written_again_is_read_again(folder: Path) -> None:
    editor = Editor()
    record(folder, "run.npz", TEXT, 1.25)
    assert lenses(folder, TEXT, editor) == [(3, "1.25 s in the last recorded run")]
    record(folder, "run.npz", TEXT, 1.5, 1.5)
    assert lenses(folder, TEXT, editor) == [(3, "1.50 s, 2 times, 3.00 s in the last recorded run")]


def test_a_file_that_is_no_recording_tells_nothing(folder: Path) -> None:
    (folder / "out" / "run.npz").write_bytes(b"PK no")
    assert lenses(folder) == []


def test_of_recordings_that_are_gone_or_too_old_nothing_is_kept(folder: Path) -> None:
    editor = Editor()
    for number in range(2 * MOST):
        place = record(folder, f"run_{number}.npz", TEXT.replace("60", f"{number + 61}"), 1.25)
        os.utime(place, ns=(number * 10**9, number * 10**9))
        assert lenses(folder, TEXT, editor) == []
    assert sum(map(len, editor.workshop.recorded.kept.values())) == MOST
    for place in (folder / "out").glob("*.npz"):
        place.unlink()
    place = record(folder, "run.npz", TEXT, 1.25)
    assert lenses(folder, TEXT, editor) == [(3, "1.25 s in the last recorded run")]
    assert [stamp[0] for known in editor.workshop.recorded.kept.values() for stamp in known] == [place]
