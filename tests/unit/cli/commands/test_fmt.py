"""`ropsim fmt`: what it writes, and what it leaves alone."""

import io
import json
import sys
from pathlib import Path

import pytest

from ropsim.cli.testing import main

WRITTEN = "program p\nrepeat 2\nMOV  home\nend\n"
FORM = "program p\nrepeat 2\n  mov home\nend\n"


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "main.task"
    path.write_text(WRITTEN, encoding="utf-8")
    return path


def test_a_file_is_written_in_its_form(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["fmt", str(file)]) == 0
    assert file.read_text("utf-8") == FORM
    assert capsys.readouterr().out == f"formatted {file}\n"
    stamp = file.stat().st_ino
    assert main(["fmt", str(file)]) == 0
    assert (file.stat().st_ino, capsys.readouterr().out) == (stamp, "")  # not written again


@pytest.mark.parametrize("option", ["--check", "--diff"])
def test_looking_writes_nothing(option: str, file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["fmt", option, str(file)]) == (option == "--check")
    assert file.read_text("utf-8") == WRITTEN
    told = {"--check": f"not in its form: {file}\n", "--diff": "\n-MOV  home\n+  mov home\n"}
    assert told[option] in capsys.readouterr().out


def test_all_programs_of_a_project_are_written(tmp_path: Path) -> None:
    assert main(["new", str(tmp_path / "cell")]) == 0
    other = tmp_path / "cell" / "programs" / "other.task"
    other.write_bytes(b"\xef\xbb\xbf" + WRITTEN.encode())
    code = tmp_path / "cell" / "programs" / "code.icr"
    code.write_text("ICR  1.0 x\n", encoding="utf-8")
    assert main(["fmt", str(tmp_path / "cell"), "--check"]) == 1
    assert main(["fmt", str(tmp_path / "cell" / "cell.toml")]) == 0
    assert main(["fmt", str(tmp_path / "cell"), "--check"]) == 0
    assert other.read_bytes() == b"\xef\xbb\xbf" + FORM.encode()
    assert code.read_text("utf-8") == "ICR  1.0 x\n"


def test_standard_input_goes_to_standard_output(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(WRITTEN.encode())))
    assert main(["fmt", "-"]) == 0
    assert capsys.readouterr().out == FORM
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(WRITTEN.encode())))
    assert main(["fmt", "-", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["text"] == FORM


def test_nothing_on_standard_input_gives_nothing(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(b"")))
    assert main(["fmt", "-"]) == 0
    assert capsys.readouterr().out == ""


@pytest.mark.parametrize(
    ("name", "content", "code", "finding"),
    [
        ("main.icr", b"ICR 1.0 x\n", 2, "U902"),
        ("gone.task", None, 2, "X840"),
        ("bytes.task", b"mov \xff\n", 1, "X841"),
    ],
)
def test_what_is_no_task_program_is_told(
    name: str,
    content: bytes | None,
    code: int,
    finding: str,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    path = tmp_path / name
    if content is not None:
        path.write_bytes(content)
    assert main(["fmt", str(path)]) == code
    assert finding in capsys.readouterr().err
    assert content is None or path.read_bytes() == content
