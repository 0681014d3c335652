"""Keeps unsaved texts in the journal: soon after each edit, at once when a tab goes."""

import asyncio
from collections.abc import Callable, Mapping

from ropsim.core import Diagnostic
from ropsim.studio.diagnostics import NO_JOURNAL
from ropsim.userfiles import Draft, Journal

SOON = 0.15
"""Longest wait after an edit [s]; with the writing it stays below a third of a second."""


class Keeper:
    """Writes the journal in a thread, one writing at a time.

    Args:
        journal: where to; None where there can be none.
        drafts: returns the unsaved texts.
        failed: called once with the reason why texts are not kept, and again when it changes.
    """

    def __init__(
        self,
        journal: Journal | None,
        drafts: Callable[[], Mapping[str, Draft]],
        failed: Callable[[Diagnostic], None],
    ) -> None:
        self._journal = journal
        self._drafts = drafts
        self._failed = failed
        self._reason = ""
        self._written: Mapping[str, Draft] | None = None
        self._timer: asyncio.TimerHandle | None = None
        self._lock = asyncio.Lock()
        self._writing: asyncio.Task[None] | None = None

    def soon(self) -> None:
        """Have the texts written shortly; further edits until then go along."""
        if self._timer is None:
            self._timer = asyncio.get_running_loop().call_later(SOON, self._begin)

    async def now(self) -> None:
        """Write the texts before anything else."""
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None
        await self._write()

    def _begin(self) -> None:
        self._timer = None
        self._writing = asyncio.get_running_loop().create_task(self._write())

    async def _write(self) -> None:
        if self._journal is None:
            return
        async with self._lock:
            drafts = dict(self._drafts())
            if drafts == self._written:
                return
            try:
                await asyncio.to_thread(self._journal.write, drafts)
            except OSError as error:
                self._tell(error)
            else:
                self._written, self._reason = drafts, ""

    def _tell(self, error: OSError) -> None:
        reason = error.strerror or str(error)
        if reason != self._reason:
            self._reason = reason
            message = f"unsaved text cannot be kept for the next start: {reason}"
            self._failed(NO_JOURNAL.at(None, message, hint="save often"))
