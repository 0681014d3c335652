"""`ropsim run` checks collisions: a penetration is an error on its line, too little clearance a warning."""

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from ropsim.cli.testing import main
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


def told(
    folder: Path, cell: str, expected: int, capsys: pytest.CaptureFixture[str]
) -> tuple[dict[str, Any], Path]:
    code, recording = ran(folder, cell, "--json", "--record", str(folder / "run.npz"))
    assert code == expected
    return json.loads(capsys.readouterr().out), recording


def looked_at_alone(
    folder: Path, recording: Path, span: tuple[float, float] = (0.0, np.inf), step: int = 5
) -> float:
    """Return the least distance of arm and post over recorded states, each checked alone [m]."""
    cell = open_project(folder).cell
    assert cell is not None
    alone, known = Collisions(cell), read_recording(recording)
    rows = (known.time >= span[0]) & (known.time <= span[1])
    moving = {f"link{k}" for k in range(1, 7)}
    least = np.inf
    for link in sorted(moving):
        absent = [one.name for one in alone.tree.bodies if one.name not in (link, "post")]
        for q in known.channels["q"].values[rows][::step]:
            least = min(least, alone.separation(q, absent=absent).distance)
    return float(least)


def test_a_penetration_is_an_error_on_its_line_with_bodies_and_depth(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    document, recording = told(tmp_path, IN_THE_WAY, 1, capsys)
    met = [one for one in document["diagnostics"] if one["code"] == "S751"]
    assert not document["ok"]
    assert {one["severity"] for one in met} == {"error"}
    assert {one["span"]["line"] for one in met} == {4}
    words = re.compile(r"collision link\d – post, \d+\.\d mm deep, line 4")
    assert all(words.fullmatch(one["message"]) for one in met)
    assert document["summary"]["error_count"] == len(met)
    assert document["result"]["verdict"]["kind"] == "failed"
    assert document["result"]["verdict"]["text"].startswith("failed: collision on line 4: link")
    contacts = document["summary"]["facts"]["ways"]["contacts"]
    deepest = min(contacts, key=lambda one: one["distance"])
    span = (deepest["time"] - 0.1, deepest["time"] + 0.1)
    assert deepest["distance"] == pytest.approx(looked_at_alone(tmp_path, recording, span, 1), abs=1e-4)
    assert deepest["distance"] <= looked_at_alone(tmp_path, recording) + 1e-4
    assert deepest["begin"] < deepest["time"] < deepest["end"]
    assert deepest["place"][:2] == pytest.approx([0.5, 0.0], abs=0.03)
    assert read_recording(recording).facts.ways is not None


def test_the_least_distance_is_that_of_a_scan_of_all_states(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    document, recording = told(tmp_path, BELOW, 0, capsys)
    ways = document["summary"]["facts"]["ways"]
    assert [one for one in document["diagnostics"] if one["code"] == "S751"] == []
    assert ways["clearance"]["distance"] == pytest.approx(looked_at_alone(tmp_path, recording), abs=1e-4)
    assert "post" in (ways["clearance"]["one"], ways["clearance"]["other"])
    assert ways["clearance"]["line"] in (3, 4)
    assert (ways["unseen"], ways["met"], ways["contacts"]) == ([], [], [])


def test_terminal_and_report_name_the_least_distance(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code, _ = ran(tmp_path, BELOW, "--report", str(tmp_path / "r.html"))
    text, page = capsys.readouterr().out, (tmp_path / "r.html").read_text()
    assert code == 0
    assert re.search(r"^nearest +[0-9.]+ mm: (link\d – post|post – link\d)$", text, re.M)
    assert "not checked: collisions" not in text
    assert "<h2>Collisions and clearance</h2>" in page


def test_terminal_and_report_of_a_collision_say_the_same(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code, _ = ran(tmp_path, IN_THE_WAY, "--report", str(tmp_path / "r.html"))
    said, page = capsys.readouterr(), (tmp_path / "r.html").read_text()
    assert code == 1
    words = re.search(
        r"failed: collision on line 4: (link\d – post, [0-9.]+ mm deep); \d errors?$", said.out, re.M
    )
    assert words
    assert f"collision {words[1]}, line 4" in said.err + said.out
    assert f"collision {words[1]}, line 4" in page


def test_with_no_collisions_the_verdict_says_that_they_are_not_checked(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code, _ = ran(tmp_path, IN_THE_WAY, "--no-collisions", "--report", str(tmp_path / "r.html"))
    text = capsys.readouterr()
    assert code == 0
    assert "S751" not in text.out + text.err
    assert "nearest" not in text.out
    assert "not checked: collisions" in text.out
    assert "<h2>Collisions and clearance</h2>" not in (tmp_path / "r.html").read_text()


def test_an_arm_alone_that_keeps_off_itself_is_checked_and_has_no_least_distance(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code, _ = ran(tmp_path, BELOW[: BELOW.index("[[objects]]")])
    text = capsys.readouterr().out
    assert code == 0
    assert "collision" not in text
    assert "nearest      no body with a known shape is beside the robot" in text


def test_too_little_clearance_is_a_warning_with_distance_and_requirement(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    document, recording = told(tmp_path, BELOW, 0, capsys)
    least = looked_at_alone(tmp_path, recording)
    required = BELOW.replace('name = "c"', f'name = "c"\nclearance = {1e3 * least + 5.0:.3f}')
    document, recording = told(tmp_path, required, 0, capsys)
    near = [one for one in document["diagnostics"] if one["code"] == "S770"]
    assert {one["severity"] for one in near} == {"warning"}
    nearest = min(near, key=lambda one: one["data"]["distance_m"])
    words = rf"([0-9.]+) mm of the required [0-9.]+ mm, line {nearest['span']['line']}"
    said = re.fullmatch(rf"clearance link\d – post, {words}", nearest["message"])
    assert said
    assert float(said[1]) == pytest.approx(1e3 * least, abs=0.051)
    assert document["result"]["verdict"]["kind"] == "doubtful"
    enough = BELOW.replace('name = "c"', f'name = "c"\nclearance = {1e3 * least - 0.1:.3f}')
    document, _ = told(tmp_path, enough, 0, capsys)
    assert [one["code"] for one in document["diagnostics"] if one["code"] == "S770"] == []


def test_interrupting_the_check_ends_the_command_as_it_ends_a_run(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("ropsim.collision.SolidBodies.on_ways", interrupted)
    code, recording = ran(tmp_path, BELOW, "--record", str(tmp_path / "run.npz"))
    assert code == 130
    assert not recording.exists()
    assert "interrupted" in capsys.readouterr().err
