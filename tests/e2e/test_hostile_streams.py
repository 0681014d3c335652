"""Outputs that fail: closed, full or abandoned streams, strange places for results, an interrupt."""

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from ropsim.workbench import new_project
from support.patience import PATIENCE
from support.usual_signals import usual_signals

pytestmark = pytest.mark.slow

FULL = Path("/dev/full")


@pytest.fixture
def project(tmp_path: Path) -> Path:
    """The first cell, with a program of one move."""
    folder = new_project(tmp_path / "cell")
    (folder / "programs" / "main.task").write_text("program p\nunits mm, deg\nmov pick_up above 60 mm\n")
    return folder


def command(*arguments: str | Path) -> list[str]:
    return [sys.executable, "-m", "ropsim", *map(str, arguments)]


def shell(line: str, *arguments: str | Path, **environment: str) -> subprocess.CompletedProcess[str]:
    """Run `line` in bash, with the command as "$@"."""
    found = subprocess.run(
        ["bash", "-o", "pipefail", "-c", line, "bash", *command(*arguments)],
        capture_output=True,
        text=True,
        timeout=PATIENCE,
        check=False,
        env={**os.environ, **environment},
    )
    assert "Traceback" not in found.stderr, found.stderr
    assert "bug in ropsim" not in found.stderr, found.stderr
    assert "Exception ignored" not in found.stderr, found.stderr
    return found


@pytest.mark.parametrize("reader", ["true", "head -1"])
def test_a_reader_that_goes_away_costs_neither_the_report_nor_the_exit_code(
    project: Path, tmp_path: Path, reader: str
) -> None:
    report = tmp_path / "r.html"
    found = shell(f'"$@" | {reader}', "run", project, "--kinematic", "--report", report)
    assert found.returncode == 0
    assert report.read_text().endswith("</html>\n")


def test_errors_keep_their_exit_code_when_nobody_reads_them(project: Path) -> None:
    (project / "programs" / "main.task").write_text("mvo pick_up\n")
    assert shell('"$@" 2>&1 | true', "check", project).returncode == 1


@pytest.mark.skipif(not FULL.is_char_device(), reason="this system has no /dev/full")
@pytest.mark.parametrize("form", [(), ("--json",)])
def test_a_full_disk_behind_standard_output_is_told(form: tuple[str, ...]) -> None:
    found = shell('"$@" > /dev/full', "examples", *form)
    assert found.returncode == 1
    assert "No space left" in found.stderr


@pytest.mark.parametrize("closed", [">&-", "2>&-", "<&- >&- 2>&-"])
def test_closed_streams_are_no_obstacle(project: Path, closed: str) -> None:
    assert shell(f'"$@" {closed}', "run", project, "--kinematic").returncode == 0


def test_an_old_locale_gets_the_report_in_its_own_characters(project: Path) -> None:
    found = shell('"$@"', "run", project, "--kinematic", PYTHONIOENCODING="ascii")
    assert found.returncode == 0
    assert "cycle time" in found.stdout


def test_results_go_through_links_and_into_pipes_without_replacing_them(
    project: Path, tmp_path: Path
) -> None:
    link, pipe = tmp_path / "latest.html", tmp_path / "pipe"
    link.symlink_to(tmp_path / "first.html")
    os.mkfifo(pipe)
    line = f'cat "{pipe}" > "{tmp_path}/run.npz" & "$@"; code=$?; wait; exit $code'
    found = shell(line, "run", project, "--kinematic", "--report", link, "--record", pipe)
    assert found.returncode == 0, found.stderr
    assert link.is_symlink()
    assert (tmp_path / "first.html").read_text().startswith("<!DOCTYPE html>")
    assert pipe.is_fifo()
    assert (tmp_path / "run.npz").read_bytes()[:2] == b"PK"


def test_a_result_that_cannot_be_written_still_leaves_one_document(project: Path, tmp_path: Path) -> None:
    found = shell('"$@"', "run", project, "--kinematic", "--json", "--report", tmp_path)
    assert found.returncode == 2
    assert [one["code"] for one in json.loads(found.stdout)["diagnostics"]] == ["X847"]


def test_an_interrupt_leaves_nothing_half_written(project: Path, tmp_path: Path) -> None:
    moves = "while true\n  mov pick_up above 60 mm\n  mov home\nendw\n"
    (project / "programs" / "main.task").write_text(f"units mm\n{moves}")
    out = tmp_path / "out"
    out.mkdir()
    results = ("--report", out / "r.html", "--record", out / "r.npz")
    with usual_signals():
        process = subprocess.Popen(
            command("run", project, "--kinematic", *results),
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
    with process:
        assert process.stderr is not None
        try:
            assert "simulating" in process.stderr.readline()  # the progress says that work is going on
            process.send_signal(signal.SIGINT)
            _, error = process.communicate(timeout=PATIENCE)
        finally:
            process.kill()
    assert process.returncode == 130, error
    assert error.splitlines()[-1] == "interrupted; nothing was left half-written"
    assert list(out.iterdir()) == []
