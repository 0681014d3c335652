"""A worker process and the pipe to it: two threads, so that neither end ever blocks the event loop."""

import contextlib
import multiprocessing
import queue
import threading
from collections.abc import Callable

from ropsim.studio.processes.child import Child
from ropsim.studio.wire.orders import Request, Stop
from ropsim.studio.wire.replies import Answer

GOODBYE = 1.5
"""How long a worker may take to end regularly, then to end after it was killed [s]."""


class Pipe:
    """A running worker process.

    Args:
        name: for lists of processes.
        target: `module:function`; the function is called in the process with its end of the pipe.
        folder: working folder of the process, never that of a project.
        arrived: called with every answer, in a thread of its own.
        ended: called with the exit code once the process has ended, in that same thread.
    """

    def __init__(
        self,
        name: str,
        target: str,
        folder: str,
        arrived: Callable[[Answer], None],
        ended: Callable[[int], None],
    ) -> None:
        self._connection, far = multiprocessing.Pipe()
        self._outbox: queue.SimpleQueue[Request | None] = queue.SimpleQueue()
        self._child = Child(name, target, far, folder)
        self.process_id = self._child.process_id
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
        self._child.kill()

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
        code = self._child.exit_code()
        self._outbox.put(None)
        self._writer.join()
        self._connection.close()
        self._ended(code)

    def _write(self) -> None:
        with contextlib.suppress(OSError):  # the process has ended; the reader reports it
            while (request := self._outbox.get()) is not None:
                self._connection.send(request)
