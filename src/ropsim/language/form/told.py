"""The lines of a text as the compiler takes them: what is prose, what is wrong, what is a statement."""

from collections.abc import Iterable, Sequence
from dataclasses import replace

from ropsim.language import misspelt, prose
from ropsim.language.report import Report
from ropsim.language.syntax.statements import Broken, ContractClause, TaskHeader
from ropsim.language.text import Line


def told(lines: Sequence[Line]) -> list[Line]:
    """Return the lines, prose below a contract as clauses of it and misspelt statements as broken ones."""
    names = _task_names(lines)
    mended = list(misspelt.mended(lines, names))
    report = Report("")
    report.muted = True
    kept = {one.logical.number: one for one in prose.absorb(mended, names | _task_names(mended), report)}
    return [_taken(line, kept.get(line.logical.number)) for line in lines]


def _taken(line: Line, kept: Line | None) -> Line:
    if line.statement is None:
        return line
    is_swallowed = kept is None or (isinstance(kept.statement, Broken) and kept.fault is None)
    if kept is None or is_swallowed:
        return replace(line, statement=ContractClause("", line.start, line.end), fault=None)
    return kept


def _task_names(lines: Iterable[Line]) -> frozenset[str]:
    """Return the names of the tasks of a text, also of those whose header is wrong."""
    headers = (one.statement for one in lines if isinstance(one.statement, TaskHeader | Broken))
    return frozenset(
        one.name.text if isinstance(one, TaskHeader) else one.name
        for one in headers
        if isinstance(one, TaskHeader) or (one.head == "task" and one.name)
    )
