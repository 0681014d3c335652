"""`ropsim controller response`: tables, document, and refusals of a cell."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from ropsim.cli.testing import main
from ropsim.workbench import open_project

CELL = '[cell]\nname = "c"\n[robot]\nmodel = "{model}"\n{more}'
ONE_WAY = """\
import numpy as np

from ropsim.controller import LawTraits


class Law:
    traits = LawTraits()

    def step(self, now, state):
        factor = np.where(now.meas[1] < -1e-3, 100.0, 1.0)
        return factor * (900.0 * (now.ref[0] - now.meas[0]) + 90.0 * (now.ref[1] - now.meas[1]))


def joint_controller(robot, controller):
    return Law()
"""
PLACE = "[locations.place]\nposition = [450, 100, 300]\n"


@pytest.fixture
def cell(tmp_path: Path) -> Path:
    return written(tmp_path, "puma560", PLACE)


def written(folder: Path, model: str, more: str = "") -> Path:
    (folder / "cell.toml").write_text(CELL.format(model=model, more=more), "utf-8")
    return folder


def document(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, dict[str, Any]]:
    code = main(["controller", "response", *arguments, "--json"])
    found: dict[str, Any] = json.loads(capsys.readouterr().out)
    return code, found


def test_each_axis_makes_a_small_step_and_has_margins(cell: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["controller", "response", str(cell)]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "Unimation PUMA 560: computed torque at 1000 Hz, start of the cell, no load"
    assert [line.split()[0] for line in lines if line[:3] == "  1"] == ["1"] * 3  # a row in each table
    assert sum("0.5°" in line for line in lines) == 6


def test_a_step_a_ramp_and_a_sweep_are_told_in_si(cell: Path, capsys: pytest.CaptureFixture[str]) -> None:
    code, found = document(capsys, str(cell), "--axis", "3", "--step", "2deg")
    (axis,) = found["axes"]
    assert (code, found["ok"], axis["axis"], axis["stable"]) == (0, True, "3", True)
    assert axis["step"]["reference"] == pytest.approx([np.radians(2.0)] * len(axis["step"]["time"]))
    assert 0.0 < axis["step"]["rise"] < axis["step"]["settling"] < 0.3
    assert axis["margins"]["gain"] > 2.0
    _, found = document(capsys, str(cell), "--axis", "3", "--ramp", "-20deg/s")
    ramp = found["axes"][0]["ramp"]
    assert ramp["reference"][-1] == pytest.approx(np.radians(-20.0) * ramp["time"][-1])
    assert abs(ramp["behind"]) < np.radians(0.01)
    _, found = document(capsys, str(cell), "--axis", "3", "--sweep", "1..50Hz")
    sweep = found["axes"][0]["sweep"]
    assert (sweep["hz"][0], sweep["hz"][-1]) == (1.0, 50.0)
    assert sweep["gain"][0] == pytest.approx(1.0, abs=0.02)
    assert sweep["gain"][-1] < 0.5


def test_the_arm_rests_where_it_is_asked_to(cell: Path, capsys: pytest.CaptureFixture[str]) -> None:
    _, at = document(capsys, str(cell), "--axis", "1", "--at", "place")
    _, joints = document(capsys, str(cell), "--axis", "1", "--joints", *["10", "60", "-150", "0", "-60", "5"])
    assert np.degrees(joints["q"]) == pytest.approx([10, 60, -150, 0, -60, 5])
    project = open_project(cell)
    assert project.cell is not None
    start = project.cell.first.q_start
    assert np.abs(np.array(at["q"]) - start).max() > 0.1


@pytest.mark.parametrize(
    ("model", "arguments", "said"),
    [
        ("puma560", ["--axis", "7"], "`puma560` has no axis `7`"),
        ("puma560", ["--axis", "1", "--step", "2mm"], "`mm` for joint `1`, which turns, its unit is deg"),
        ("puma560", ["--station", "left"], "the cell has no station `left`"),
        ("puma560", ["--at", "plaec"], "the cell has no location `plaec`"),
        ("puma560", ["--joints", "1", "2"], "--joints has 2 numbers, the robot has 6 axes"),
        ("puma560", ["--axis", "1", "--step", "400deg"], "this step takes joint `1` beyond its range"),
        ("puma560", ["--axis", "1", "--ramp", "900deg/s"], "joint `1` is not as quick as this ramp"),
        ("puma560", ["--sweep", "1..501Hz"], "sines go up to half of the control rate, 500 Hz"),
        (
            "puma560",
            ["--joints", "0", "999", *"0000"],
            "--joints has joint `2` beyond its range",
        ),
        ("scara", ["--step", "2mm"], "`mm` for joint `1`, which turns, its unit is deg"),
    ],
)
def test_what_is_not_there_is_refused(
    model: str, arguments: list[str], said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = written(tmp_path, model, PLACE)
    assert main(["controller", "response", str(folder), *arguments]) == 2
    assert f"error[U905] controller-not-tested: {said}" in "".join(capsys.readouterr())


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--step", "0deg"], "`0deg` is no step: it is 0"),
        (["--step", "5deg/s"], "a step has no unit `deg/s`, it has one of deg, °, rad, mm, cm, m, or none"),
        (["--ramp", "20deg"], "a speed has no unit `deg`"),
        (["--ramp", "quick"], "`quick` is no speed: a number, with or without a unit: 5deg/s"),
        (["--sweep", "50..1Hz"], "it begins above 0 Hz and ends higher"),
        (["--sweep", "1..5mm"], "a frequency has no unit `mm`, it has one of Hz, kHz, rad/s, or none"),
        (["--joints", "0", "1kg"], "a coordinate has no unit `kg`"),
    ],
)
def test_a_quantity_that_is_none_is_wrong_usage(
    arguments: list[str], said: str, cell: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as caught:
        main(["controller", "response", str(cell), *arguments])
    assert caught.value.code == 2
    assert said in capsys.readouterr().err


def test_a_quantity_means_the_same_in_each_of_its_units(
    cell: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (_, degrees), (_, radians) = (
        document(capsys, str(cell), "--axis", "3", "--step", step, "--joints", *joints)
        for step, joints in (
            ("-2", ["0", "90", *"0000"]),
            (f"{np.radians(-2.0)}rad", ["0rad", "90deg", *"0000"]),
        )
    )
    assert degrees["q"] == radians["q"]
    assert degrees["axes"][0]["step"]["reference"] == pytest.approx(radians["axes"][0]["step"]["reference"])
    assert degrees["axes"][0]["step"]["reference"][-1] == pytest.approx(np.radians(-2.0))


def test_an_axis_is_worst_in_a_motion_that_is_named(cell: Path, capsys: pytest.CaptureFixture[str]) -> None:
    _, found = document(capsys, str(cell), "--axis", "2")
    (axis,) = found["axes"]
    assert axis["in_motion"]["motion"].split()[0] in {"all", "odd", "joint", "tool"}
    assert np.abs(axis["in_motion"]["qd"]).max() > 0.0
    assert axis["in_motion"]["margins"]["gain"] == pytest.approx(axis["margins"]["gain"], rel=0.02)


def test_a_loop_that_is_unstable_one_way_is_an_error(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """An own law whose gain is forty times as high where an axis goes back."""
    monkeypatch.setenv("ROPSIM_CONFIG_HOME", str(tmp_path / "config"))
    folder = tmp_path / "own"
    folder.mkdir()
    written(folder, "two_link", '[controller]\nfile = "mine.py"\n')
    (folder / "mine.py").write_text(ONE_WAY, "utf-8")
    assert main(["trust", str(folder)]) == 0
    capsys.readouterr()
    code, found = document(capsys, str(folder), "--axis", "1")
    (axis,) = found["axes"]
    assert (code, axis["stable"], axis["in_motion"]["stable"]) == (1, True, False)
    assert axis["in_motion"]["qd"][0] < 0.0


def test_an_unstable_loop_is_an_error(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    gains = ", ".join(["4000"] * 6)
    wild = written(tmp_path, "puma560", f"[controller]\nkp = [{gains}]\n")
    assert main(["controller", "response", str(wild), "--axis", "1"]) == 1
    assert "unstable" in "".join(capsys.readouterr())


def test_a_page_with_the_curves_is_written(cell: Path, capsys: pytest.CaptureFixture[str]) -> None:
    page = cell / "loops.html"
    arguments = ("--axis", "3", "--step", "2deg", "--sweep", "1..50Hz")
    with pytest.raises(SystemExit, match="2"):  # one excitation in time
        main(["controller", "response", str(cell), *arguments])
    code, found = document(capsys, str(cell), "--axis", "3", "--step", "2deg", "--report", str(page))
    assert (code, found["written"]) == (0, [str(page)])
    text = page.read_text("utf-8")
    assert text.count("<svg") == 2
    assert "overshoot<br>%" in text
    assert "Unimation PUMA 560" in text


def test_a_page_that_cannot_be_written_is_told(cell: Path, capsys: pytest.CaptureFixture[str]) -> None:
    before = (cell / "cell.toml").read_bytes()
    for place, word in ((cell, "is a folder"), (cell / "cell.toml", "is a text of the project")):
        assert main(["controller", "response", str(cell), "--axis", "3", "--report", str(place)]) == 2
        assert word in capsys.readouterr().err
    assert (cell / "cell.toml").read_bytes() == before
    (cell / "taken").write_text("")
    beneath = str(cell / "taken" / "loops.html")
    assert main(["controller", "response", str(cell), "--axis", "3", "--report", beneath]) == 2
    assert "taken" in capsys.readouterr().err


def test_what_sensors_do_is_in_the_answer_and_said(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    exact, late = tmp_path / "exact", tmp_path / "late"
    for folder, more in (
        (exact, ""),
        (late, "[controller.sensors]\ncoordinate = { bits = 18, delay = 0.002 }\n"),
    ):
        folder.mkdir()
        written(folder, "puma560", more)
    (_, one), (_, other) = (document(capsys, str(each), "--axis", "1") for each in (exact, late))
    assert (one["sensors"], other["sensors"]) == ([], ["coordinate"])
    assert other["axes"][0]["margins"]["phase"] < one["axes"][0]["margins"]["phase"]
    assert main(["controller", "response", str(late), "--axis", "1"]) == 0
    text = capsys.readouterr().out
    assert "responses: with the sensors of the cell for coordinate, their steps and noise" in text
    assert "of sensors with delays and rates, without steps and noise" in text
