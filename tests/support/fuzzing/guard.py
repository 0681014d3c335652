"""Cases read in child processes that may hang, die or eat memory; what was wrong is kept."""

import json
import signal
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import TemporaryDirectory

from support.fuzzing.targets import MODULES
from support.nursery import Ended, Nursery

CHILD = "support.fuzzing.child"
HANG = 20.0
"""Processor time that a case may take [s]."""
_MOST_FAULTS = 50


@dataclass(slots=True)
class Result:
    """What became of the cases of a target.

    Attributes:
        target: its name.
        cases: how many were read.
        answers: how often each answer was given.
        faults: what was wrong, by the number of the case.
        peak: most memory that a process held [bytes].
        seconds: processor time of all processes.
    """

    target: str
    cases: int = 0
    answers: Counter[str] = field(default_factory=Counter)
    faults: dict[int, str] = field(default_factory=dict)
    peak: int = 0
    seconds: float = 0.0


def nursery() -> Nursery:
    """Return a process that has loaded all targets, of which the children are copies."""
    return Nursery([CHILD, *(f"support.fuzzing.{module}" for module in MODULES)])


def fuzz(copies: Nursery, target: str, seed: int, cases: range, hang: float = HANG) -> Result:
    """Read cases of a target in child processes; one that dies is followed by another.

    Args:
        copies: makes the children.
        target: name.
        seed: of the inputs.
        cases: numbers of the inputs.
        hang: processor time that a case may take [s].
    """
    result = Result(target)
    first = cases.start
    while first < cases.stop and len(result.faults) < _MOST_FAULTS:
        first = _batch(copies, result, seed, range(first, cases.stop), hang)
    return result


def _batch(copies: Nursery, result: Result, seed: int, cases: range, hang: float) -> int:
    """Run one child and return the case that is next."""
    with TemporaryDirectory(prefix="ropsim-fuzz-") as folder:
        notes = Path(folder) / "notes"
        words = [notes, result.target, seed, cases.start, cases.stop, hang]
        done = copies.run(CHILD, [str(word) for word in words], {"TMPDIR": folder, "HOME": folder})
        lines = notes.read_text("utf-8").splitlines() if notes.exists() else []
    reached = cases.start - 1
    for line in lines:
        entry = json.loads(line)
        if isinstance(entry, int):
            reached = entry
        elif "fault" in entry:
            result.faults[entry["case"]] = entry["fault"]
        else:
            result.answers.update(entry["answers"])
            result.peak = max(result.peak, entry["peak"])
            result.seconds += entry["seconds"]
    result.cases += reached + 1 - cases.start
    if done.code == 0:
        return cases.stop
    if reached < cases.start:
        raise RuntimeError(f"the child could not begin: {done.complained[-2000:]}")
    result.faults[reached] = _death(done)
    return reached + 1


def _death(done: Ended) -> str:
    if done.code == -signal.SIGPROF:
        return "hang: took more processor time than a case may"
    return f"died with {done.code}: {done.complained[-300:]}"
