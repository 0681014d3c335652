"""The lines of a whole text as the compiler takes them: prose in its clause, misspelt words mended."""

from collections.abc import Iterable, Sequence

from ropsim.language import misspelt, prose
from ropsim.language.report import Report
from ropsim.language.syntax.statements import Broken, TaskHeader
from ropsim.language.text import Line


def taken(lines: Sequence[Line]) -> tuple[Line, ...]:
    """Return the lines, prose below a contract as part of its clause, misspelt statements as broken ones."""
    names, report = task_names(lines), Report("")
    report.muted = True
    mended = list(misspelt.mended(lines, names, misspelt.ends_of(lines)))
    is_classic = prose.is_classic(prose.modes(lines))
    manner = prose.Manner(is_classic, is_classic)
    return prose.absorb(mended, names | task_names(mended), report, manner)[0]


def task_names(lines: Iterable[Line]) -> frozenset[str]:
    """Return the names of the tasks of some lines, also of those whose header is wrong."""
    found = set()
    for line in lines:
        match line.statement:
            case TaskHeader(name=name):
                found.add(name.text)
            case Broken(head="task", name=name) if name:
                found.add(name)
    return frozenset(found)
