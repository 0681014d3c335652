"""Kills of a job, in a process of their own."""

import json
import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

_TESTS = Path(__file__).parents[2]


@dataclass(frozen=True, slots=True)
class Killed:
    """What came of it.

    Attributes:
        moments: at which the job may be killed.
        killed: how often it was.
        faults: what the next start found lost, half-written or not working.
    """

    moments: int
    killed: int
    faults: list[str]


def killed_job(job: str, kills: int, seed: int, *how: str) -> Killed:
    """Kill a job at random moments; `timed` kills at random times instead."""
    done = subprocess.run(
        [sys.executable, "-m", "support.kills.killing", job, str(kills), str(seed), *how],
        env={**os.environ, "PYTHONPATH": os.pathsep.join([str(_TESTS), *sys.path])},
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        check=False,
    )
    if done.returncode:
        raise RuntimeError(done.stderr[-2000:])
    found = json.loads(done.stdout)
    return Killed(found["moments"], found["killed"], found["faults"])
