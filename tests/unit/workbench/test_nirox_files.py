"""NIROX files in cells and on the command line."""

from pathlib import Path

import numpy as np
import pytest

import ropsim
from ropsim import exchange, nirox, robots
from ropsim.cli.testing import main
from ropsim.core import SourceText
from ropsim.workbench import StepForm, find_robot, new_project, written_robot
from support.nirox_texts import TEXT, line_of


def test_a_run_with_the_puma_of_a_file_equals_that_of_the_built_in_one_bit_for_bit(tmp_path: Path) -> None:
    new_project(tmp_path / "plain", "first_cell")
    new_project(tmp_path / "filed", "first_cell")
    cell = tmp_path / "filed" / "cell.toml"
    cell.write_text(
        cell.read_text("utf-8").replace('model = "puma560"', 'model = "robots/puma.stp"'), "utf-8"
    )
    (tmp_path / "filed" / "robots").mkdir()
    text = exchange.write_nirox(robots.load("puma560")).text
    (tmp_path / "filed" / "robots" / "puma.stp").write_text(text, "utf-8")
    plain, filed = (ropsim.open(tmp_path / name).simulate() for name in ("plain", "filed"))
    assert filed.ok
    assert filed.channels.keys() == plain.channels.keys()
    for name in plain.channels:
        np.testing.assert_array_equal(filed.rows(name), plain.rows(name), err_msg=name)


def test_a_mistake_in_a_file_is_told_by_the_cell_with_its_line(tmp_path: Path) -> None:
    folder = tmp_path / "cell"
    (folder / "robots").mkdir(parents=True)
    (folder / "programs").mkdir()
    (folder / "programs" / "main.task").write_text("program main\nunits mm, deg, s\nmov home\n", "utf-8")
    (folder / "cell.toml").write_text('[robot]\nmodel = "robots/arm.stp"\n', "utf-8")
    (folder / "robots" / "arm.stp").write_text(TEXT.replace("#11,4.,", "#11,-4.,"), "utf-8")
    (found,) = [one for one in ropsim.open(folder).diagnostics if one.is_error]
    assert found.code == "X970"
    assert found.span is not None
    assert found.span.source.endswith("robots/arm.stp")
    assert found.span.line == line_of(110)


def test_what_a_file_says_beside_its_robot_goes_into_the_next_one(tmp_path: Path) -> None:
    path = tmp_path / "a.stp"
    path.write_text(TEXT.replace("#110=", "#300=FUTURE_THING(#11);\n#110="), "utf-8")
    named = find_robot(str(path))
    assert named.robot is not None
    assert "FUTURE_THING(#" in written_robot(named.robot, "b.stp", named.read).text
    assert "FUTURE_THING" not in written_robot(named.robot, "b.stp").text
    assert "convention" in written_robot(named.robot, "b.toml", named.read).text
    plain = written_robot(named.robot, "b.stp", named.read, StepForm.AP242)
    assert "FUTURE_THING" not in plain.text
    assert "`FUTURE_THING`" in plain.losses[-1].message


def test_the_command_line_writes_plain_ap242_and_nothing_with_strict(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    plain, strict, other = (str(tmp_path / name) for name in ("a.stp", "b.stp", "c.urdf"))
    assert main(["robot", "export", "stanford", plain, "--as", "ap242"]) == 0
    assert "FILE_SCHEMA(('AP242_" in Path(plain).read_text("utf-8")
    assert main(["robot", "export", "stanford", strict, "--as", "ap242", "--strict"]) == 1
    assert main(["robot", "export", "stanford", other, "--as", "ap242"]) == 2
    assert not Path(strict).exists()
    assert "X911" in capsys.readouterr().err


def test_the_command_line_shows_moves_and_imports_a_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("two.stp").write_text(TEXT, "utf-8")
    assert main(["robot", "show", "two.stp"]) == 0
    assert "NIROX class CC4: kinematics, masses, drives, cuts of closed chains\n" in capsys.readouterr().out
    assert main(["robot", "fk", "two.stp", "0", "90"]) == 0
    assert capsys.readouterr().out.startswith("x 500.000  y 300.000  z 0.000 mm")
    assert main(["robot", "import", "two.stp", "--to", "robots/two.stp"]) == 0
    text = Path("robots/two.stp").read_text("utf-8")
    assert (
        nirox.read_nirox(SourceText("a.stp", text)).robot
        == exchange.read_nirox(SourceText("a.stp", TEXT)).robot
    )
    assert main(["robot", "import", "two.stp", "--to", "two.xyz"]) == 2
