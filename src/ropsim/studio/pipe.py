"""A worker process and the pipe to it: two threads, so that neither end ever blocks the event loop."""

import contextlib
import multiprocessing
import os
import queue
import signal
import sys
import threading
from collections.abc import Callable, Iterator, Mapping
from importlib import import_module
from multiprocessing import resource_tracker
from multiprocessing.connection import Connection, wait
from typing import TYPE_CHECKING

from ropsim.studio.jobs import Answer, Request, Stop

if TYPE_CHECKING:
    from multiprocessing.context import ForkServerContext, SpawnContext

GOODBYE = 1.5
"""How long a worker may take to end by itself, then to be gone after it was killed [s]."""

PRELOADED = "ropsim.studio.preloaded"
"""What the workers of the studio are made of: half a second of importing, and most of their memory."""

ENDINGS = [
    number
    for name in ("SIGINT", "SIGTERM", "SIGHUP", "SIGBREAK")
    if (number := getattr(signal, name, None)) is not None
]
"""Signals that may be sent to all processes of the studio at once: the web process alone answers them."""

_REAPING = threading.Lock()
"""Whoever starts a process takes the exit codes of those that have ended, too; a code can be taken once."""


class Pipe:
    """A running worker process.

    Args:
        name: for lists of processes.
        target: `module:function`; the function is called in the process with its end of the pipe.
        folder: working folder of the process, never that of a project.
        arrived: called with every answer, in a thread of its own.
        ended: called with the exit code once the process is gone, in that same thread.
    """

    def __init__(
        self,
        name: str,
        target: str,
        folder: str,
        arrived: Callable[[Answer], None],
        ended: Callable[[int], None],
    ) -> None:
        context = _context()
        self._connection, far = context.Pipe()
        self._outbox: queue.SimpleQueue[Request | None] = queue.SimpleQueue()
        around = (folder, dict(os.environ))
        self._process = context.Process(target=_serve, args=(target, far, *around), name=name, daemon=True)
        if sys.platform != "win32":
            with _endings_held():
                resource_tracker.ensure_running()  # it lets some of them through again
        with _REAPING, _endings_held():
            self._process.start()
        far.close()
        self.process_id = self._process.pid
        self._arrived = arrived
        self._ended = ended
        self._reader = threading.Thread(target=self._read, name=f"from {name}", daemon=True)
        self._writer = threading.Thread(target=self._write, name=f"to {name}", daemon=True)
        self._reader.start()
        self._writer.start()

    def send(self, request: Request) -> None:
        """Put a request on its way."""
        self._outbox.put(request)

    def kill(self) -> None:
        """End the process at once."""
        with contextlib.suppress(ValueError):  # it is gone already
            self._process.kill()

    def close(self) -> None:
        """End the process, kindly if it listens; this waits for up to three seconds."""
        self._outbox.put(Request(0, Stop()))
        self._outbox.put(None)
        self._reader.join(GOODBYE)
        if self._reader.is_alive():
            self.kill()
            self._reader.join(GOODBYE)

    def _read(self) -> None:
        with contextlib.suppress(EOFError, OSError):  # the far end is closed when the process ends
            while True:
                self._arrived(self._connection.recv())
        wait([self._process.sentinel])
        with _REAPING:
            self._process.join()
        self._outbox.put(None)
        self._writer.join()
        self._connection.close()
        self._ended(self._process.exitcode or 0)
        self._process.close()

    def _write(self) -> None:
        with contextlib.suppress(OSError):  # the process has ended; the reader tells
            while (request := self._outbox.get()) is not None:
                self._connection.send(request)


def _context() -> "SpawnContext | ForkServerContext":
    """Return how workers are started: where that is safe, as copies of one process that has imported all.

    That process carries out nothing else, so no lock of a thread is copied: what Python itself prefers on
    Linux from 3.14 on. The second worker, and each that takes the place of a lost one, is there at once, and
    they share the memory of what is imported.
    """
    if sys.platform != "linux":
        return multiprocessing.get_context("spawn")
    context = multiprocessing.get_context("forkserver")
    context.set_forkserver_preload([PRELOADED])
    return context


def _serve(target: str, connection: Connection, folder: str, environment: Mapping[str, str]) -> None:
    """Run a worker in this process until its end of the pipe is closed."""
    for number in ENDINGS:
        signal.signal(number, signal.SIG_IGN)
    os.environ.clear()
    os.environ.update(environment)  # that of now, not of the process that this one is a copy of
    os.chdir(folder)
    threading.Thread(target=_end_with_parent, daemon=True).start()
    module, function = target.split(":")
    getattr(import_module(module), function)(connection)


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
