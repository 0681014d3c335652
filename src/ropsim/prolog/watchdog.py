"""One thread that acts for all engines when the time of one of them is over."""

from collections.abc import Callable, Hashable
from functools import lru_cache
from threading import Condition, Thread
from time import monotonic


class Watchdog:
    """Holds one deadline and one action per owner; `call_off` waits for an action that is running."""

    def __init__(self) -> None:
        self._changed = Condition()
        self._watches: dict[Hashable, tuple[float, Callable[[], None]]] = {}
        self._wakes = float("inf")
        self._thread: Thread | None = None

    def watch(self, owner: Hashable, at: float, act: Callable[[], None]) -> None:
        """Act at a time of the monotonic clock; an earlier request of this owner is forgotten."""
        with self._changed:
            if self._thread is None:
                self._thread = Thread(target=self._run, name="ropsim-prolog-watchdog", daemon=True)
                self._thread.start()
            self._watches[owner] = at, act
            if at < self._wakes:
                self._changed.notify()

    def call_off(self, owner: Hashable) -> None:
        """Do nothing for this owner; once this has returned nothing is done any more."""
        with self._changed:
            self._watches.pop(owner, None)

    def _run(self) -> None:
        with self._changed:
            while True:
                now = monotonic()
                for owner in [owner for owner, (at, _) in self._watches.items() if at <= now]:
                    self._watches.pop(owner)[1]()
                self._wakes = min((at for at, _ in self._watches.values()), default=float("inf"))
                wait = self._wakes - now
                self._changed.wait(wait if wait < float("inf") else None)


@lru_cache(maxsize=1)
def watchdog() -> Watchdog:
    """Return the one of this process."""
    return Watchdog()
