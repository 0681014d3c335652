"""A run at the pace of the clock: the same steps, and which came too late, with a clock of the test's own."""

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from ropsim import icr
from ropsim.cli.terminal.real_time import AHEAD, Clock, RealTime
from ropsim.cli.testing import main
from ropsim.flow import Fidelity, Recording
from ropsim.model import Cell
from ropsim.simulation import RunOptions
from ropsim.simulation import run as simulate
from ropsim.workbench import open_project

CELL = '[cell]\nname = "c"\n[robot]\nmodel = "puma560"\n'
PROGRAM = """\
program c
units mm, deg, s
mov (500, -200, 300)
wait 1 s
lin (500, 200, 300) speed 200 mm/s
mov home
"""


class Hands:
    """Clocks that move only when they are told to."""

    def __init__(self) -> None:
        self.time = self.had = 0.0
        self.slept: list[float] = []
        self.interrupts = -1

    def sleep(self, seconds: float) -> None:
        if len(self.slept) == self.interrupts:
            raise KeyboardInterrupt
        self.slept.append(seconds)
        self.time += seconds

    def work(self, seconds: float, *, alone: bool = True) -> None:
        self.time += seconds
        self.had += seconds if alone else 0.0

    def clock(self) -> Clock:
        return Clock(lambda: self.time, lambda: self.had, self.sleep)


@pytest.fixture(scope="module")
def cell(tmp_path_factory: pytest.TempPathFactory) -> tuple[Cell, dict[str, icr.Program]]:
    folder = tmp_path_factory.mktemp("cell")
    (folder / "programs").mkdir()
    (folder / "cell.toml").write_text(CELL)
    (folder / "programs" / "main.task").write_text(PROGRAM)
    project = open_project(folder)
    cell, codes = project.runnable(project.programs(None))
    return cell, dict(codes)


def paced(
    cell: tuple[Cell, dict[str, icr.Program]], hands: Hands, late: dict[int, float], *, alone: bool = True
) -> tuple[Recording, RealTime]:
    """Run while planning the sequences of some lines takes some time [s]."""
    options = RunOptions(Fidelity.KINEMATIC)

    def plan(*given: Any) -> Any:
        hands.work(late.get(given[2].moves[0].origin.span.line, 0.0), alone=alone)
        return options.plan(*given)

    pace = RealTime(hands.clock())
    recording = simulate(*cell, pace.paced(replace(options, plan=plan)))
    return recording, pace


def test_a_paced_run_takes_as_long_as_its_motion_and_has_the_bits_of_a_quick_one(
    cell: tuple[Cell, dict[str, icr.Program]],
) -> None:
    hands = Hands()
    recording, pace = paced(cell, hands, {})
    quick = simulate(*cell, RunOptions(Fidelity.KINEMATIC))
    assert not pace.missed
    assert pace.text().startswith("real time: held")
    assert hands.time == pytest.approx(AHEAD + quick.duration, abs=1e-9)
    assert np.array_equal(recording.channels["q"].values, quick.channels["q"].values)
    assert max(hands.slept) <= 0.02 + AHEAD + 1e-9  # it never runs a whole move ahead


def test_planning_within_what_the_run_is_ahead_is_not_late(cell: tuple[Cell, dict[str, icr.Program]]) -> None:
    _, pace = paced(cell, Hands(), {5: 0.8 * AHEAD})
    assert not pace.missed
    assert pace.nearest == pytest.approx(0.2 * AHEAD)


def test_a_late_step_names_the_line_that_was_planned_and_delays_no_other(
    cell: tuple[Cell, dict[str, icr.Program]],
) -> None:
    hands = Hands()
    recording, pace = paced(cell, hands, {5: AHEAD + 0.03, 6: AHEAD + 0.1})
    assert [round(one.late, 9) for one in pace.missed] == [0.03, 0.1]
    assert [one.cause for one in pace.missed] == [
        "planning line 5 took 280 ms",
        "planning line 6 took 350 ms",
    ]
    assert hands.time == pytest.approx(AHEAD + recording.duration + 0.13, abs=1e-9)
    assert "not held, 2 of" in pace.text()
    assert "by 130 ms in all" in pace.text()
    assert pace.missed[0].time == pytest.approx(
        next(one.time for one in recording.events if one.span and one.span.line == 5)
    )


def test_a_step_that_waits_for_the_processor_says_so(cell: tuple[Cell, dict[str, icr.Program]]) -> None:
    _, pace = paced(cell, Hands(), {5: AHEAD + 0.03}, alone=False)
    assert [one.cause for one in pace.missed] == ["other processes had the processor for 280 ms"]


def test_compiling_is_a_cause(cell: tuple[Cell, dict[str, icr.Program]]) -> None:
    hands = Hands()
    pace = RealTime(hands.clock())
    options = RunOptions(Fidelity.KINEMATIC)

    def plan(*given: Any) -> Any:
        if given[2].moves[0].origin.span.line == 5:
            hands.work(2.0)
            pace.compiled(1)
        return options.plan(*given)

    simulate(*cell, pace.paced(replace(options, plan=plan)))
    assert [one.cause for one in pace.missed] == ["functions were compiled (once: later runs load them)"]


def test_an_interrupt_ends_the_run_and_keeps_what_was(cell: tuple[Cell, dict[str, icr.Program]]) -> None:
    hands = Hands()
    hands.interrupts = 20
    recording, _ = paced(cell, hands, {})
    assert 0.0 < recording.duration < simulate(*cell, RunOptions(Fidelity.KINEMATIC)).duration - 1.0


def test_the_command_tells_it(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "programs").mkdir()
    (tmp_path / "cell.toml").write_text(CELL)
    (tmp_path / "programs" / "main.task").write_text("program c\nunits s\nwait 0.2 s\n")
    assert main(["run", str(tmp_path), "--real-time", "--kinematic", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)["real_time"]
    assert told["held"] is (not told["missed"])
    assert told["ahead"] == AHEAD
    assert told["steps"] >= 1
