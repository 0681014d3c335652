"""The pieces of a text that the compiler reads, and in which of them a block or an end stands alone."""

from collections.abc import Iterable, Iterator, Sequence

from ropsim.core import SourceText, frozen_dataclass
from ropsim.language.blocks.matching import Block, build
from ropsim.language.blocks.taken import told
from ropsim.language.cache import LineCache
from ropsim.language.cutting.chunks import chunks
from ropsim.language.report import Report, TooManyFindingsError
from ropsim.language.syntax.statements import If
from ropsim.language.syntax.text import Line, read


@frozen_dataclass
class LineGroup:
    """Some lines that follow each other.

    Attributes:
        lines: logical lines, each with its physical lines.
        is_sound: whether every block in it has its end, and every end its block.
    """

    lines: tuple[tuple[Line, tuple[str, ...]], ...]
    is_sound: bool

    @property
    def physical(self) -> tuple[str, ...]:
        """Return the lines as written."""
        return tuple(one for _, written in self.lines for one in written)


def line_groups(source: SourceText) -> Iterator[LineGroup]:
    """Yield the pieces of a text."""
    lines = told(list(read(source, LineCache())))
    at, behind = 0, 1
    for chunk in chunks(source.lines):
        first, behind = at, behind + len(chunk.lines)
        while at < len(lines) and lines[at].logical.number < behind:
            at += 1
        own = lines[first:at]
        yield LineGroup(tuple(_with_physical(own, source, behind)), _is_sound(own))


def _with_physical(
    lines: Sequence[Line], source: SourceText, behind: int
) -> Iterator[tuple[Line, tuple[str, ...]]]:
    ends = [*(line.logical.number for line in lines[1:]), behind]
    for line, end in zip(lines, ends, strict=True):
        yield line, source.lines[line.logical.number - 1 : end - 1]


def _is_sound(lines: Iterable[Line]) -> bool:
    report, lines = Report(""), tuple(lines)
    if any(line.fault is not None and isinstance(line.statement, If) for line in lines):
        return False  # the intended block is unknown
    try:
        tree = build((line for line in lines if line.statement is not None), report)
    except TooManyFindingsError:
        return False
    return not report.log and all(map(_is_closed, tree.items))


def _is_closed(item: Line | Block) -> bool:
    if isinstance(item, Line):
        return True
    return item.closer is not None and all(_is_closed(one) for part in item.sections for one in part.body)
