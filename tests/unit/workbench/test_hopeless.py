"""Moves that no time law can make are told at once, on their line, and the others go on."""

from pathlib import Path

import pytest

from ropsim.controller import joint_fit
from ropsim.flow import MoveEvent, Recording
from ropsim.simulation import Fidelity, RunOptions
from ropsim.workbench import open_project

CELL = '[cell]\nname = "c"\n[robot]\nmodel = "puma560"\n'


def ran(folder: Path, program: str, cell: str = CELL) -> Recording:
    (folder / "programs").mkdir()
    (folder / "cell.toml").write_text(cell, "utf-8")
    (folder / "programs" / "main.task").write_text(f"program p\nunits mm, deg, s\n{program}", "utf-8")
    return open_project(folder).simulate(options=RunOptions(Fidelity.KINEMATIC))


@pytest.mark.filterwarnings("error")
def test_a_curve_that_turns_back_in_a_point_is_refused_on_its_line(tmp_path: Path) -> None:
    points = (
        "(500, 200, 599.927421; rpy 180 0 -22.559461)",
        "(500, 200, 599.995277; rpy 180 0 -24.361847)",
        "(500, 200, 599.906778; rpy 180 0 -31.830284)",
    )
    via = f"spline via {points[0]}, {points[1]} to {points[2]}"
    found = ran(tmp_path, f"mov (500, 200, 600; rpy 180 0 -21)\n{via}\nmov (500, 200, 650; rpy 180 0 -21)\n")
    (refused,) = (one for one in found.findings if one.is_error)
    assert refused.code == "M567"
    assert refused.span is not None
    assert refused.span.line == 4
    assert len(found.events_of(MoveEvent)) == 2


def test_a_line_on_which_a_joint_would_need_too_long_is_refused_at_once(tmp_path: Path) -> None:
    cell = f"{CELL}[controller]\njoint_speed = [0.001, 110, 110, 110, 110, 110]\n"
    found = ran(tmp_path, "lin (600, 0, 600)\nlin (600, 100, 600)\n", cell)
    assert {one.code for one in found.findings if one.is_error} <= {"M513", "M505", "M501"}
    assert "M513" in {one.code for one in found.findings}


def test_a_load_that_cannot_be_held_is_told_without_trying_speeds(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def try_it(*_: object) -> joint_fit.Fit:
        pytest.fail("a speed was tried")

    monkeypatch.setattr(joint_fit, "as_bounds_allow", try_it)
    tool = "[tools.weight]\nposition = [0, 0, 150]\nmass = 60.0\n"
    found = ran(tmp_path, "set tool weight\nmov (700, 0, 300)\nlin (700, 0, 200)\n", CELL + tool)
    assert "M564" in {one.code for one in found.findings}, [str(one) for one in found.findings]
