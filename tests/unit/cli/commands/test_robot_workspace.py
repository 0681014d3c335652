"""`ropsim robot workspace`: what it prints, writes and refuses."""

import json
import re
from pathlib import Path

import pytest

from ropsim.cli.testing import main

Printed = pytest.CaptureFixture[str]


def ask(*words: str) -> int:
    return main(["robot", "workspace", *words])


def test_points_that_are_missed_end_with_one_and_are_told_as_data(tmp_path: Path, capsys: Printed) -> None:
    points = tmp_path / "points.csv"
    points.write_text("name,x,y,z,roll,pitch,yaw\nnear,500,200,300,180,0,0\nfar,900,0,300,180,0,0\n", "utf-8")
    assert ask("scara", "--points", str(points), "--json") == 1
    found = json.loads(capsys.readouterr().out)
    assert found["ok"] is False
    assert [one["reached"] for one in found["ranking"][0]["points"]] == [True, False]
    assert found["ranking"][0]["points"][1]["distance"] == pytest.approx(0.3, abs=1e-3)
    assert found["robots"][0]["workspace"]["extremes"][0][1] == pytest.approx(0.6)


def test_the_report_is_one_page_with_the_section_and_the_points(tmp_path: Path, capsys: Printed) -> None:
    points, page = tmp_path / "points.csv", tmp_path / "reach.html"
    points.write_text("<b>,500,200,300,180,0,0\nlow,500,0,300\n", "utf-8")
    places = ("--base", "0", "0", "0", "--base", "50", "0", "0")
    assert ask("scara", "two_link", "--points", str(points), *places, "--report", str(page)) == 0
    text = page.read_text("utf-8")
    assert text.count("<svg") == 3  # two sections, and the task from above
    assert "&lt;b&gt;" in text
    assert "<b>" not in text
    assert not re.search(r"(?:src|href)=", text)
    assert "1. scara at 0 0 0 mm" in capsys.readouterr().out


def test_a_planar_arm_has_no_surface_and_nothing_is_written(tmp_path: Path, capsys: Printed) -> None:
    file = tmp_path / "border.stl"
    assert ask("two_link", "--surface", str(file)) == 1
    assert "W106" in capsys.readouterr().err
    assert not file.exists()


@pytest.mark.parametrize(
    ("words", "code", "told"),
    [
        (("scarra",), 2, "did you mean `scara`?"),
        (("scara", "--tool", "1", "2"), 2, "U904"),
        (("scara", "--base", "1", "2", "3", "4", "5"), 2, "U904"),
        (("scara", "--point", "wrist-centre"), 1, "W101"),
        (("scara", "--points", "nowhere.csv"), 1, "nowhere.csv"),
    ],
)
def test_what_cannot_be_asked_is_told(words: tuple[str, ...], code: int, told: str, capsys: Printed) -> None:
    assert ask(*words) == code
    assert told in capsys.readouterr().err


def test_a_frame_that_is_no_number_is_wrong_usage(capsys: Printed) -> None:
    with pytest.raises(SystemExit) as ended:
        ask("scara", "--base", "nan", "0", "0")
    assert ended.value.code == 2
    assert "nan" in capsys.readouterr().err
