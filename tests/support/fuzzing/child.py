"""The process that reads hostile input: it may be lost, and says before each case which one it is.

Arguments: NOTES TARGET SEED FIRST END HANG. It is a copy of a process that has loaded all targets.
"""

import contextlib
import json
import os
import resource
import signal
import sys
import traceback
from collections import Counter
from pathlib import Path
from typing import IO

from support.fuzzing.target import Target

MEMORY = 1_000_000_000
"""Memory that the process may hold [bytes]."""
_WARM = 10  # cases before which modules may still be loaded
_CEILING = 6 << 30  # address space, so that a fault of ours does not take the machine with it

_FORBIDDEN = (
    "socket.",
    "subprocess.",
    "os.system",
    "os.exec",
    "os.fork",
    "os.posix_spawn",
    "ctypes.",
    "pickle.",
)
_DOOR = os.path.join("ropsim", "codegen", "machine", "door.py")  # noqa: PTH118 - the end of a path as text
"""Hands addresses of arrays to compiled kernels by ctypes; nothing else may use that."""


class _Watch:
    """What the readers opened or called while a case was read."""

    def __init__(self) -> None:
        self.reading = False
        self.seen: list[str] = []
        sys.addaudithook(self._note)

    def _note(self, event: str, arguments: tuple[object, ...]) -> None:
        if not self.reading:
            return
        # a number is a descriptor; the path was noted when that was opened
        if event == "open" and not isinstance(arguments[0], int) and _foreign(str(arguments[0])):
            self.seen.append(f"open {arguments[0]!r}"[:200])
        elif event.startswith(_FORBIDDEN) and not _is_of_door(event):
            self.seen.append(f"{event} {arguments!r}"[:200])


def _is_of_door(event: str) -> bool:
    """Return whether an event is a use of ctypes by the door to our own compiled kernels."""
    caller = sys._getframe(2).f_code.co_filename
    return event.startswith("ctypes.") and caller.endswith(_DOOR)


def _foreign(path: str) -> bool:
    """Return whether a path is neither of this input nor of Python."""
    ours = ("ropsim-fuzz-", "__pycache__", ".py", "site-packages", "nowhere-at-all")
    return not any(part in path for part in ours)


def peak() -> int:
    """Return the most memory that this process has held [bytes]."""
    status = Path("/proc/self/status")
    if status.exists():
        (line,) = [one for one in status.read_text("ascii").splitlines() if one.startswith("VmHWM")]
        return int(line.split()[1]) * 1024
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * (1 if sys.platform == "darwin" else 1024)


def _wants_memory(error: BaseException | None) -> bool:
    """Return whether memory ran out somewhere on the way to an error."""
    while error is not None:
        if isinstance(error, MemoryError):
            return True
        error = error.__cause__ or error.__context__
    return False


def _fault(target: Target, content: bytes, watch: _Watch) -> tuple[str, str]:
    """Read a case and return how it was answered, and what was wrong with that."""
    watch.seen.clear()
    watch.reading = True
    try:
        answer = target.take(content)
    except Exception as error:
        watch.reading = False
        where = traceback.extract_tb(error.__traceback__)[-1]
        kind = "memory" if _wants_memory(error) else type(error).__name__
        return "fault", f"{kind}: {error} ({Path(where.filename).name}:{where.lineno})"[:400]
    watch.reading = False
    return answer, ("; ".join(watch.seen[:3]) if watch.seen else "")


def _read(target: Target, seed: int, cases: range, hang: float, notes: IO[str]) -> None:
    watch = _Watch()
    for number in range(_WARM):  # modules are loaded now, not while somebody watches what is opened
        with contextlib.suppress(Exception):
            target.take(target.case(-1, number))
    answers: Counter[str] = Counter()
    most = peak()
    for number in cases:
        content = target.case(seed, number)
        notes.write(f"{number}\n")
        notes.flush()
        signal.setitimer(signal.ITIMER_PROF, hang)  # its signal ends the process, whatever code it is in
        answer, fault = _fault(target, content, watch)
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        answers[answer] += 1
        now = peak()
        if now > max(most, MEMORY):
            fault = fault or f"memory: {now / 1e6:.0f} MB by now"
        most = max(most, now)
        if fault:
            notes.write(json.dumps({"case": number, "fault": fault}) + "\n")
    used = resource.getrusage(resource.RUSAGE_SELF)
    summary = {"answers": answers, "peak": most, "seconds": used.ru_utime + used.ru_stime}
    notes.write(json.dumps(summary) + "\n")


def _target(name: str) -> Target:
    if name == "fault":
        from support.fuzzing.faulty import FAULTY

        return FAULTY
    from support.fuzzing.targets import target_of

    return target_of(name)


def main() -> None:
    """Read the cases that the arguments name."""
    place, name, seed, first, end, hang = sys.argv[1:]
    resource.setrlimit(resource.RLIMIT_AS, (_CEILING, resource.getrlimit(resource.RLIMIT_AS)[1]))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    os.chdir(Path(place).parent)
    with Path(place).open("w", encoding="utf-8") as notes:
        _read(_target(name), int(seed), range(int(first), int(end)), float(hang), notes)
