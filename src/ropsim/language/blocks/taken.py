"""The lines of a whole text as the compiler takes them: prose in its clause, misspelt words mended."""

from collections.abc import Iterable, Sequence
from dataclasses import replace

from ropsim.language.blocks import misspelt, prose
from ropsim.language.report import Report
from ropsim.language.syntax.statements import Broken, ContractClause, TaskHeader
from ropsim.language.syntax.text import Line


def taken(lines: Sequence[Line]) -> tuple[Line, ...]:
    """Return the lines, prose below a contract as part of its clause, misspelt statements as broken ones."""
    names, report = task_names(lines), Report("")
    report.muted = True
    mended = list(misspelt.mended(lines, names, misspelt.ends_of(lines)))
    is_classic = prose.is_classic(prose.modes(lines))
    manner = prose.Manner(is_classic, is_classic)
    return prose.absorb(mended, names | task_names(mended), report, manner)[0]


def task_names(lines: Iterable[Line]) -> frozenset[str]:
    """Return the names of the tasks of some lines, including tasks with a wrong header."""
    found = set()
    for line in lines:
        match line.statement:
            case TaskHeader(name=name):
                found.add(name.text)
            case Broken(head="task", name=name) if name:
                found.add(name)
    return frozenset(found)


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
