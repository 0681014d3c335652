"""`ropsim check --watch`: it checks when a content has changed, and says what is new."""

import argparse
import json
import os
from collections.abc import Callable, Iterable
from pathlib import Path

import pytest

from ropsim.cli.terminal.watch import watch
from ropsim.cli.testing import SETTLED, Output, contents, main, stamps
from ropsim.cli.testing import watch as watching
from ropsim.workbench import Workspace

TEXT = Output(json=False, is_coloured=False)
WRONG = "wihle true\n  mov home\nendw\n"


@pytest.fixture
def project(tmp_path: Path) -> Path:
    assert main(["new", str(tmp_path / "cell")]) == 0
    return tmp_path / "cell"


def watched(path: Path, deeds: Iterable[Callable[[], object]], output: Output = TEXT) -> int:
    """Watch a path; before each look at the files one deed is done, after the last one Ctrl+C is pressed."""
    left = iter(deeds)

    def wait(_seconds: float) -> None:
        deed = next(left, None)
        if deed is None:
            raise KeyboardInterrupt
        deed()

    return watch(argparse.Namespace(path=str(path)), output, wait)


def appended(path: Path, text: str) -> Callable[[], object]:
    return lambda: path.write_text(path.read_text("utf-8") + text, encoding="utf-8")


def test_a_change_is_checked_and_its_findings_are_told_once(
    project: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    program = project / "programs" / "main.task"
    deeds = [
        appended(program, "mvo infeed\n"),
        lambda: program.write_text("\n" + program.read_text("utf-8"), encoding="utf-8"),
        appended(program, "lin infeed sped 3\n"),
    ]
    capsys.readouterr()
    assert watched(project, deeds) == 1
    said = capsys.readouterr()
    assert said.err.count("N201") == 1  # though its line has moved
    assert said.err.count("L101") == 1
    assert said.out.splitlines()[0] == "checked main: no errors"
    assert [line.split(": ")[1] for line in said.out.splitlines()[1:]] == ["1 error", "1 error", "2 errors"]


def test_the_code_is_that_of_the_last_check(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    program = project / "programs" / "main.task"
    right = program.read_text("utf-8")
    deeds = [appended(program, "mvo infeed\n"), lambda: program.write_text(right, encoding="utf-8")]
    assert watched(project, deeds) == 0
    assert capsys.readouterr().out.splitlines()[-1] == "checked main: no errors, 1 gone"


def test_what_has_the_same_content_is_not_checked(project: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    program = project / "programs" / "main.task"
    checks: list[str] = []
    right = watching._checked

    def counted(path: str, workspace: Workspace) -> watching.Checked:
        checks.append(path)
        return right(path, workspace)

    monkeypatch.setattr(watching, "_checked", counted)
    (project / "out").mkdir()
    deeds: list[Callable[[], object]] = [
        lambda: None,
        lambda: os.utime(program, (1, 1)),
        lambda: program.write_bytes(program.read_bytes()),
        lambda: (project / "out" / "report.html").write_text("x", encoding="utf-8"),
    ]
    assert watched(project, deeds) == 0
    assert len(checks) == 1
    assert watched(project, [appended(program, "# x\n")]) == 0
    assert len(checks) == 3


def test_a_project_that_is_away_for_a_moment_is_waited_for(
    project: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    cell = project / "cell.toml"
    text = cell.read_text("utf-8")
    assert watched(project, [cell.unlink, lambda: cell.write_text(text, encoding="utf-8")]) == 0
    assert "X843" in capsys.readouterr().err
    assert main(["check", "--watch", str(project / "gone")]) == 2  # from the start it is a wrong path


def test_each_check_is_a_document(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    capsys.readouterr()
    watched(
        project, [appended(project / "programs" / "main.task", WRONG)], Output(json=True, is_coloured=False)
    )
    first, second = capsys.readouterr().out.split("\n}\n{")
    assert json.loads(first + "}")["ok"] is True
    assert json.loads("{" + second)["ok"] is False


def test_files_are_read_again_only_where_time_and_size_may_deceive(tmp_path: Path) -> None:
    path = tmp_path / "a.task"
    path.write_bytes(b"one")
    time = path.stat().st_mtime_ns
    fresh = stamps(path, time, {})
    path.write_bytes(b"two")
    os.utime(path, ns=(time, time))
    assert contents(stamps(path, time, fresh)) != contents(fresh)  # of one moment and size
    settled = stamps(path, time + SETTLED + 1, {})
    path.write_bytes(b"six")
    os.utime(path, ns=(time, time))
    assert stamps(path, time + SETTLED + 1, settled) == settled


def test_a_pipe_among_the_files_of_a_project_is_not_waited_for(project: Path) -> None:
    pipe = project / "programs" / "pipe.task"
    os.mkfifo(pipe)
    assert stamps(project, 0, {})[pipe].digest == ""
