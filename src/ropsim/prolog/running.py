"""One Prolog that runs: started, asked, held to its time; after a crash a new one takes its place."""

from collections.abc import Callable, Generator
from importlib.resources import files
from itertools import count
from pathlib import Path
from threading import Lock
from time import monotonic

from ropsim.core import read_bytes
from ropsim.prolog.limits import Limits
from ropsim.prolog.reading import read_term
from ropsim.prolog.terms import Atom, Struct, Term
from ropsim.prolog.wasm.artefact import artefact
from ropsim.prolog.wasm.foreign import Foreign, TooLongError
from ropsim.prolog.wasm.instance import CrashError, Host, Instance, StoppedError
from ropsim.prolog.watchdog import watchdog
from ropsim.prolog.writing import write_term

SOURCES = ("engine.pl", "reader.pl")
"""What of Prolog is ours; the first loads the others."""
GRACE = 0.05
"""After so much time over its limit Prolog is stopped from outside, where it did not stop itself [s]."""
TICK = Atom("tick")
_numbers = count()


class RunningProlog:
    """Answers requests; it belongs to one thread, except for `cancel`.

    That time is over is told in two ways. Prolog asks its host after so many inferences (`tick`) and stops by
    an error of its own, after which it can go on. Where it does not ask, or catches that error, the watchdog
    stops the program, which is of no use any more.
    """

    def __init__(self, limits: Limits, dispatch: Callable[[str], str]) -> None:
        self._dispatch = dispatch
        self._number = next(_numbers)
        self._ends: list[float] = []
        self._lock = Lock()
        self._cancelled = False
        self._instance = Instance(artefact(), Host(limits.memory_bytes, self._called))
        self._foreign = Foreign(self._instance)
        for name in SOURCES:
            path = Path(str(files("ropsim.prolog").joinpath("pl", name)))
            self._instance.files.replace(f"/ropsim/{name}", read_bytes(path))
        self._foreign.initialise(("swipl", "-q", "--nosignals", "/ropsim/engine.pl"))
        self._instance.printed()

    @property
    def is_busy(self) -> bool:
        """Return whether it is in the middle of a request."""
        return bool(self._ends)

    @property
    def has_ended(self) -> bool:
        """Return whether it has crashed or was stopped from outside."""
        return self._instance.has_ended

    def write(self, path: str, content: bytes) -> None:
        """Put a file among those that Prolog sees."""
        self._instance.files.replace(path, content)

    def printed(self) -> str:
        """Return what Prolog has printed since the last time."""
        return self._instance.printed()

    def cancel(self) -> None:
        """Stop what runs; any thread may call this."""
        with self._lock:
            if self._ends:
                self._cancelled = True
                watchdog().watch(self._number, monotonic() + GRACE, self._instance.stop)

    def ask(self, name: str, request: Term, seconds: float) -> Generator[Term]:
        """Yield the replies of one of our predicates to a request.

        Args:
            name: the predicate.
            request: what it is asked.
            seconds: how long Prolog may work at it [s]; the time between replies does not count.

        Raises:
            CrashError: Prolog has ended; `StoppedError` where it did not stop when its time was over.
            TooLongError: a reply is longer than allowed.
            UnreadableError: a reply has no canonical form.
        """
        replies = self._foreign.replies(name, "ropsim_engine", write_term(request))
        left = seconds
        try:
            while True:
                begin = monotonic()
                reply = self._step(replies, begin + left)
                left = max(left - (monotonic() - begin), 0.0)
                if reply is None:
                    return
                yield read_term(reply[0])
                if reply[1]:
                    return
        finally:
            if not self._instance.has_ended:
                self._limited(replies.close, monotonic() + GRACE)

    def once(self, name: str, request: Term, seconds: float) -> Term:
        """Return the only reply to a request; errors are those of `ask`."""
        replies = self.ask(name, request, seconds)
        try:
            return next(replies, Atom("fail"))
        finally:
            replies.close()

    def _step(self, replies: Generator[tuple[str, bool]], end: float) -> tuple[str, bool] | None:
        return self._limited(lambda: next(replies, None), end)

    def _limited(self, work: Callable[[], tuple[str, bool] | None], end: float) -> tuple[str, bool] | None:
        """Let Prolog work until a time; inside of a call of the host the outer time holds, too."""
        outer = self._ends[-1] if self._ends else float("inf")
        with self._lock:
            self._ends.append(min(end, outer))
            self._instance.limit()
            watchdog().watch(self._number, self._ends[-1] + GRACE, self._instance.stop)
        try:
            return work()
        finally:
            with self._lock:
                self._ends.pop()
                watchdog().call_off(self._number)
                if self._ends:
                    watchdog().watch(self._number, self._ends[-1] + GRACE, self._instance.stop)
                else:
                    self._cancelled = False

    def _called(self, request: int, reply: int) -> int:
        """Answer a call of Prolog: whether to go on, or one of a registered predicate."""
        text = self._foreign.text(request)
        if text != TICK.name:
            return self._foreign.unify(reply, self._answered(text))
        over = bool(self._ends) and monotonic() >= self._ends[-1]  # while it starts there is no time
        return self._foreign.unify(reply, "cancelled" if self._cancelled else "time" if over else "go")

    def _answered(self, text: str) -> str:
        try:
            return self._dispatch(text)
        except TooLongError as error:  # what a function of the host was asked about
            return write_term(Struct("throw", (str(error),)))


__all__ = ["GRACE", "CrashError", "RunningProlog", "StoppedError", "TooLongError"]
