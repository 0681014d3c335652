"""Findings in single lines of a text, without regard to other lines; fast."""

from collections.abc import Iterator
from itertools import islice

from ropsim.core import Diagnostic, SourceText
from ropsim.language.blocks.prose import is_classic, modes
from ropsim.language.blocks.then_bodies import placed
from ropsim.language.report import finding_of
from ropsim.language.syntax import text as texts
from ropsim.language.syntax.statements import ContractClause
from ropsim.language.syntax.text import Parser

MOST = 100
"""Maximum number of findings."""


def line_findings(source: SourceText, cache: Parser) -> tuple[Diagnostic, ...]:
    """Return the first findings of single lines, in order; the whole text has them also.

    Their hints may be more exact there. A classic text has none: its tasks determine which lines are prose.

    Args:
        source: any text.
        cache: may keep parsed lines.
    """
    lines = placed(texts.read(source, cache))
    return () if is_classic(modes(lines)) else tuple(islice(_found(source, lines), MOST))


def _found(source: SourceText, lines: tuple[texts.Line, ...]) -> Iterator[Diagnostic]:
    for line in lines:
        fault = line.fault
        if fault is not None and not isinstance(line.statement, ContractClause | None):
            yield finding_of(line, fault, source.name)
