"""Moves that no time law can make are told at once, on their line, and the others go on."""

from pathlib import Path

import pytest

from ropsim.flow import MoveEvent, Recording
from ropsim.motion import Arc
from ropsim.planning.testing import EvaluatedTrajectory, fitting
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
    def try_it(*_: object) -> EvaluatedTrajectory:
        pytest.fail("a speed was tried")

    monkeypatch.setattr(fitting, "as_bounds_allow", try_it)
    tool = "[tools.weight]\nposition = [0, 0, 150]\nmass = 60.0\n"
    gentle = "[controller]\npath_acceleration = 1000\npath_jerk = 10000\n"  # no joint is at another limit
    found = ran(tmp_path, "set tool weight\nmov (700, 0, 300)\nlin (700, 0, 200)\n", CELL + gentle + tool)
    assert "M564" in {one.code for one in found.findings}, [str(one) for one in found.findings]


@pytest.mark.parametrize("angle", ["1e6", "1e7"])
def test_an_arc_of_far_too_many_turns_is_refused_before_it_is_sampled(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, angle: str
) -> None:
    sampled: list[int] = []
    monkeypatch.setattr(Arc, "tool", lambda _, s: sampled.append(len(s)))
    arc = f"circ via (520, 50, 600) to (500, 100, 600) angle {angle}"
    found = ran(tmp_path, f"mov (500, 0, 600)\n{arc}\nmov (500, 0, 650)\n")
    (refused,) = (one for one in found.findings if one.is_error)
    assert (refused.code, refused.span and refused.span.line) == ("M513", 4)
    assert sum(sampled) < 1000
    assert len(found.events_of(MoveEvent)) == 2


@pytest.mark.parametrize(
    ("via", "to", "said"),
    [
        ("(500, 100, 600), (500, y, 600)", "(550, 100, 600)", "point 1 and point 2"),
        ("(500, 100, 600), (520, 150, 600)", "(520, y + 50, 600)", "point 2 and the target"),
        ("(500, y, 600)", "(500, 100, 600; rpy 180 0 20)", "point 1 and the target"),
    ],
)
def test_points_of_a_curve_that_are_at_one_place_are_told_in_the_run_as_by_the_compiler(
    tmp_path: Path, via: str, to: str, said: str
) -> None:
    found = ran(tmp_path, f"mov (500, 0, 600)\ny = 100 mm\nspline via {via} to {to}\n")
    (refused,) = (one for one in found.findings if one.is_error)
    assert (refused.code, refused.span and refused.span.line) == ("M567", 5)
    assert f"{said} are at one place" in refused.message


def test_a_curve_may_begin_at_its_first_point(tmp_path: Path) -> None:
    found = ran(tmp_path, "mov (500, 0, 600)\nspline via (500, 0, 600), (520, 60, 600) to (550, 100, 600)\n")
    assert found.ok
