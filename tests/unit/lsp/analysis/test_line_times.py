"""What a recorded run tells of the lines of its program: in hints, under the pointer, with its joints."""

from math import pi
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from ropsim import icr, language
from ropsim.core import Span
from ropsim.flow import (
    AxisFacts,
    Channel,
    CriticalLimit,
    Fidelity,
    LimitQuantity,
    MoveEvent,
    Origin,
    Recording,
    RunContent,
    RunFacts,
    StationFacts,
    WaitEvent,
)
from ropsim.records import read_recording, write_recording
from ropsim.simulation import RunOptions
from ropsim.workbench import environment_of, new_project, open_project
from support.editors import Editor, place, uri_of

TEXT = """program main
units mm, s
task Go(q: loc)
  mov q above 60
  wait 0.5
endp
Go pick_up
Go set_down
"""
LIMITS = AxisFacts("1", lower=-pi, upper=pi), AxisFacts("2", lower=-1.0, upper=1.0)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    folder = new_project(tmp_path / "cell", "first_cell")
    (folder / "out").mkdir(exist_ok=True)
    return folder


def record(folder: Path, text: str = TEXT) -> None:
    """Write a recording in which the move took 1.2 s and 0.8 s, and joint 2 came near its lower limit."""
    cell = open_project(folder).cell
    code = language.compile(text, environment_of(cell)).icr
    assert code is not None
    assert cell is not None
    station = StationFacts("robot", "main", "main.task", icr.program_id(code), axes=LIMITS)
    limit = CriticalLimit("2", LimitQuantity.SPEED, 0.6)
    spans = [Origin(Span.whole_line("main.task", line), visit) for visit in (1, 2) for line in (4, 5)]
    events = (
        MoveEvent(0.0, 1.2, "robot", spans[0], motion="PTP", ordinal=0, settle=0.1, critical=limit),
        WaitEvent(1.2, 0.5, "robot", spans[1], pause=0.5),
        MoveEvent(1.7, 0.8, "robot", spans[2], motion="PTP", ordinal=1, settle=0.1, critical=limit),
        WaitEvent(2.5, 0.5, "robot", spans[3], pause=0.5),
        WaitEvent(2.5, 9.9, "another", spans[3], pause=9.9),
    )
    q = np.array([[0.0, 0.0], [0.0, -0.9], [pi / 2.0, 0.0], [0.0, -0.999]])
    line = np.array([0.0, 4.0, 4.0, 5.0])
    channels = {"q": Channel(q, "rad", ("1", "2")), "line": Channel(line, "")}
    content = RunContent(cell.content, {"robot": icr.code_lines(code)})
    facts = RunFacts(stations=(station,))
    run = Recording(np.arange(4.0), channels, events, (), 3.0, facts, content=content)
    write_recording(run, folder / "out" / "run.npz")


def hints(folder: Path, text: str = TEXT) -> list[tuple[int, str]]:
    editor, uri = Editor(), uri_of(folder / "programs" / "main.task")
    editor.open(uri, text)
    span = {"start": place(0, 0), "end": place(99, 0)}
    found: list[dict[str, Any]] = editor.ask("textDocument/inlayHint", textDocument={"uri": uri}, range=span)
    lines = text.split("\n")
    for one in found:
        assert one["position"]["character"] == len(lines[one["position"]["line"]])
    return [(one["position"]["line"] + 1, one["label"]) for one in found]


def hover(folder: Path, marked: str) -> str:
    uri = uri_of(folder / "programs" / "main.task")
    value: str = Editor().at_mark("hover", uri, marked)["contents"]["value"]
    return value.rsplit("\n\n", maxsplit=1)[-1]


def test_a_line_shows_its_time_and_a_joint_that_is_near_to_its_limit(folder: Path) -> None:
    record(folder)
    near = 0.1 * 180.0 / pi
    assert hints(folder) == [(4, f"0.80 to 1.20 s x 2, joint 2: {near:.1f}° left"), (5, "0.50 s x 2")]


def test_a_line_under_the_pointer_tells_what_sets_its_time(folder: Path) -> None:
    record(folder)
    assert hover(folder, TEXT.replace("  mov", "  m|ov")) == (
        "took 0.80 to 1.20 s, 2 times, 2.00 s in the last recorded run; 0.20 s of it settling; "
        "its time is set by the speed of joint 2; joint 2 comes within 5.7° of its lower limit"
    )
    assert hover(folder, TEXT.replace("wait", "wa|it")).startswith("took 0.50 s, 2 times, 1.00 s in the last")
    assert "took" not in hover(folder, TEXT.replace("Go pick_up", "G|o pick_up"))


def test_lines_that_have_moved_keep_their_times(folder: Path) -> None:
    record(folder)
    moved = TEXT.replace("task", "# one\n\ntask", 1).replace("  wait", "  # two\n  wait")
    assert [line for line, _ in hints(folder, moved)] == [6, 8]


def test_of_another_program_nothing_is_told(folder: Path) -> None:
    record(folder)
    assert hints(folder, TEXT.replace("60", "61")) == []
    assert "took" not in hover(folder, TEXT.replace("0.5", "0.6").replace("  mov", "  m|ov"))


def test_times_of_another_cell_are_marked(folder: Path) -> None:
    record(folder)
    cell = folder / "cell.toml"
    cell.write_text(cell.read_text("utf-8") + "\n# a remark\n", "utf-8")
    assert hints(folder)[1] == (5, "0.50 s x 2")
    cell.write_text(cell.read_text("utf-8") + "\n[signals.new]\ninput = 9\n", "utf-8")
    assert hints(folder)[1] == (5, "0.50 s x 2 (before the cell changed)")
    assert "last recorded run, before the cell changed" in hover(folder, TEXT.replace("wait", "wa|it"))


def test_a_run_says_of_what_it_was_made(folder: Path) -> None:
    project = open_project(folder)
    (folder / "programs" / "main.task").write_text(TEXT.replace("Go set_down\n", ""), "utf-8")
    project = open_project(folder)
    run = project.simulate(options=RunOptions(fidelity=Fidelity.KINEMATIC))
    assert project.cell is not None
    assert run.content.cell == project.cell.content
    write_recording(run, folder / "out" / "run.npz")
    assert read_recording(folder / "out" / "run.npz").content == run.content
    (move,) = run.events_of(MoveEvent)
    shown = hints(folder, TEXT.replace("Go set_down\n", "").replace("task", "# moved\ntask", 1))
    assert [(line, label.split(",")[0]) for line, label in shown] == [
        (5, f"{move.duration:.2f} s"), (6, "0.50 s"),
    ]  # fmt: skip
