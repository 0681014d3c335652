"""Do a job again and again, each time killed at another moment, and look what the next start finds.

Arguments: JOB KILLS SEED [timed]

Every act and every check is a process of its own, forked from this one, which has no threads. With `timed`
the parent kills at a random time instead of the child at a counted moment.
"""

import json
import os
import random
import signal
import sys
import time
import traceback
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory

from support.kills.job import Job, Progress
from support.kills.jobs import JOBS
from support.kills.points import Points

_LONGEST = 0.02  # until a timed kill [s]


def _forked(work: Callable[[int], None], killed_after: float = 0.0) -> tuple[int, list[str]]:
    """Do work in a child and return its wait status and the words it has told.

    Args:
        work: is given the handle on which it tells.
        killed_after: seconds after which the child is killed, 0 for never.
    """
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        code = 1
        try:
            os.close(reading)
            work(writing)
            code = 0
        except BaseException as error:
            os.write(writing, ("!" + "".join(traceback.format_exception_only(error))[:800] + "\n").encode())
        os._exit(code)
    os.close(writing)
    if killed_after:
        time.sleep(killed_after)
        os.kill(child, signal.SIGKILL)
    with os.fdopen(reading, encoding="utf-8", errors="replace") as stream:
        told = stream.read().splitlines()
    _, status = os.waitpid(child, 0)
    return status, told


def _act(job: Job, folder: Path, last: int) -> Callable[[int], None]:
    def work(handle: int) -> None:
        points = Points(folder, last)
        job.act(folder, lambda progress: _tell(handle, progress.value))
        _tell(handle, Progress.DONE.value)
        _tell(handle, str(points.count))

    return work


def _tell(handle: int, word: str) -> None:
    os.write(handle, f"{word}\n".encode())


def _progress(told: list[str]) -> Progress:
    words = [one for one in told if one in {progress.value for progress in Progress}]
    return Progress(words[-1]) if words else Progress.BEGUN


def _kill(job: Job, last: int, killed_after: float) -> tuple[bool, str]:
    """Return whether the job was killed in the midst, and what the next start had to complain of."""
    with TemporaryDirectory(prefix="ropsim-kill-") as name:
        folder = Path(name)
        job.prepare(folder)
        status, told = _forked(_act(job, folder, last), killed_after)
        killed = os.WIFSIGNALED(status) and os.WTERMSIG(status) == signal.SIGKILL
        if not killed and status:
            return killed, f"the job itself failed: {told}"
        progress = _progress(told)
        checked, said = _forked(lambda _: job.check(folder, progress))
        return killed, "" if checked == 0 else f"after moment {last}, {progress.value}: {said}"


def _moments(job: Job) -> int:
    with TemporaryDirectory(prefix="ropsim-kill-") as name:
        job.prepare(Path(name))
        status, told = _forked(_act(job, Path(name), 0))
        if status:
            raise RuntimeError(f"the job fails without being killed: {told}")
        return int(told[-1])


def main() -> None:
    """Kill a job and print what was found as one line of JSON."""
    name, kills, seed, *how = sys.argv[1:]
    job, draw = JOBS[name], random.Random(f"{seed}/{name}")
    moments = _moments(job)
    killed, faults = 0, []
    waiting: list[int] = []
    for _ in range(int(kills)):
        if not waiting:  # all moments come before one comes again
            waiting = draw.sample(range(1, moments + 1), moments)
        after = draw.uniform(0.0005, _LONGEST) if how else 0.0
        ended, fault = _kill(job, 0 if how else waiting.pop(), after)
        killed += ended
        faults += [fault] if fault else []
    sys.stdout.write(json.dumps({"job": name, "moments": moments, "killed": killed, "faults": faults}))
