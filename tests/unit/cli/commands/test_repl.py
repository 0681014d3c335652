"""`ropsim repl` from a pipe: what is answered, saved and refused; no mistake ends it."""

import io
import sys
from pathlib import Path

import pytest

from ropsim.cli.testing import LineEditor, main
from ropsim.workbench import words_for


@pytest.fixture
def project(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> Path:
    assert main(["new", str(tmp_path / "cell")]) == 0
    capsys.readouterr()
    return tmp_path / "cell"


def said(project: Path, text: str, monkeypatch: pytest.MonkeyPatch) -> int:
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(text.encode())))
    return main(["repl", str(project), "--kinematic"])


def test_commands_are_answered_with_pose_and_time(
    project: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    text = "wait 2 s\nprint 1 + 2\nrepeat 2\n  wait 1 s\nend\nundo\nlist\nquit\nwait 9 s\n"
    assert said(project, text, monkeypatch) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split("; ")[1] for line in lines if line.startswith("x ")] == [
        "0.000 s (+0.000 s)",
        "2.000 s (+2.000 s)",
        "2.000 s (+0.000 s)",
        "4.000 s (+2.000 s)",
        "2.000 s (-2.000 s)",
    ]
    assert [line for line in lines if not line.startswith("x ")] == [
        "says 3",
        "took back `repeat 2 …`",
        "wait 2 s",
        "print 1 + 2",
    ]


def test_no_mistake_ends_it(
    project: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    wrong = [
        "mvo a",
        "lin (9000, 0, 0)",
        "repeat 2",
        "",
        "é",
        "save main",
        "undo",
        "undo",
        "(" * 50,
        '"',
        "end",
        "\\",
    ]
    assert said(project, "\n".join([*wrong, "wait 1 s"]), monkeypatch) == 1
    printed = capsys.readouterr()
    assert printed.out.splitlines()[-1].endswith("; 1.000 s (+1.000 s)")
    for code in ("N201", "M501", "L106", "L102", "X847", "L107"):
        assert f"[{code}]" in printed.err


def test_commands_are_saved_as_a_task(project: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert said(project, "wait 1 s\nwait 2 s\nsave again\n", monkeypatch) == 0
    text = (project / "programs" / "again.task").read_text("utf-8")
    assert text.endswith("task again\n  wait 1 s\n  wait 2 s\nend\nagain\n")
    assert main(["fmt", "--check", str(project / "programs" / "again.task")]) == 0
    assert main(["run", str(project), "again", "--kinematic"]) == 0


def test_completion_offers_what_can_stand_there(project: Path) -> None:
    editor = LineEditor(
        lambda: "program p\ntask Grab(q: loc)\n  lin q\nend\n", project / "programs" / "x.task"
    )
    assert "Grab" in editor.offered("Gr")
    assert editor.offered("mov pick") == ("pick_up",)
    assert "speed" in editor.offered("lin pick_up spe")
    assert editor.offered('print "pi') == ()


def test_completion_offers_words_to_the_session_where_a_line_begins(
    project: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    editor = LineEditor(lambda: "program p\n", project / "programs" / "x.task")
    monkeypatch.setattr(sys, "stdin", io.StringIO("wait 1 s\nwait 2 s\n"))
    editor.line("> ", words_for)
    assert {"undo", "until"} <= set(editor.offered("un"))
    assert {"restart", "repeat"} <= set(editor.offered("re"))
    assert {"undo", "help", "mov"} <= set(editor.offered(""))
    assert "undo" not in editor.offered("mov ")
    editor.line(". ")
    assert "undo" not in editor.offered("un")


def test_a_session_can_begin_anew(
    project: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert said(project, "wait 2 s\nprint 1\nrestart\nlist\nwait 1 s\nlist\n", monkeypatch) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[4:] == [lines[0].replace("(+0.000", "(-2.000"), "no commands", lines[-2], "wait 1 s"]
    assert lines[-2].endswith("; 1.000 s (+1.000 s)")


def test_words_to_the_session_are_written_in_any_case(
    project: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert said(project, "print 1\nprint 2\nUndo\nLIST\nRestart\nlist\nQuit\nprint 3\n", monkeypatch) == 0
    lines = [line for line in capsys.readouterr().out.splitlines() if not line.startswith("x ")]
    assert lines == ["says 1", "says 2", "took back `print 2`", "print 1", "no commands"]


def test_a_program_without_a_name_is_not_saved(
    project: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert said(project, "print 1\nsave\n", monkeypatch) == 1
    assert "`save` has no name for the program" in capsys.readouterr().err


def test_words_to_the_session_take_nothing_more(
    project: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert said(project, "wait 1 s\nundo 2\nrestart now\nlist\n", monkeypatch) == 1
    printed = capsys.readouterr()
    assert printed.err.count("[X912]") == 2
    assert printed.out.splitlines()[-1] == "wait 1 s"


def test_words_to_the_session_that_are_misspelt_are_told(
    project: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    lines = "hlep\nudno\nSvae first\nmvo pick_up\nundo\n"
    assert said(project, lines, monkeypatch) == 1
    printed = capsys.readouterr()
    assert printed.out.splitlines()[1:] == ["there is no command to take back"]
    hints = [line.split("did you mean ")[1] for line in printed.err.splitlines() if "did you mean" in line]
    assert hints == ["`help`?", "`undo`?", "`save`?", "`mov`?"]


@pytest.mark.parametrize(
    "opener",
    [
        "try",
        "parallel",
        "on lamp",
        "repeat 2 3",
        "while",
        "for i",
        "if",
        "with speed",
        "task",
        "catch",
        "sync",
    ],
)
def test_a_refused_opener_opens_no_block(
    opener: str, project: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert said(project, f"{opener}\nwait 1 s\nquit\nwait 5 s\n", monkeypatch) == 1
    printed = capsys.readouterr()
    assert printed.out.splitlines()[1:] == [printed.out.splitlines()[0].replace("0.000 s (+0", "1.000 s (+1")]
    assert "error[" in printed.err
    assert "`quit`" not in printed.err


@pytest.mark.parametrize(
    "begun", ["repeat 2", "repeat 2\n  try", "lin (300,", "wait 1 s + \\", "task T\n  open"]
)
def test_quit_always_quits(
    begun: str, project: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert said(project, f"wait 1 s\n{begun}\nQuit\nwait 5 s\n", monkeypatch) == 1
    printed = capsys.readouterr()
    assert len(printed.out.splitlines()) == 2
    assert printed.err.count("error[") == 1
    assert f"`{begun.splitlines()[0]}` has no end, it is not carried out" in printed.err
