"""`ropsim studio` as a child process with its own user folders, and surely ended."""

import contextlib
import os
import re
import signal
import socket
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from queue import Empty, Queue
from threading import Thread
from types import TracebackType
from typing import Self

from support.patience import PATIENCE
from support.usual_signals import usual_signals

ROPSIM = (sys.executable, "-P", "-m", "ropsim")
ADDRESS = re.compile(r"http://127\.0\.0\.1:(\d+)/\S*")


OWN_PORTS = range(20_000, 32_000)
"""Below those that systems give to whoever wants any port."""


def own_port() -> int:
    """Return a free port that nobody gets by chance, so that it is still free for the next studio."""
    for step in range(len(OWN_PORTS)):
        port = OWN_PORTS[(os.getpid() * 37 + step) % len(OWN_PORTS)]
        with socket.socket() as one, contextlib.suppress(OSError):
            one.bind(("127.0.0.1", port))
            return port
    raise AssertionError("every port is taken")


class Studio:
    """A running studio; `url` is the address it printed, with its token, `home` has the user's folders."""

    def __init__(
        self,
        folder: Path,
        home: Path,
        port: int = 0,
        command: Sequence[str] = ROPSIM,
        cwd: Path | None = None,
    ) -> None:
        """Start the studio of a project folder and wait for its address.

        Args:
            folder: project folder.
            home: folder for the user's state and settings; the same one again finds the journal again.
            port: 0 for any free one.
            command: that runs ropsim.
            cwd: working folder, `home` if none is given.
        """
        home.mkdir(parents=True, exist_ok=True)
        self.home = home
        self._errors = home / "stderr.txt"
        with self._errors.open("ab") as errors, usual_signals():
            self.process = subprocess.Popen(
                [
                    *command,
                    "studio",
                    str(folder),
                    f"--port={port}",
                    "--no-browser",
                ],
                stdout=subprocess.PIPE,
                stderr=errors,
                text=True,
                cwd=cwd or home,
                env=_environment(home),
                start_new_session=True,  # a group of its own: workers and language server end with it
            )
        self._lines: Queue[str] = Queue()
        self._reader = Thread(target=self._read, daemon=True)
        self._reader.start()
        try:
            self.url, self.port = self._address()
        except BaseException:
            self.end()
            raise

    def __enter__(self) -> Self:
        """Return the running studio."""
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """End everything."""
        self.end()

    def errors(self) -> str:
        """Return what the server has written to stderr."""
        return self._errors.read_text("utf-8", errors="replace")

    def interrupt(self) -> int:
        """Press Ctrl+C in the studio's terminal and return the exit code."""
        self.process.send_signal(signal.SIGINT)
        return self.process.wait(PATIENCE)

    def terminate(self) -> int:
        """Ask the server to end (SIGTERM) and return the exit code."""
        self.process.terminate()
        return self.process.wait(PATIENCE)

    def kill(self) -> None:
        """Kill the server without warning, as a crash would; its children are on their own."""
        self.process.kill()
        self.process.wait(PATIENCE)

    def end(self) -> None:
        """End the server and whatever it has started; safe to call again."""
        with contextlib.suppress(ProcessLookupError):  # nobody of the group is left
            os.killpg(self.process.pid, signal.SIGKILL)
        self.process.wait(PATIENCE)
        self._reader.join(PATIENCE)

    def _read(self) -> None:
        """Take over the lines of stdout, so that the pipe never fills."""
        assert self.process.stdout is not None
        with self.process.stdout as stream:
            for line in stream:
                self._lines.put(line)
        self._lines.put("")

    def _address(self) -> tuple[str, int]:
        printed = ""
        while not (found := ADDRESS.search(printed)):
            try:
                line = self._lines.get(timeout=PATIENCE)
            except Empty:
                line = ""
            if not line:
                raise AssertionError(f"the studio printed no address: {printed!r}, stderr: {self.errors()}")
            printed += line
        return found[0], int(found[1])


def _environment(home: Path) -> dict[str, str]:
    """Return an environment with user folders of its own; the cache of compiled code stays shared."""
    return {
        **os.environ,
        "XDG_CONFIG_HOME": str(home / "config"),
        "XDG_STATE_HOME": str(home / "state"),
        "PYTHONUNBUFFERED": "1",
    }
