"""A text to the uses of its names; its statements as the compiler takes them."""

from ropsim.core import SourceText
from ropsim.language.blocks import matching as blocks
from ropsim.language.blocks.matching import Block
from ropsim.language.blocks.taken import taken
from ropsim.language.cache import LineCache
from ropsim.language.check.calls.tasks import is_task
from ropsim.language.editing.uses import Uses, in_order
from ropsim.language.editing.uses_walk import Scope, Walk, with_ends
from ropsim.language.report import Report
from ropsim.language.syntax import statements as syntax
from ropsim.language.syntax.text import MAX_LINES, Line, read


def uses_of(source: SourceText, cache: LineCache, outside: frozenset[str] = frozenset()) -> Uses:
    """Return the uses of all names of a text; every text has some or none.

    Args:
        source: the text.
        cache: parsed lines.
        outside: names of the cell; in a classic task every other one that is read first is an implicit
            parameter.
    """
    if len(source.lines) > MAX_LINES:
        return Uses()
    tree = blocks.build(statements_of(source, cache), _silent(source)).items
    top = [item for item in tree if isinstance(item, Line)]
    modes = {line.statement.word for line in top if isinstance(line.statement, syntax.Mode)}
    is_modern = "strict" in modes or any(isinstance(line.statement, syntax.ProgramHeader) for line in top)
    walk = Walk(source.name, outside)
    walk.is_classic = "classic" in modes or not is_modern
    walk.declare(top)
    for item in tree:
        if isinstance(item, Block):
            walk.header(item.opener)
    main = Scope("", is_outside=True)
    for item, end in with_ends(tree):
        if isinstance(item, Block) and is_task(item):
            walk.task(item, end)
        else:
            walk.items((item,), main, end)
    walk.close(main)
    return Uses(
        tuple(in_order(walk.found)),
        tuple(walk.sights),
        tuple(walk.broken),
        tuple(walk.tasks),
        tuple(walk.rooms),
        tuple(walk.blocks),
        walk.is_classic,
    )


def statements_of(source: SourceText, cache: LineCache) -> list[Line]:
    """Return the statements as the compiler takes them: prose in its clause, misspelt words mended."""
    return list(taken(list(read(source, cache))))


def _silent(source: SourceText) -> Report:
    report = Report(source.name)
    report.muted = True
    return report
