"""The parts of a text whose lines belong together: each task, and the control statements."""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice
from zlib import crc32

from ropsim.core import frozen_dataclass
from ropsim.language.blocks.matching import Block, Section
from ropsim.language.syntax.lines import LogicalLine
from ropsim.language.syntax.text import Line

CONTROL = "control statements"
"""Name of the unit of all statements outside tasks."""

LINES_OF_NAME = 3
"""Lines that determine the name of a part: few, so that it keeps its name during edits."""

Items = tuple[Line | Block, ...]


@frozen_dataclass
class Part:
    """Some of the control statements that follow each other.

    Attributes:
        unit: name of the unit that they make.
        items: lines and blocks.
    """

    unit: str
    items: Items


def of_task(name: str) -> str:
    """Return the name of the unit of a task."""
    return f"task {name}"


def name_of(items: Items) -> str:
    """Return the name of a part: it depends on its first lines, so that a moved part keeps it."""
    start = "\n".join(line.logical.text.strip() for line in islice(lines_of(items), LINES_OF_NAME))
    return f"{CONTROL} {crc32(start.encode(errors='surrogatepass')):08x}"


def lines_of(items: Items) -> Iterator[Line]:
    """Yield all lines, including lines in blocks."""
    for item in items:
        if isinstance(item, Line):
            yield item
            continue
        for section in item.sections:
            yield section.header
            yield from lines_of(section.body)
        if item.closer is not None:
            yield item.closer


@dataclass(slots=True)
class _Numbering:
    """Counts lines with statements only.

    Attributes:
        first: number of the line before the first one.
        offsets: position of each line in the renumbered text, from 0.
    """

    first: int
    offsets: list[int]

    def line(self, line: Line) -> Line:
        logical = line.logical
        number = self.first + len(self.offsets) + 1
        self.offsets += range(logical.number - 1, logical.number + logical.text.count("\n"))
        if logical.number == number:
            return line
        return Line(LogicalLine(number, logical.text), line.statement, line.fault)

    def items(self, items: Items) -> Items:
        return tuple(self.line(one) if isinstance(one, Line) else self.block(one) for one in items)

    def block(self, block: Block) -> Block:
        sections = tuple(Section(self.line(one.header), self.items(one.body)) for one in block.sections)
        return Block(sections, self.line(block.closer) if block.closer is not None else None)


def renumbered(items: Items, before: int = 0) -> tuple[Items, tuple[int, ...]]:
    """Return lines and blocks whose lines are counted on from `before`, and where each of those lies, from 0.

    Blank lines, comments and lines between do not count and change nothing.
    """
    numbering = _Numbering(before, [])
    return numbering.items(items), tuple(numbering.offsets)
