"""A process of the studio next to the web process: started as a copy where that is safe, ended with it."""

import contextlib
import multiprocessing
import os
import signal
import sys
import threading
from collections.abc import Iterator, Mapping
from importlib import import_module
from multiprocessing import resource_tracker
from multiprocessing.connection import wait
from pathlib import Path
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from multiprocessing.context import ForkServerContext, SpawnContext

PRELOADED = "ropsim.studio.processes.preloaded"
"""Modules of the children of the studio: half a second of importing, and most of their memory."""

ENDINGS = [
    number
    for name in ("SIGINT", "SIGTERM", "SIGHUP", "SIGBREAK")
    if (number := getattr(signal, name, None)) is not None
]
"""Signals that may be sent to all processes of the studio at once: the web process alone answers them."""

_REAPING = threading.Lock()
"""Starting a process also collects the exit codes of ended ones; a code can be collected once."""


class _End(Protocol):
    def close(self) -> None: ...


class Child:
    """A running process.

    Args:
        name: for lists of processes; the system shows its first 15 letters.
        target: `module:function`; the function is called in the process with `far`.
        far: its end of a connection or of a pair of sockets; this side is closed once the process has it.
        folder: working folder of the process, never that of a project.
    """

    def __init__(self, name: str, target: str, far: _End, folder: str) -> None:
        around = (name, folder, dict(os.environ))
        self._process = _context().Process(target=_serve, args=(target, far, *around), name=name, daemon=True)
        if sys.platform != "win32":
            with _endings_held():
                resource_tracker.ensure_running()  # it lets some of them through again
        with _REAPING, _endings_held():
            self._process.start()
        far.close()
        self.process_id = self._process.pid

    def has_ended(self, within: float | None = None) -> bool:
        """Return whether the process has ended; wait for that at most the time given [s], else for ever."""
        return bool(wait([self._process.sentinel], within))

    def kill(self) -> None:
        """End the process at once."""
        with contextlib.suppress(ValueError):  # it has ended already
            self._process.kill()

    def exit_code(self) -> int:
        """Wait until the process has ended and return its exit code; this can be called once."""
        wait([self._process.sentinel])
        with _REAPING:
            self._process.join()
        code = self._process.exitcode or 0
        self._process.close()
        return code


def _context() -> "SpawnContext | ForkServerContext":
    """Return how processes are started: where that is safe, as copies of one process that has imported all.

    That process does nothing else, so no lock of a thread is copied: the default of Python on Linux from 3.14
    on. The second process, and each that takes the place of a lost one, starts at once, and they share the
    memory of imported modules.
    """
    if sys.platform != "linux":
        return multiprocessing.get_context("spawn")
    context = multiprocessing.get_context("forkserver")
    context.set_forkserver_preload([PRELOADED])
    return context


def _serve(target: str, far: _End, name: str, folder: str, environment: Mapping[str, str]) -> None:
    """Call a function in this process with its end of the connection."""
    for number in ENDINGS:
        signal.signal(number, signal.SIG_IGN)
    os.environ.clear()
    os.environ.update(environment)  # that of now, not of the process that this one is a copy of
    os.chdir(folder)
    with contextlib.suppress(OSError):  # Linux alone has this file
        Path("/proc/self/comm").write_text(name[:15], "utf-8")
    threading.Thread(target=_end_with_parent, daemon=True).start()
    module, function = target.split(":")
    getattr(import_module(module), function)(far)


def _end_with_parent() -> None:
    """End this process when the web process has been killed, also in the middle of a long computation."""
    parent = multiprocessing.parent_process()
    if parent is not None:
        wait([parent.sentinel])
        os._exit(1)


@contextlib.contextmanager
def _endings_held() -> Iterator[None]:
    """Keep signals from a process that is just being started; here they arrive afterwards."""
    if sys.platform == "win32":
        yield
    else:
        before = signal.pthread_sigmask(signal.SIG_BLOCK, ENDINGS)
        try:
            yield
        finally:
            signal.pthread_sigmask(signal.SIG_SETMASK, before)
