"""`ropsim run --collisions`: what met on the ways is a finding on its line, what came near a distance."""

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from ropsim.cli.main import main
from ropsim.collision import Collisions
from ropsim.records import read_recording
from ropsim.workbench import open_project

CELL = """\
[cell]
name = "c"
[robot]
model = "puma560"
[[objects]]
name = "post"
position = [500, 0, {z}]
shapes = [{{ box = [40, 40, 400] }}]
"""
PROGRAM = """\
program c
units mm, deg, s
mov (500, -200, 300)
lin (500, 200, 300) speed 200 mm/s
"""
IN_THE_WAY, BELOW = CELL.format(z=120), CELL.format(z=20)
NEAR = 1e-7
"""Between the recorded states the arm may be a little nearer, and a distance is as fine as that [m]."""


def ran(folder: Path, cell: str, *options: str) -> tuple[int, Path]:
    (folder / "programs").mkdir(parents=True, exist_ok=True)
    (folder / "cell.toml").write_text(cell)
    (folder / "programs" / "main.task").write_text(PROGRAM)
    return main(["run", str(folder), "--kinematic", *options]), folder / "run.npz"


def told(folder: Path, cell: str, capsys: pytest.CaptureFixture[str]) -> tuple[dict[str, Any], Path]:
    code, recording = ran(folder, cell, "--collisions", "--json", "--record", str(folder / "run.npz"))
    assert code == 0
    return json.loads(capsys.readouterr().out), recording


def looked_at_alone(folder: Path, recording: Path) -> float:
    """Return the least distance of arm and post over all recorded states, each looked at by itself [m]."""
    cell = open_project(folder).cell
    assert cell is not None
    alone = Collisions(cell)
    moving = {f"link{k}" for k in range(1, 7)}
    least = np.inf
    for link in sorted(moving):
        absent = [one.name for one in alone.tree.bodies if one.name not in (link, "post")]
        for q in read_recording(recording).channels["q"].values[::5]:
            least = min(least, alone.separation(q, absent=absent).distance)
    return float(least)


def test_what_is_in_the_way_is_a_warning_on_the_line_with_bodies_and_depth(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    document, recording = told(tmp_path, IN_THE_WAY, capsys)
    met = [one for one in document["diagnostics"] if one["code"] == "S751"]
    assert met
    assert {one["severity"] for one in met} == {"warning"}
    assert all(one["data"]["other"] == "post" or one["data"]["one"] == "post" for one in met)
    assert 4 in {one["span"]["line"] for one in met}
    assert document["summary"]["warning_count"] >= len(met)
    deepest = max(one["data"]["depth"] for one in met)
    assert deepest == pytest.approx(-looked_at_alone(tmp_path, recording), rel=0.25)


def test_what_came_near_is_told_with_the_distance_that_a_scan_of_all_states_finds(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    document, recording = told(tmp_path, BELOW, capsys)
    ways = document["summary"]["facts"]["ways"]
    assert [one for one in document["diagnostics"] if one["code"] == "S751"] == []
    assert ways["clearance"]["distance"] == pytest.approx(looked_at_alone(tmp_path, recording), abs=1e-4)
    assert "post" in (ways["clearance"]["one"], ways["clearance"]["other"])
    assert ways["clearance"]["line"] in (3, 4)
    assert (ways["unseen"], ways["met"]) == ([], [])
    assert read_recording(recording).facts.ways is not None


def test_terminal_and_report_say_how_near_and_no_longer_that_nobody_looked(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code, _ = ran(tmp_path, BELOW, "--collisions", "--report", str(tmp_path / "r.html"))
    text, page = capsys.readouterr().out, (tmp_path / "r.html").read_text()
    assert code == 0
    assert re.search(
        r"^nearest +[0-9.]+ mm: link\d and post$|^nearest +[0-9.]+ mm: post and link\d$", text, re.M
    )
    assert "not checked: collisions" not in text
    assert "<h2>Ways</h2>" in page


def test_without_the_option_nobody_has_looked(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    code, _ = ran(tmp_path, IN_THE_WAY, "--report", str(tmp_path / "r.html"))
    text = capsys.readouterr()
    assert code == 0
    assert "S751" not in text.out + text.err
    assert "nearest" not in text.out
    assert "not checked: collisions" in text.out
    assert "<h2>Ways</h2>" not in (tmp_path / "r.html").read_text()


def test_interrupting_the_look_ends_the_command_as_it_ends_a_run(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("ropsim.collision.SolidBodies.on_ways", interrupted)
    code, recording = ran(tmp_path, BELOW, "--collisions", "--record", str(tmp_path / "run.npz"))
    assert code == 130
    assert not recording.exists()
    assert "interrupted" in capsys.readouterr().err
