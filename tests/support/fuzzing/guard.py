"""Cases read in child processes that may hang, die or eat memory; what was wrong is kept."""

import json
import os
import signal
import subprocess
import sys
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import TemporaryDirectory

_TESTS = Path(__file__).parents[2]
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


def fuzz(target: str, seed: int, cases: range, hang: float = HANG) -> Result:
    """Read cases of a target in child processes; one that dies is followed by another.

    Args:
        target: name.
        seed: of the inputs.
        cases: numbers of the inputs.
        hang: processor time that a case may take [s].
    """
    result = Result(target)
    first = cases.start
    while first < cases.stop and len(result.faults) < _MOST_FAULTS:
        first = _batch(result, seed, range(first, cases.stop), hang)
    return result


def _batch(result: Result, seed: int, cases: range, hang: float) -> int:
    """Run one child and return the case that is next."""
    with TemporaryDirectory(prefix="ropsim-fuzz-") as folder:
        notes = Path(folder) / "notes"
        path = os.pathsep.join([str(_TESTS), *sys.path])
        words = ["support.fuzzing.child", notes, result.target, seed, cases.start, cases.stop, hang]
        done = subprocess.run(
            [sys.executable, "-m", *map(str, words)],
            env={
                **os.environ,
                "PYTHONPATH": path,
                "TMPDIR": folder,
                "HOME": folder,
            },
            stdin=subprocess.DEVNULL,
            capture_output=True,
            check=False,
        )
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
    if done.returncode == 0:
        return cases.stop
    if reached < cases.start:
        raise RuntimeError(f"the child could not begin: {done.stderr.decode('utf-8', 'replace')[-2000:]}")
    result.faults[reached] = _death(done.returncode, done.stderr)
    return reached + 1


def _death(code: int, said: bytes) -> str:
    if code == -signal.SIGPROF:
        return "hang: took more processor time than a case may"
    return f"died with {code}: {said.decode('utf-8', 'replace')[-300:]}"
