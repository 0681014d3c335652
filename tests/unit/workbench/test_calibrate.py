"""`ropsim calibrate`: a trace file in, limits in the cell file out."""

import json
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from ropsim.calibration import MotionSettings, settings_of
from ropsim.cli.testing import main
from ropsim.model import LookAhead
from ropsim.workbench import open_project
from support.logged_traces import CELL, logged, site, table

PROGRAM = """\
program main
units mm, deg, s
mov (500, -200, 300; down)
wait 0.2
lin (500, 0, 300; down)
mov (350, 300, 500; down)
"""
SHARES = (1.0, 0.7, 1.3)


@cache
def text() -> str:
    made = site(PROGRAM)
    known, shares = settings_of(made.station), np.array(SHARES)[:, None]
    return table(logged(made, MotionSettings(known.joints * shares, known.tool * shares, LookAhead())), ";")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "p" / "programs").mkdir(parents=True)
    (tmp_path / "p" / "cell.toml").write_text(CELL)
    (tmp_path / "p" / "programs" / "main.task").write_text(PROGRAM)
    (tmp_path / "trace.csv").write_text(text())
    return tmp_path


def called(folder: Path, *more: str) -> int:
    return main(["calibrate", str(folder / "p"), str(folder / "trace.csv"), *more])


def test_times_and_limits_are_told_and_nothing_is_written(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert called(folder) == 0
    out = capsys.readouterr().out
    assert "line 5" in out
    assert "all 3 motions compared" in out
    assert "[controller]\njoint_acceleration = [" in out
    assert (folder / "p" / "cell.toml").read_text() == CELL


def test_written_limits_are_those_of_the_robot(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    before = open_project(folder / "p").cell
    assert called(folder, "--write", "--json") == 0
    told = json.loads(capsys.readouterr().out)
    cell = open_project(folder / "p").cell
    assert before is not None
    assert cell is not None
    old, new = settings_of(before.first), settings_of(cell.first)
    assert new.tool[:, 0] == pytest.approx(old.tool[:, 0] * SHARES, rel=0.02)
    assert told["written"] == [str(folder / "p" / "cell.toml")]
    assert told["calibration"]["limits"]["joint 1"]["acceleration"]["known"] == "fitted"
    assert new.joints[1, 0] == pytest.approx(0.7 * old.joints[1, 0], rel=0.02)
    kept = [line for line in CELL.splitlines() if "path_" not in line]
    written = (folder / "p" / "cell.toml").read_text().splitlines()
    assert [line for line in kept if line not in written] == []


def test_where_a_motion_was_held_nothing_is_written_and_the_motion_is_named(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    title, *rows = text().splitlines()
    third = len(rows) * 3 // 4  # on the way of the last motion
    later = [f"{float(time.replace(',', '.')) + 0.5:.4f};{rest}" for time, _, rest in _cut(rows[third:])]
    stood = [f"{k / 125.0 + _time(rows[third]):.4f};{rows[third].split(';', 1)[1]}" for k in range(1, 62)]
    lines = [title, *rows[: third + 1], *(line.replace(".", ",") for line in (*stood, *later[1:]))]
    (folder / "trace.csv").write_text("\n".join(lines) + "\n")
    assert called(folder, "--write") == 1
    said = capsys.readouterr()
    assert "error[X894]" in said.err
    assert "not compared: line 6 pass 1 stands on its way in the trace" in said.out
    assert "2 of 3 motions compared" in said.out
    assert "nothing is written" in said.out
    assert (folder / "p" / "cell.toml").read_text() == CELL


def _time(row: str) -> float:
    return float(row.split(";", 1)[0].replace(",", "."))


def _cut(rows: list[str]) -> list[tuple[str, str, str]]:
    return [row.partition(";") for row in rows]


def test_a_second_calibration_has_nothing_to_write(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert called(folder, "--write") == 0
    capsys.readouterr()
    assert called(folder, "--json") == 0
    told = json.loads(capsys.readouterr().out)["calibration"]
    assert abs(told["time"]["before"] / told["time"]["logged"] - 1.0) < 0.005


@pytest.mark.parametrize(
    ("content", "code"),
    [
        ("", "X888"),
        ("time,j1\n0,1\n", "X888"),
        ("\n".join(f"{k / 100},0,0,0,0,0,0" for k in range(99)), "X889"),
    ],
)
def test_a_trace_that_cannot_be_used_is_a_finding(
    folder: Path, capsys: pytest.CaptureFixture[str], content: str, code: str
) -> None:
    (folder / "trace.csv").write_text(content)
    assert called(folder, "--write") == 1
    assert f"error[{code}]" in capsys.readouterr().err
    assert (folder / "p" / "cell.toml").read_text() == CELL


def test_a_trace_that_is_not_there_is_wrong_usage(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "trace.csv").unlink()
    assert called(folder) == 2
    assert "error[X840]" in capsys.readouterr().err


def test_a_section_in_one_line_is_left_and_the_lines_are_told(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    lines = [line for line in CELL.splitlines() if not line.startswith(("[controller]", "path_"))]
    short = (
        "\n".join(["controller = { path_speed = 600, path_acceleration = 2000, path_jerk = 20000 }", *lines])
        + "\n"
    )
    (folder / "p" / "cell.toml").write_text(short)
    assert called(folder, "--write") == 0
    assert "put this into cell.toml" in capsys.readouterr().out
    assert (folder / "p" / "cell.toml").read_text() == short
