"""`ropsim generate`: what is typed becomes a program; every task is answered at once."""

import io
from pathlib import Path

import pytest

from ropsim.cli.testing import main

CELL = """\
[cell]
name = "small"
[units]
length = "mm"
angle = "deg"
[robot]
model = "puma560"
tool = "jaws"
[tools.jaws]
position = [0, 0, 145]
gripper = {}
[locations]
s1 = { position = [400, 100, -200], rpy = [180, 0, 0] }
[[parts]]
name = "bolt"
size = [20, 20, 20]
mass = 0.1
position = [400, 100, -200]
"""


def test_a_dialogue_makes_a_program_that_compiles(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "programs").mkdir()
    (tmp_path / "points").mkdir()
    (tmp_path / "cell.toml").write_text(CELL)
    (tmp_path / "points" / "table.csv").write_text("name,x,y,z\n,mm,mm,mm\na,400,0,100\n")
    typed = ["grip", "s1", "xyz", "grip", "s1", "undo", "move_over", "400 0 50", "", "pick", "s1", "x mm",
             "undo", "place", "table", "20 mm", "place", "table", "end"]  # fmt: skip
    monkeypatch.setattr("sys.stdin", io.StringIO("\n".join(typed)))
    assert main(["generate", str(tmp_path), "--name", "shift", "--write"]) == 0
    said = capsys.readouterr()
    assert "grip s1  accepted" in said.out
    assert "`grip` is not possible now" in said.out
    assert said.out.count("not checked: collisions") == 1
    assert "Task not defined: `xyz`" in said.err
    text = (tmp_path / "programs" / "shift.task").read_text()
    calls = [line for line in text.splitlines() if line.split(" ")[0] in ("grip", "move_over", "place")]
    assert calls == ["grip s1", "move_over point_1", "place point_2, 20 mm"]
    assert (tmp_path / "points" / "shift.csv").read_text().splitlines()[2:] == [
        "point_1,400,0,50,,", "point_2,400,0,100,,"]  # fmt: skip
    assert main(["check", str(tmp_path)]) == 0
    monkeypatch.setattr("sys.stdin", io.StringIO("grip\ns1\n"))
    assert main(["generate", str(tmp_path), "--name", "shift", "--write"]) == 2
    assert (tmp_path / "programs" / "shift.task").read_text() == text


def test_each_answer_is_judged_and_asked_again_and_a_task_can_be_left_out(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "cell.toml").write_text(CELL)
    typed = ["place", "s2", "s1", "-2 mm", "5 mm", "pick", "undo", "end"]
    monkeypatch.setattr("sys.stdin", io.StringIO("\n".join(typed)))
    assert main(["generate", str(tmp_path)]) == 1
    said = capsys.readouterr()
    assert "Location not defined: `s2`" in said.err
    assert "there is only `s1`" in said.err
    assert "at least 0 mm, given: -2 mm" in said.err
    assert said.out.count("TASK NAME: ") == 3
    assert "place s1, 5 mm  `place` is not possible now" in said.out
    assert "= `grip`, `pick` could provide it" in said.out
    assert "= `bolt` lies there: take it away first, or choose another location" in said.out


@pytest.mark.parametrize("name", ["load", "Repeat", "my pallet"])
def test_a_name_that_no_program_can_have_is_refused(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main(["generate", ".", "--name", name])
    assert f"`{name}` is" in capsys.readouterr().err


def test_a_task_is_shown_as_it_is_called(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["task", "show", str(tmp_path), "load_pallet"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == ("load_pallet(supply, first place, parts in a row, rows, distance, clearance = 50 mm)")
    part = next(line for line in lines if line.startswith("part "))
    assert part.endswith("first of all, told by the state of the cell (P)")


def test_a_check_has_as_much_time_as_it_is_given(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    names = [f"loop{k}(X) :- loop{k + 1}(X), loop{k + 1}(X).\n" for k in range(39)]
    task = "task(never(P), [params([P-part]), pre([loop0(P), none(P)])]). given(none/1)."
    (tmp_path / "a.pl").write_text(f"loop39(a).\n{''.join(names)}{task}")
    assert main(["task", "check", str(tmp_path), "never", "--seconds", "0.2"]) == 1
    said = capsys.readouterr().err
    assert "error[P157] check-stopped: `never` could not be checked within 0.2 s" in said
    assert "`--seconds` gives it more time" in said
