"""Paths that a user gives: devices, pipes and folders are refused at once by every command."""

import os
from pathlib import Path

import pytest

from ropsim.cli.testing import main
from ropsim.workbench import new_project

COMMANDS = {
    "calibrate": ("calibrate", "{project}", "{place}"),
    "check": ("check", "{place}.task"),
    "fmt": ("fmt", "{place}.task"),
    "icr": ("icr", "verify", "{place}.icr"),
    "inputs": ("run", "{project}", "--kinematic", "--inputs", "{place}.json"),
    "recorded inputs": ("run", "{project}", "--kinematic", "--inputs", "{place}.npz"),
    "robot": ("robot", "show", "{place}.toml"),
    "robot as URDF": ("robot", "show", "{place}.urdf"),
    "robot as NIROX": ("robot", "show", "{place}.stp"),
    "tasks": ("task", "list", "{place}.pl"),
}
"""By what is given, the words of a command."""


@pytest.fixture
def project(tmp_path: Path) -> Path:
    return new_project(tmp_path / "cell")


@pytest.mark.skipif(not Path("/dev/zero").exists(), reason="no devices as files")
@pytest.mark.parametrize(
    ("command", "kind"),
    [
        (command, kind)
        for command in COMMANDS
        for kind in ("device", "pipe", "folder")
        if (command, kind) != ("tasks", "folder")  # such a folder is a knowledge base
    ],
)
def test_what_is_no_ordinary_file_is_refused(
    project: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], command: str, kind: str
) -> None:
    words = [word.format(project=project, place=tmp_path / "given") for word in COMMANDS[command]]
    given = Path(words[-1])
    match kind:
        case "device":
            given.symlink_to("/dev/zero")
        case "pipe":
            os.mkfifo(given)
        case _:
            given.mkdir()
    assert main(words) in (1, 2)
    told = capsys.readouterr().err
    assert "error[" in told
    assert "bug in ropsim" not in told


@pytest.mark.skipif(not Path("/dev/zero").exists(), reason="no devices as files")
@pytest.mark.parametrize("place", ["cell.toml", "programs/main.task"])
def test_a_project_with_a_file_without_end_is_refused(
    project: Path, capsys: pytest.CaptureFixture[str], place: str
) -> None:
    (project / place).unlink()
    (project / place).symlink_to("/dev/zero")
    assert main(["check", str(project)]) in (1, 2)
    assert "bug in ropsim" not in capsys.readouterr().err
