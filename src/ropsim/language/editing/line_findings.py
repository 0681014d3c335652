"""What is wrong with single lines of a text, without a look at the others; that takes little time."""

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
"""Findings that are told at most."""


def line_findings(source: SourceText, cache: Parser) -> tuple[Diagnostic, ...]:
    """Return the first findings that lines have by themselves, in order; the whole text has them, too.

    Their hints may be more exact there. In a classic text nothing is told: what is prose in it, and no
    statement, depends on its tasks.

    Args:
        source: any text.
        cache: may keep what lines were parsed to.
    """
    lines = placed(texts.read(source, cache))
    return () if is_classic(modes(lines)) else tuple(islice(_found(source, lines), MOST))


def _found(source: SourceText, lines: tuple[texts.Line, ...]) -> Iterator[Diagnostic]:
    for line in lines:
        fault = line.fault
        if fault is not None and not isinstance(line.statement, ContractClause | None):
            yield finding_of(line, fault, source.name)
