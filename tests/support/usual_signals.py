"""Signals as a terminal gives them, for processes that are to be ended by one.

A suite that nobody sits before ignores some: Ctrl+C as `make test &` in a script, the end of its terminal
under `nohup`. What it starts would ignore them likewise.
"""

import contextlib
import signal
from collections.abc import Iterator

_ENDING = [one for one in signal.Signals if one.name in {"SIGINT", "SIGTERM", "SIGHUP"}]


@contextlib.contextmanager
def usual_signals() -> Iterator[None]:
    """Let what is started meanwhile be ended by signals that this process ignores."""
    ignored = [one for one in _ENDING if signal.getsignal(one) is signal.SIG_IGN]
    for one in ignored:
        signal.signal(one, signal.SIG_DFL)
    try:
        yield
    finally:
        for one in ignored:
            signal.signal(one, signal.SIG_IGN)
