"""`ropsim controller tune`: gains that a cell file takes, their margins, and refusals."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from ropsim import robots
from ropsim.cli.testing import main
from ropsim.model import ComputedTorqueGains, gain_names
from ropsim.workbench import open_project

CELL = '[cell]\nname = "c"\n[robot]\nmodel = "{model}"\n{more}'


def written(folder: Path, model: str, more: str = "") -> Path:
    (folder / "cell.toml").write_text(CELL.format(model=model, more=more), "utf-8")
    return folder


def document(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, dict[str, Any]]:
    code = main(["controller", "tune", *arguments, "--json"])
    found: dict[str, Any] = json.loads(capsys.readouterr().out)
    return code, found


def test_a_bandwidth_and_a_damping_make_gains(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    cell = written(tmp_path, "two_link")
    code, found = document(capsys, str(cell), "--bandwidth", "5Hz", "0.008kHz", "--damping", "0.7")
    assert (code, found["ok"], found["law"], found["damping"]) == (0, True, "computed_torque", 0.7)
    omega = 2.0 * np.pi * np.array([5.0, 8.0])
    assert found["gains"]["kp"] == pytest.approx(omega**2, rel=1e-3)
    assert found["gains"]["kd"] == pytest.approx(1.4 * omega, rel=1e-3)
    assert [one["bandwidth_hz"] for one in found["axes"]] == pytest.approx([5.0, 8.0])
    slow = [one["slowest_hz"] for one in found["places"] if one["motion"] == "at rest"]
    assert len(found["places"]) == 5 * len(slow)
    assert slow == pytest.approx([slow[0]] * len(slow), rel=1e-3)  # the law knows the arm
    assert all(one["worst"]["stable"] for one in found["axes"])
    for one in found["axes"]:
        assert one["at_rest"]["motion"] == "at rest"
        assert one["worst"]["margins"]["sensitivity"] >= one["at_rest"]["margins"]["sensitivity"]


def test_the_printed_lines_are_a_section_of_the_cell_file(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    cell = written(tmp_path, "two_link")
    assert main(["controller", "tune", str(cell), "--bandwidth", "6"]) == 0
    text = capsys.readouterr().out
    lines = text[text.index("[controller]") :].rstrip() + "\n"
    written(tmp_path, "two_link", lines)
    project = open_project(cell)
    assert not project.diagnostics
    assert project.cell
    gains = project.cell.first.controller.gains
    assert isinstance(gains, ComputedTorqueGains)
    assert gains.kp == pytest.approx((2.0 * np.pi * 6.0) ** 2, rel=1e-3)
    code, again = document(capsys, str(cell), "--bandwidth", "6")
    assert code == 0
    assert again["toml"] == lines
    assert "slowest oscillation in Hz over joint 2" in text


def test_loops_of_fixed_gains_get_theirs_and_the_largest_bandwidths_keep_margins(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    cell = written(tmp_path, "patu655", '[controller]\nlaw = "fixed gains"\n')
    code, found = document(capsys, str(cell))
    assert (code, found["law"]) == (0, "cascaded_p_pi")
    assert 'law = "fixed gains"' in found["toml"]
    assert "kd" not in found["toml"]
    worst = [one["worst"]["margins"] for one in found["axes"]]
    assert all(one["sensitivity"] <= 2.0 and (one["gain"] or 9.0) >= 2.0 for one in worst)
    assert min(one["slowest_hz"] for one in found["places"]) < max(
        one["slowest_hz"] for one in found["places"]
    )


@pytest.mark.parametrize("law", ["flow, load and damping", "parallel PI"])
def test_laws_of_hydraulic_axes_get_the_gains_of_their_rule_at_its_bandwidth(
    law: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    cell = written(tmp_path, "patu655", f'[controller]\nlaw = "{law}"\n')
    project = open_project(cell)
    assert project.cell
    rule = project.cell.first.controller
    hz = robots.loop_bandwidths(project.cell.first.robot, rule) / (2.0 * np.pi)
    code, found = document(capsys, str(cell), "--bandwidth", *(f"{one!r}Hz" for one in hz.tolist()))
    assert (code, found["damping"]) == (0, None)
    for name in gain_names(rule.gains):
        assert found["gains"][name] == pytest.approx(getattr(rule.gains, name), rel=1e-3)
    written(tmp_path, "patu655", found["toml"])
    again = open_project(cell)
    assert again.cell
    for name in gain_names(rule.gains):
        gains = again.cell.first.controller.gains
        assert getattr(gains, name) == pytest.approx(np.array(found["gains"][name]), rel=1e-12)


def test_loops_of_hydraulic_axes_have_no_damping_ratio(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    cell = written(tmp_path, "patu655")
    assert main(["controller", "tune", str(cell), "--damping", "0.7"]) == 2
    assert "no damping ratio" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ("5deg", "a frequency has no unit `deg`, it has one of Hz, kHz, rad/s, or none"),
        ("five", "`five` is no frequency: a number, with or without a unit: 5Hz"),
        ("nan", "`nan` is no frequency: it is no number"),
    ],
)
def test_a_bandwidth_is_a_frequency(given: str, said: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit, match="2"):
        main(["controller", "tune", ".", "--bandwidth", given])
    assert said in capsys.readouterr().err


def test_unstable_loops_are_told_and_end_with_1(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    cell = written(tmp_path, "two_link")
    assert main(["controller", "tune", str(cell), "--bandwidth", "250"]) == 1
    assert "unstable" in capsys.readouterr().out


def test_axes_beyond_their_margins_are_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    cell = written(tmp_path, "two_link")
    assert main(["controller", "tune", str(cell), "--bandwidth", "100"]) == 0
    text = capsys.readouterr().out
    assert "not within Ms 2 and a gain margin of 2 at the worst place: joint 1, joint 2" in text


@pytest.mark.parametrize(
    ("model", "arguments", "word"),
    [
        ("two_link", ("--bandwidth", "5", "6", "7"), "3 numbers"),
        ("two_link", ("--bandwidth", "251"), "up to 250 Hz"),
        ("two_link", ("--bandwidth", "0"), "above 0"),
        ("two_link", ("--station", "left"), "no station `left`"),
    ],
)
def test_what_cannot_be_tuned_is_refused(
    model: str, arguments: tuple[str, ...], word: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["controller", "tune", str(written(tmp_path, model)), *arguments]) == 2
    message = capsys.readouterr().err
    assert "U905" in message
    assert word in message


def test_a_damping_ratio_is_a_number(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit, match="2"):
        main(["controller", "tune", str(tmp_path), "--damping", "nan"])
    assert "no damping ratio" in capsys.readouterr().err


def test_a_station_of_several_has_its_own_section(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "cell.toml").write_text(
        '[cell]\nname = "c"\n[stations.left]\nrobot = "two_link"\n[stations.right]\nrobot = "two_link"\n'
        "base = { position = [3000, 0, 0] }\n",
        "utf-8",
    )
    code, found = document(capsys, str(tmp_path), "--station", "right", "--bandwidth", "5")
    assert code == 0
    assert found["toml"].startswith("[stations.right.controller]\n")
