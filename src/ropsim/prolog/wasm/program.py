"""The SWI-Prolog of the package as a program that answers."""

from collections.abc import Callable, Generator

from ropsim.prolog.program import own_sources
from ropsim.prolog.wasm.artefact import artefact
from ropsim.prolog.wasm.foreign import Foreign
from ropsim.prolog.wasm.image_cache import image_name, keep_image, kept_image, mark_of
from ropsim.prolog.wasm.instance import Host, Instance

START = "start"
"""Mark of a program to which nothing has been given yet."""
GRACE = 0.05
"""Time beyond the limit after which a program that did not stop is ended from outside [s]."""


class WasmProgram:
    """A `Program` inside of this process."""

    grace = GRACE

    def __init__(self, memory_bytes: int, answer: Callable[[str], str]) -> None:
        """Start Prolog, or go on from where an earlier one had started; see `ropsim.prolog.program.Start`.

        Raises:
            CrashError: it does not start.
            RopsimError: the files of SWI-Prolog are not there.
        """
        self._answer = answer
        sources = own_sources("in_process.pl")
        self._instance = Instance(artefact(), Host(memory_bytes, self._called))
        self._foreign = Foreign(self._instance)
        for name, content in sources.items():
            self._instance.files.replace(f"/ropsim/{name}", content)
        self._mark = mark_of(artefact().digest, memory_bytes, sources)
        self._changes = self._instance.files.changes
        if not self.go_on(START):
            self._instance.hold()
            self._foreign.initialise(("swipl", "-q", "--nosignals", "/ropsim/engine.pl"))
            self._instance.printed()
            self.keep(START)

    @property
    def has_ended(self) -> bool:
        """Return whether it has crashed or was stopped."""
        return self._instance.has_ended

    def write(self, path: str, content: bytes) -> None:
        """Write a file into the file system of Prolog."""
        before = self._instance.files.changes
        self._instance.files.replace(path, content)
        self._changes += self._instance.files.changes - before

    def place(self, path: str) -> str:
        """Return the path: all files that Prolog sees are its own."""
        return path

    def printed(self) -> str:
        """Return the output of Prolog since the last call."""
        return self._instance.printed()

    def replies(self, name: str, request: str) -> Generator[tuple[str, bool]]:
        """Call one of our predicates, see `Program.replies`."""
        return self._foreign.replies(name, "ropsim_engine", request)

    def go_on(self, mark: str) -> bool:
        """Go on from where another one was kept under a mark; return whether there is one."""
        image = kept_image(image_name(self._mark, mark))
        return image is not None and self._instance.go_on_from(image)

    def keep(self, mark: str) -> None:
        """Save an image of the program; not if it has changed files itself."""
        if self._instance.files.changes == self._changes:
            keep_image(image_name(self._mark, mark), self._instance.image())

    def limit(self) -> None:
        """Let the next `stop` end anything that runs from now on."""
        self._instance.limit()

    def stop(self) -> None:
        """End the present work of Prolog; any thread may call this."""
        self._instance.stop()

    def close(self) -> None:
        """End Prolog; its memory goes with it."""
        self._instance.has_ended = True

    def _called(self, request: int, reply: int) -> int:
        return self._foreign.unify(reply, self._answer(self._foreign.text(request)))
