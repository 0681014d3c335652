"""The command `swipl` as a program that answers over a pipe (src/ropsim/prolog/pl/pipe.pl)."""

import contextlib
import os
import shutil
import subprocess
import weakref
from collections.abc import Callable, Generator, Iterator
from pathlib import Path
from tempfile import mkdtemp

from ropsim.core import RopsimError
from ropsim.prolog.diagnostics import NO_NATIVE_PROLOG
from ropsim.prolog.native.frames import Frames, limit_memory
from ropsim.prolog.program import MOST_BYTES, CrashError, StoppedError, TooLongError, own_sources

COMMAND = "swipl"
MOST_PRINTED = 64 << 10
"""Number of characters of output that are kept."""
_KEPT = ("PATH", "LANG", "LC_ALL", "SYSTEMROOT", "TEMP", "TMP", "LD_LIBRARY_PATH", "DYLD_LIBRARY_PATH")
"""Environment variables passed to the process."""


GRACE = 0.5
"""As that of the built-in one [s]; a process may have to wait for its turn."""


class NativeProgram:
    """A `Program` that is a child process; it ends with the object."""

    grace = GRACE

    def __init__(self, memory_bytes: int, answer: Callable[[str], str]) -> None:
        """Start Prolog; see `ropsim.prolog.program.Start`.

        Raises:
            CrashError: it does not start.
            RopsimError: P107, the command does not exist.
        """
        command = shutil.which(COMMAND)
        if command is None:
            raise RopsimError(NO_NATIVE_PROLOG.at(None, f"there is no command `{COMMAND}` on this machine"))
        self._answer = answer
        self._is_stopped = False
        self._root = Path(mkdtemp(prefix="ropsim-prolog-")).resolve()
        for name, content in own_sources("pipe.pl").items():
            self.write(f"/ropsim/{name}", content)
        self._process = self._started(command, memory_bytes)
        self._end = weakref.finalize(self, _ended, self._process, self._root)
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._frames = Frames(self._process.stdin, self._process.stdout)
        self._printed = 0
        if self._received()[0] != "end":
            raise self._crash()

    @property
    def has_ended(self) -> bool:
        """Return whether it has crashed or was stopped."""
        return self._is_stopped or not self._end.alive or self._process.poll() is not None

    def write(self, path: str, content: bytes) -> None:
        """Put a file into the folder of this Prolog."""
        place = Path(self.place(path))
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_bytes(content)

    def place(self, path: str) -> str:
        """Return where a file lies: in a folder that is this Prolog's own.

        Raises:
            CrashError: the path leads out of it.
        """
        place = self._root.joinpath(*Path(path).parts[1:]).resolve()
        if not place.is_relative_to(self._root):
            raise CrashError("a path leads out of the folder of Prolog")
        return place.as_posix()

    def printed(self) -> str:
        """Return the output of Prolog since the last call, up to 64 KiB."""
        with contextlib.suppress(OSError), (self._root / "printed").open("rb") as file:
            file.seek(self._printed)
            found = file.read(MOST_PRINTED)
            self._printed = file.seek(0, os.SEEK_END)
            return found.decode(errors="replace")
        return ""

    def replies(self, name: str, request: str) -> Generator[tuple[str, bool]]:
        """Call one of our predicates, see `Program.replies`."""
        self._send("ask", name, request)
        is_open = True
        try:
            while True:
                word, text = self._received()
                is_open = word == "more"
                if word == "long":
                    raise TooLongError(f"a text of {text} characters; at most {MOST_BYTES} are taken")
                if word == "end":
                    return
                yield text, word == "last"
                if word == "last":
                    return
                self._send("next")
        finally:
            if is_open and not self.has_ended:
                self._send("cut")
                while self._received()[0] != "done":
                    pass

    def go_on(self, _mark: str) -> bool:
        """Return False: no process is kept."""
        return False

    def keep(self, _mark: str) -> None:
        """Do nothing: a process cannot be kept."""

    def limit(self) -> None:
        """Do nothing: `stop` always ends the process."""

    def stop(self) -> None:
        """End the process; any thread may call this."""
        self._is_stopped = True
        self._process.kill()

    def close(self) -> None:
        """End the process."""
        self._end()

    def _started(self, command: str, memory_bytes: int) -> "subprocess.Popen[bytes]":
        words = ["-q", "-f", "none", "--no-packs", "--no-signals", "--no-tty"]
        goal = ["-g", "ropsim_host:serve", "-t", "halt(1)", self.place("/ropsim/engine.pl")]
        stack = f"--stack-limit={memory_bytes >> 10}K"
        environment = {key: os.environ[key] for key in _KEPT if key in os.environ}
        process = subprocess.Popen(
            [command, *words, stack, *goal],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            cwd=self._root,
            env={**environment, "HOME": str(self._root)},
        )
        limit_memory(process.pid, memory_bytes)
        return process

    def _received(self) -> tuple[str, str]:
        """Return the next frame that is no call of the host; calls are answered."""
        for word, text in self._arriving():
            if word != "call":
                return word, text
            self._send("answer", "-", self._answer(text))
        raise self._crash()

    def _arriving(self) -> Iterator[tuple[str, str]]:
        try:
            yield from self._frames
        except (OSError, ValueError) as error:
            raise self._crash() from error

    def _send(self, word: str, name: str = "-", text: str = "") -> None:
        try:
            self._frames.send(word, name, text)
        except (OSError, ValueError) as error:
            raise self._crash() from error

    def _crash(self) -> CrashError:
        was_stopped = self._is_stopped
        self._end()
        if was_stopped:
            return StoppedError("stopped")
        return CrashError(f"the process has ended with {self._process.returncode}")


def _ended(process: "subprocess.Popen[bytes]", root: Path) -> None:
    process.kill()
    process.wait()
    for pipe in (process.stdin, process.stdout):
        if pipe is not None:
            with contextlib.suppress(OSError):  # input that it did not read
                pipe.close()
    shutil.rmtree(root, ignore_errors=True)
