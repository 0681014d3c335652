"""The tabs that show a project, and which of them has the right to edit it."""

from collections.abc import Callable, Iterator

from ropsim.studio.session.tab import Tab
from ropsim.studio.wire.messages import EditingRight, Message, wire

GRACE = 5.0
"""How long the right waits for a tab that has lost its connection or is being loaded again [s]."""


class Tabs:
    """All connected tabs. The first one edits, the others follow until one takes the right or it is free.

    Args:
        clock: returns a time that only grows [s].
    """

    def __init__(self, clock: Callable[[], float]) -> None:
        self._clock = clock
        self._tabs: list[Tab] = []
        self._editor: Tab | None = None
        self._kept_for = ""
        self._kept_until = 0.0

    def __iter__(self) -> Iterator[Tab]:
        return iter(tuple(self._tabs))

    def add(self, tab: Tab) -> None:
        """Enter a tab that has said its name; it may edit if no other does, or if it did and reconnects."""
        self._tabs.append(tab)
        if self._editor is not None and self._editor.name == tab.name:
            self._editor.send(EditingRight(editing=False))  # a connection that is practically closed
            self._editor = tab
        kept = self._clock() < self._kept_until and self._kept_for != tab.name
        if self._editor is None and not kept:
            self._editor = tab

    def remove(self, tab: Tab) -> None:
        """Strike out a tab; its right is kept for a while."""
        if tab in self._tabs:
            self._tabs.remove(tab)
        if tab is self._editor:
            self._editor = None
            self._kept_for, self._kept_until = tab.name, self._clock() + GRACE

    def pass_on(self) -> None:
        """Pass the right to the oldest tab, if no tab has it and none is awaited."""
        if self._editor is None and self._tabs and self._clock() >= self._kept_until:
            self.take_over(self._tabs[0])

    def may_edit(self, tab: Tab) -> bool:
        """Return whether a tab has the right."""
        return tab is self._editor

    def take_over(self, tab: Tab) -> None:
        """Pass the right to a tab and notify both."""
        before, self._editor = self._editor, tab
        if before is not None and before is not tab:
            before.send(EditingRight(editing=False))
        tab.send(EditingRight(editing=True))

    def tell(self, message: Message) -> None:
        """Send a message to every tab."""
        text = wire(message)
        for tab in self._tabs:
            tab.send_text(text)

    def show(self, frame: bytes) -> None:
        """Send a state frame to every tab."""
        for tab in self._tabs:
            tab.send_frame(frame)
