"""The SWI-Prolog of the package as a program that answers."""

from collections.abc import Callable, Generator

from ropsim.prolog.program import own_sources
from ropsim.prolog.wasm.artefact import artefact
from ropsim.prolog.wasm.foreign import Foreign
from ropsim.prolog.wasm.instance import Host, Instance

GRACE = 0.05
"""After so much time over its limit it is stopped from outside, where it did not stop itself [s]."""


class WasmProgram:
    """A `Program` inside of this process."""

    grace = GRACE

    def __init__(self, memory_bytes: int, answer: Callable[[str], str]) -> None:
        """Start Prolog; see `ropsim.prolog.program.Start`.

        Raises:
            CrashError: it does not start.
            RopsimError: the files of SWI-Prolog are not there.
        """
        self._answer = answer
        self._instance = Instance(artefact(), Host(memory_bytes, self._called))
        self._foreign = Foreign(self._instance)
        for name, content in own_sources("in_process.pl").items():
            self._instance.files.replace(f"/ropsim/{name}", content)
        self._foreign.initialise(("swipl", "-q", "--nosignals", "/ropsim/engine.pl"))
        self._instance.printed()

    @property
    def has_ended(self) -> bool:
        """Return whether it has crashed or was stopped."""
        return self._instance.has_ended

    def write(self, path: str, content: bytes) -> None:
        """Put a file among those that Prolog sees."""
        self._instance.files.replace(path, content)

    def place(self, path: str) -> str:
        """Return the path: all files that Prolog sees are its own."""
        return path

    def printed(self) -> str:
        """Return what Prolog has printed since the last time."""
        return self._instance.printed()

    def replies(self, name: str, request: str) -> Generator[tuple[str, bool]]:
        """Ask one of our predicates, see `Program.replies`."""
        return self._foreign.replies(name, "ropsim_engine", request)

    def limit(self) -> None:
        """Let the next `stop` end what runs from now on."""
        self._instance.limit()

    def stop(self) -> None:
        """End what Prolog does now; any thread may call this."""
        self._instance.stop()

    def close(self) -> None:
        """End Prolog; its memory goes with it."""
        self._instance.has_ended = True

    def _called(self, request: int, reply: int) -> int:
        return self._foreign.unify(reply, self._answer(self._foreign.text(request)))
