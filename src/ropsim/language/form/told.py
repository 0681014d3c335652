"""The lines of a text as the compiler takes them: what is prose, what is wrong, what is a statement."""

from collections.abc import Sequence
from dataclasses import replace

from ropsim.language.syntax.statements import Broken, ContractClause
from ropsim.language.taken import taken
from ropsim.language.text import Line


def told(lines: Sequence[Line]) -> list[Line]:
    """Return the lines, prose below a contract as clauses of it and misspelt statements as broken ones."""
    kept = {one.logical.number: one for one in taken(lines)}
    return [_taken(line, kept.get(line.logical.number)) for line in lines]


def _taken(line: Line, kept: Line | None) -> Line:
    if line.statement is None:
        return line
    is_swallowed = kept is None or (isinstance(kept.statement, Broken) and kept.fault is None)
    if kept is None or is_swallowed:
        return replace(line, statement=ContractClause("", line.start, line.end), fault=None)
    return kept
