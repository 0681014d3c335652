"""The law of the keys of lines: where an edit leaves the key of a line, a run leaves its result."""

from pathlib import Path
from random import Random

import pytest

from ropsim.flow import Fidelity, MoveEvent, Recording
from ropsim.simulation import RunOptions
from ropsim.workbench import new_project, open_project

TEXT = """program main
units mm, s, mm/s
task Go(q: loc)
  mov q above 60
  lin q
  wait 0.2
endp
set speed 200 mm/s
mov pick_up above 100
lin pick_up above 70 blend 20
lin pick_up above 40
Go set_down
for i = 1 to 2
  lin set_down above (30 + 10 * i)
  mov set_down above 90
endf
Go pick_up
"""
NUMBERS = ("100", "70", "20", "40", "30", "90", "60", "0.2", "200")


def run(folder: Path, text: str) -> Recording:
    (folder / "programs" / "main.task").write_text(text, "utf-8")
    return open_project(folder).simulate(options=RunOptions(fidelity=Fidelity.KINEMATIC))


def results(recording: Recording) -> dict[int, list[tuple[float, ...]]]:
    """Return by line the times of its moves, to the bit, with what they settle and how they are planned."""
    found: dict[int, list[tuple[float, ...]]] = {}
    for move in recording.events_of(MoveEvent):
        span = move.span
        assert span is not None
        found.setdefault(span.line, []).append((move.time, move.duration, move.settle))
    return found


@pytest.mark.parametrize("seed", range(4))
def test_a_line_with_the_same_key_has_the_same_result(tmp_path: Path, seed: int) -> None:
    random, folder = Random(seed), new_project(tmp_path / "cell", "first_cell")
    before = run(folder, TEXT)
    (known,) = before.content.results.values()
    for _ in range(4):
        lines = TEXT.split("\n")
        number = random.choice([n for n, line in enumerate(lines) if any(one in line for one in NUMBERS)])
        old = next(one for one in NUMBERS if one in lines[number])
        lines[number] = lines[number].replace(old, f"{float(old) * random.uniform(0.9, 1.1):.3f}", 1)
        lines.insert(0, "# a remark")
        after = run(folder, "\n".join(lines))
        (keys,) = after.content.results.values()
        then, now = results(before), results(after)
        same = [line for line in then if keys.get(line + 1) == known[line]]
        assert [then[line] for line in same] == [now[line + 1] for line in same]
        assert len(same) < len(then)
