"""What a program means by the manual is what compiler and machine make of it, for programs at random.

`python -m tools.meaning --programs 20000` reads more; docs/explanation/robustness.md tells what that found.
"""

from collections import Counter

import pytest

from support.examples import examples
from support.programs.agreement import disagreement
from support.programs.making import program
from support.programs.meaning import carried_out
from support.programs.text import written
from support.programs.values import TooLongError

PROGRAMS = examples(500)
BATCH = 50
WORDS = """
if elseif else while repeat until for each with set load lin print return break continue stop const var
pattern task above offset rel in and or not mod here mov home joints
"""


@pytest.mark.parametrize("first", range(0, PROGRAMS, BATCH))
def test_programs_say_go_hold_and_trap_as_the_manual_says(first: int) -> None:
    found = [disagreement(seed) for seed in range(first, first + BATCH)]
    assert [one for one in found if one] == []
    assert found.count(None) < BATCH // 4  # most programs are followed to their end


def test_the_programs_are_of_all_sorts() -> None:
    """They end and trap, say and move, and use every statement."""
    ends: Counter[str] = Counter()
    words: Counter[str] = Counter()
    for seed in range(100):
        made = program(seed)
        words.update(written(made).replace("(", " ").split())
        try:
            run = carried_out(made, {"part_ok": True})
        except TooLongError:
            continue
        ends.update([run.trap[0] if run.trap else "end"])
        ends.update({"says": len(run.says), "moves": len(run.moves)})
    assert min(ends[one] for one in ("end", "says", "moves")) > 20
    assert min(ends[one] for one in ("I460", "I461")) > 2
    assert set(WORDS.split()) - set(words) == set()
