"""What an arm carries against its rated payload."""

from dataclasses import replace
from functools import cache

from ropsim import language, robots
from ropsim.cellfile import read_cell
from ropsim.core import SourceText
from ropsim.flow import Recording
from ropsim.model import RobotModel
from ropsim.simulation import RunOptions, run
from ropsim.simulation.testing import FinishedStation, Tally, Track, load_findings
from ropsim.workbench import environment_of

ARM = robots.load("irb120")
HZ = 1000
LINES = Track([0, 100, 200, 300], [0, 3, 4, 5])


@cache
def carried(mass: str, model: str = "irb120") -> Recording:
    """Return a run in which an arm has a tool of this mass [kg]."""
    toml = f"""
[cell]
name = "loads"
[robot]
model = "{model}"
tool = "block"
[tools.block]
position = [0, 0, 100]
mass = {mass}
"""
    cell, findings = read_cell(SourceText("cell.toml", toml), "loads")
    assert cell is not None, findings
    text = "program main\nunits mm, deg, s\nmov joints(0, 0, 0, 0, 60, 0)\n"
    code = language.compile(text, environment_of(cell, cell.first), name="main.task")
    assert code.icr is not None, code.diagnostics
    return run(cell, {cell.first.name: code.icr}, RunOptions())


def finished(robot: RobotModel, loads: Track) -> FinishedStation:
    """Return a station that has carried these loads."""
    return FinishedStation(robot, "a.task", HZ, 0.4, Tally((), 0), LINES, loads, ())


def test_the_heaviest_load_is_told_at_the_line_that_took_it() -> None:
    loads = Track([0, 150, 250, 350], [1.0, 3.2, 4.5, 1.0])
    (found,) = load_findings(finished(ARM, loads))
    assert found.code == "S749"
    assert found.message == "tool and parts have 4.5 kg, `irb120` may carry 3 kg"
    assert found.span is not None
    assert found.span.line == 4
    assert found.data["time_s"] == 0.25


def test_what_the_maker_allows_is_no_finding() -> None:
    assert load_findings(finished(ARM, Track([0, 150], [1.0, 0.1 + 2.9]))) == ()


def test_an_arm_of_which_nobody_says_it_may_carry_anything() -> None:
    unknown = replace(ARM, rated_payload=float("inf"))
    assert load_findings(finished(unknown, Track([0], [1e6]))) == ()


def test_a_run_looks_at_the_load_and_says_so() -> None:
    light, heavy = carried("2.9"), carried("3.1")
    assert light.facts.checked == heavy.facts.checked == ("rated payload",)
    assert "S749" not in {one.code for one in light.findings}
    assert [one.data["value"] for one in heavy.findings if one.code == "S749"] == [3.1]


def test_a_run_of_an_arm_without_a_rated_payload_has_not_looked_at_it() -> None:
    assert carried("3.1", "tx60").facts.checked == ()
