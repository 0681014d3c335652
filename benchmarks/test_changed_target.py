"""One changed target among 1,000 moves: until planning and its findings are there, and the run with drives.

Run with `make bench`; figures go into docs/explanation/performance.md.
"""

from pathlib import Path
from random import Random
from time import process_time
from typing import Any

import pytest
from measuring import Measure

from ropsim.core import collect_seldom, keep_from_collection
from ropsim.flow import Fidelity, Recording
from ropsim.simulation import KeptRuns, RunOptions
from ropsim.workbench import Workspace, open_overlaid

CELL = Path(__file__).parents[1] / "examples" / "first_cell"
MOVES = 1000


def target(number: int, shift: int = 0) -> str:
    """Return a move; no two of all have one target, two behind each other go another way."""
    x, y, z = 500 + number % 7 + shift, number * 37 % 199, 600 + number * 13 % 53
    return f"{'mov' if number % 2 else 'lin'} ({x}, {y}, {z}; rpy 180 0 0)"


class Programmer:
    """Changes targets of a program with many moves, each of which stops, and runs it again."""

    def __init__(self) -> None:
        self._workspace, self._random = Workspace(), Random(3)
        self._lines = [target(number) for number in range(MOVES)]
        project = self._opened(self._lines)
        assert project.cell is not None
        self.known = KeptRuns(project.cell)

    def _opened(self, lines: list[str]) -> Any:
        text = "\n".join(("program p", "units mm, deg, s", "mov pick_up above 60", *lines, ""))
        return open_overlaid(CELL, {"programs/main.task": text}, self._workspace)

    def run(self, fidelity: Fidelity, shift: int) -> tuple[float, Recording]:
        """Change a target and run; return the processor time of both [s], and the recording."""
        lines = list(self._lines)
        collect_seldom()  # as the studio's worker does
        place = self._random.randrange(MOVES)
        lines[place] = target(place, shift)
        start = process_time()
        project = self._opened(lines)
        self.known.begin()
        recording = project.simulate(options=self.known.used_in(RunOptions(fidelity, record_hz=50)))
        seconds = process_time() - start
        keep_from_collection()  # as the studio's worker does when it has answered
        return seconds, recording


@pytest.mark.parametrize("fidelity", list(Fidelity))
def test_a_changed_target_among_a_thousand(benchmark: Any, fidelity: Fidelity) -> None:
    measure = Measure(benchmark)
    programmer = Programmer()
    whole, recording = programmer.run(fidelity, 0)
    found, _ = measure(
        lambda: [programmer.run(fidelity, shift) for shift in range(1, 61)], rounds=1, warmup=0
    )
    seconds = sorted(one for one, _ in found)
    measure.figure("milliseconds, median", 1e3 * seconds[30])
    measure.figure("milliseconds, 95 of 100", 1e3 * seconds[57])
    measure.figure("of the time of the first run", seconds[30] / whole, most=0.5)
    assert all(len(one.events) == len(recording.events) for _, one in found)
    assert len(programmer.known.plans.anew) <= 3  # it, the next one, and the `mov` before it
