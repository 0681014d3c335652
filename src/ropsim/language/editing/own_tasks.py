"""The tasks of texts that are being edited: only the chunks of a text that an edit touches are read again."""

from dataclasses import dataclass, field
from itertools import accumulate

from ropsim.core import SourceText, Span
from ropsim.language.cutting.chunks import Chunk
from ropsim.language.cutting.recut import Cut, recut
from ropsim.language.editing.outline import outline
from ropsim.language.syntax import statements as syntax
from ropsim.language.syntax.text import Parser, read_lines

MOST = 32
"""Texts that are remembered, those used last."""

_NO_NAMES: frozenset[str] = frozenset()


@dataclass(slots=True)
class _Known:
    """A text.

    Attributes:
        cut: its chunks.
        found: the names of the tasks of each chunk.
        names: of all its tasks.
    """

    cut: Cut = field(default_factory=Cut)
    found: list[frozenset[str]] = field(default_factory=list)
    names: frozenset[str] = _NO_NAMES


class OwnTasks:
    """Remembers texts by their names; it saves time and changes no answer.

    Args:
        parser: returns the statement of a line, and may remember it.
    """

    def __init__(self, parser: Parser) -> None:
        self._parser = parser
        self._known: dict[str, _Known] = {}

    def names(self, source: SourceText) -> frozenset[str]:
        """Return the names of the tasks of a text: the same object while they are unchanged."""
        return self._read(source).names

    def spans(self, source: SourceText, names: frozenset[str]) -> dict[str, Span]:
        """Return where some tasks of a text lie, by name, in the order of the text."""
        known = self._read(source)
        spans: dict[str, Span] = {}
        firsts = accumulate((len(one.lines) for one in known.cut.chunks), initial=0)
        for chunk, found, first in zip(known.cut.chunks, known.found, firsts, strict=False):
            if not found or found.isdisjoint(names):
                continue
            part = SourceText(source.name, "\n".join(chunk.lines))
            for task in outline(part, self._parser).tasks:
                if task.definition.name in names:
                    begin, end = task.definition.span.line, task.span.end_line
                    spans[task.definition.name] = Span(
                        source.name, first + begin, task.span.column, first + end, task.span.end_column
                    )
        return spans

    def _read(self, source: SourceText) -> _Known:
        before = self._known.pop(source.name, None) or _Known()
        text = source.with_line_feeds()
        if text == before.cut.text and before.cut.lines:
            self._known[source.name] = before
            return before
        cut = recut(text, before.cut)
        made = [*map(self._tasks, cut.unchanged.between(cut.chunks))]
        found = cut.unchanged.spliced(before.found, made)
        names = _NO_NAMES.union(*found)
        now = _Known(cut, found, before.names if names == before.names else names)
        self._known[source.name] = now
        if len(self._known) > MOST:
            del self._known[next(iter(self._known))]
        return now

    def _tasks(self, chunk: Chunk) -> frozenset[str]:
        statements = (line.statement for line in read_lines(chunk.lines, self._parser))
        headers = (one for one in statements if isinstance(one, syntax.TaskHeader))
        return frozenset(one.name.text for one in headers) or _NO_NAMES
