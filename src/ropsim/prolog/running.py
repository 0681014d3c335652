"""A running Prolog: started, queried, stopped at its time limit; after a crash a new one replaces it."""

from collections.abc import Callable, Generator
from itertools import count
from threading import Lock
from time import monotonic

from ropsim.prolog.limits import Limits
from ropsim.prolog.program import Start, StoppedError, TooLongError
from ropsim.prolog.terms.reading import read_term
from ropsim.prolog.terms.terms import Atom, Struct, Term
from ropsim.prolog.terms.writing import write_term
from ropsim.prolog.watchdog import watchdog

TICK = "tick"
CLOSING = 1.0
"""Time limit for undoing the effects of a request; long, since the process may wait for the CPU [s]."""
_numbers = count()


class RunningProlog:
    """Answers requests; it belongs to one thread, except for `cancel`.

    The end of the time is signalled in two ways. Prolog calls its host after a number of inferences (`tick`)
    and stops by an error of its own, after which it can go on. If it does not call, or catches that error,
    the watchdog stops the program, which is of no use any more.
    """

    def __init__(self, limits: Limits, dispatch: Callable[[str], str], start: Start) -> None:
        """Start Prolog.

        Args:
            limits: of its memory.
            dispatch: answers calls of registered predicates.
            start: starts the program.
        """
        self._dispatch = dispatch
        self._number = next(_numbers)
        self._ends: list[float] = []
        self._lock = Lock()
        self._cancelled = False
        self._program = start(limits.memory_bytes, self._answered)

    @property
    def is_busy(self) -> bool:
        """Return whether it is in the middle of a request."""
        return bool(self._ends)

    @property
    def has_ended(self) -> bool:
        """Return whether it has crashed or was stopped from outside."""
        return self._program.has_ended

    def write(self, path: str, content: bytes) -> None:
        """Write a file into the file system of Prolog."""
        self._program.write(path, content)

    def place(self, path: str) -> str:
        """Return the path under which Prolog sees a written file."""
        return self._program.place(path)

    def go_on(self, mark: str) -> bool:
        """Go on from where another one was kept; see `Program.go_on`."""
        return self._program.go_on(mark)

    def keep(self, mark: str) -> None:
        """Save an image of it; see `Program.keep`."""
        self._program.keep(mark)

    def close(self) -> None:
        """End it."""
        self._program.close()

    def printed(self) -> str:
        """Return the output of Prolog since the last call."""
        return self._program.printed()

    def cancel(self) -> None:
        """Stop the running query; any thread may call this."""
        with self._lock:
            if self._ends:
                self._cancelled = True
                watchdog().watch(self._number, monotonic() + self._program.grace, self._program.stop)

    def ask(self, name: str, request: Term, seconds: float) -> Generator[Term]:
        """Yield the replies of one of our predicates to a request.

        Args:
            name: the predicate.
            request: the request.
            seconds: how long Prolog may work at it [s]; the time between replies does not count.

        Raises:
            CrashError: Prolog has ended; `StoppedError` where it did not stop when its time was over.
            TooLongError: a reply is longer than allowed.
            UnreadableError: a reply has no canonical form.
        """
        replies = self._program.replies(name, write_term(request))
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
            if not self._program.has_ended:
                self._limited(replies.close, monotonic() + CLOSING)

    def once(self, name: str, request: Term, seconds: float) -> Term:
        """Return the only reply to a request; errors as with `ask`."""
        replies = self.ask(name, request, seconds)
        try:
            return next(replies, Atom("fail"))
        finally:
            replies.close()

    def _step(self, replies: Generator[tuple[str, bool]], end: float) -> tuple[str, bool] | None:
        return self._limited(lambda: next(replies, None), end)

    def _limited(self, work: Callable[[], tuple[str, bool] | None], end: float) -> tuple[str, bool] | None:
        """Let Prolog work until a time; inside of a call of the host the outer limit also applies."""
        outer = self._ends[-1] if self._ends else float("inf")
        with self._lock:
            self._ends.append(min(end, outer))
            self._program.limit()
            watchdog().watch(self._number, self._ends[-1] + self._program.grace, self._program.stop)
        try:
            return work()
        except StoppedError as error:
            error.why = "cancelled" if self._cancelled else "time"
            raise
        finally:
            with self._lock:
                self._ends.pop()
                watchdog().call_off(self._number)
                if self._ends:
                    watchdog().watch(self._number, self._ends[-1] + self._program.grace, self._program.stop)
                else:
                    self._cancelled = False

    def _answered(self, text: str) -> str:
        """Answer a call of Prolog: whether to go on, or one of a registered predicate."""
        if text == TICK:
            over = bool(self._ends) and monotonic() >= self._ends[-1]  # while it starts there is no time
            return "cancelled" if self._cancelled else "time" if over else "go"
        try:
            return self._dispatch(text)
        except TooLongError as error:  # called with the question to a function of the host
            return write_term(Struct("throw", (str(error),)))
