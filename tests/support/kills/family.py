"""Kills of a job, in a process of their own."""

import json
from dataclasses import dataclass

from support.nursery import Nursery

KILLING = "support.kills.killing"


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


def nursery() -> Nursery:
    """Return a process that has loaded all jobs, and numba; in its copies they are killed."""
    return Nursery([KILLING, "numba"])


def killed_job(copies: Nursery, job: str, kills: int, seed: int, *how: str) -> Killed:
    """Kill a job at random moments; `timed` kills at random times instead."""
    done = copies.run(KILLING, [job, str(kills), str(seed), *how], {})
    if done.code:
        raise RuntimeError(done.complained[-2000:])
    found = json.loads(done.printed)
    return Killed(found["moments"], found["killed"], found["faults"])
