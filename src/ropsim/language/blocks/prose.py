"""Contract clauses: prose after `needs` and `assumes`, and where it ends."""

import re
from collections.abc import Collection, Iterable, Iterator
from dataclasses import replace
from types import NoneType

from ropsim.core import edit_distance, frozen_dataclass
from ropsim.language.findings import syntax as kinds
from ropsim.language.report import Report, finding_of
from ropsim.language.syntax.fault import Fault
from ropsim.language.syntax.line import parse_line
from ropsim.language.syntax.nodes import Binary, External, Free, Function, Item, Member, Name, Rebase, Tuple
from ropsim.language.syntax.other_languages import HINTS
from ropsim.language.syntax.statements import (
    Broken,
    Call,
    Closer,
    ContractClause,
    Mode,
    ProgramHeader,
    TaskHeader,
)
from ropsim.language.syntax.text import Line
from ropsim.language.syntax.words import END, HEADS, VERBS

_DOUBTFUL = frozenset({ContractClause, Broken, NoneType})
"""Statement of a line that is prose, continues prose or is marked as a statement."""
_COMMENT = re.compile(r"#|//")
_INSIDE = re.compile(r"\b(speed|acc|blend|fine|above|offset|rel|external|until|via|to|then)\b|[(=]")
"""Words and signs inside of statements."""
_FULL_STOP = re.compile(r"(?<!\d)\.\s+(?=\S)|(?<=\d)\.\s+(?=\D)")
_ASSIGNED = re.compile(r"\s*[\w.]+\s*:?=")


@frozen_dataclass
class Manner:
    """How contracts are read where a part of a text begins.

    Attributes:
        is_classic: whether the text is a classic one, as far as its lines show.
        runs_on: whether a clause may go on in the next lines.
    """

    is_classic: bool
    runs_on: bool


def absorb(
    lines: Iterable[Line], task_names: Collection[str], report: Report, manner: Manner
) -> tuple[tuple[Line, ...], Manner]:
    """Return the lines, and how contracts are read behind them."""
    read = list(lines)
    heads = [line.statement for line in read if isinstance(line.statement, TaskHeader)]
    runs_on = _runs_on(heads[-1], manner) if heads else manner.runs_on
    is_doubtful = any(line.fault is not None or type(line.statement) in _DOUBTFUL for line in read)
    absorbed = tuple(_absorbed(read, task_names, report, manner) if is_doubtful else read)
    return absorbed, manner if manner.runs_on is runs_on else replace(manner, runs_on=runs_on)


def _runs_on(header: TaskHeader, manner: Manner) -> bool:
    return manner.is_classic and header.parameters is None


def _absorbed(
    read: list[Line], task_names: Collection[str], report: Report, manner: Manner
) -> Iterator[Line]:
    """Yield the lines with prose lines joined to their clause; report the faults of all others.

    In a task of a classic text without parameter list a clause runs on until a full stop at the end of a
    line, a line that starts with a statement word, an assignment, a header in listing style, or the call of a
    known task. Everywhere else it ends with its line, so that no statement below can be taken for prose. A
    prose line that looks like a misspelt statement is kept as a broken one as well, so that no finding
    follows from its absence.
    """
    runs_on = manner.runs_on
    clause: Line | None = None
    swallowed: list[Line] = []
    for line in read:
        statement = line.statement
        if isinstance(statement, TaskHeader):
            runs_on = _runs_on(statement, manner)
        if isinstance(statement, ContractClause):
            if clause:
                yield clause
            clause = line
            _check_behind(line, task_names, report)
        elif (
            clause and runs_on and statement is not None and _is_prose(line, task_names) and _is_open(clause)
        ):
            if _warned(line, task_names, report):
                swallowed.append(replace(line, statement=Broken("", "", line.start, line.end), fault=None))
            _check_behind(line, task_names, report)
            clause = _joined(clause, line)
        elif statement is not None:
            if line.fault:
                fault = line.fault
                is_prose = clause and not runs_on and _is_prose(line, task_names)
                hint = _ENDS if is_prose else _hint(line, fault, task_names)
                fix = fault.fix if hint == fault.hint else ""
                report.add(finding_of(line, replace(fault, hint=hint, fix=fix), report.source))
            if clause:
                yield clause
                yield from swallowed
                clause, swallowed = None, []
            yield line
    if clause:
        yield clause
        yield from swallowed


_ENDS = "a contract ends with its line: begin the next line of it with `needs`, or `#` for a comment"


def modes(lines: Iterable[Line]) -> frozenset[str]:
    """Return which of `classic`, `strict` and `program` some lines say."""
    return frozenset(
        line.statement.word if isinstance(line.statement, Mode) else "program"
        for line in lines
        if isinstance(line.statement, Mode | ProgramHeader)
    )


def is_classic(modes: Collection[str]) -> bool:
    """Return whether a text that says so is a classic one."""
    return "classic" in modes or not ("strict" in modes or "program" in modes)


def _check_behind(line: Line, task_names: Collection[str], report: Report) -> None:
    """Report a statement that stands behind the full stop of a contract on its line."""
    text = _COMMENT.split(line.logical.text)[0]
    for stop in _FULL_STOP.finditer(text):
        rest = text[stop.end() :]
        statement, fault = parse_line(rest)
        is_sentence = rest[:1].isupper() and not rest.split()[0].isupper()
        if fault or statement is None or is_sentence or isinstance(statement, Broken | ContractClause):
            continue
        if isinstance(statement, Call) and statement.name.text not in task_names:
            continue
        place = Broken("", "", stop.end(), len(text.rstrip()))
        message = f"`{rest.strip()[:40]}` stands behind a contract on its line and would not be carried out"
        report.at(kinds.BEHIND_CONTRACT, line, place, message, "write it on a line of its own")
        return


def _hint(line: Line, fault: Fault, task_names: Collection[str]) -> str:
    """Return the hint of a fault; for a word of another language, its equivalent here."""
    head = line.head
    is_own = _ASSIGNED.match(line.logical.text) or head in map(str.lower, task_names)
    is_told = fault.fix or (head == END and fault.hint)  # the words behind it lead to a better hint
    is_foreign = fault.kind is kinds.UNEXPECTED and head in HINTS and not is_own
    return HINTS[head] if is_foreign and not is_told else fault.hint


def _is_open(clause: Line) -> bool:
    assert isinstance(clause.statement, ContractClause)
    return not clause.statement.text.endswith(".")


def _is_prose(line: Line, task_names: Collection[str]) -> bool:
    match line.statement:
        case Broken(head=head):
            return head not in HEADS and _ASSIGNED.match(line.logical.text) is None
        case Call(name=name):
            return name.text not in task_names and line.head != "call"
        case Closer(word=word):
            return word == END
    return False


def _joined(clause: Line, line: Line) -> Line:
    assert isinstance(clause.statement, ContractClause)
    text = clause.statement.text + " " + re.split(r"#|//", line.logical.text)[0].strip()
    return replace(clause, statement=replace(clause.statement, text=text))


def _warned(line: Line, task_names: Collection[str], report: Report) -> bool:
    """Return whether a line looks like a statement, which is then reported."""
    name, is_computed = _reading(line)
    if name is None:
        return False
    near = [word for word in (*VERBS, *sorted(task_names)) if _is_near(name.text.lower(), word.lower())]
    message = f"`{name.text}` was read as prose of the contract above"
    if near:
        hint = f"did you mean `{near[0]}`? else end the prose above with a full stop"
        report.at(kinds.PROSE, line, name, message, hint, fix=near[0])
        return True
    if is_computed:
        report.at(
            kinds.PROSE, line, name, message, "define the task, or end the prose above with a full stop"
        )
    return is_computed


def _reading(line: Line) -> tuple[Name | None, bool]:
    """Return the first word of a prose line that may be a statement, and whether it can hardly be prose."""
    match line.statement:
        case Closer(word=word, start=start):
            return Name(line.logical.text[start : start + len(word)], start, start + len(word)), True
        case Call(name=name, arguments=arguments):
            return name, any(map(_is_computed, arguments))
        case Broken(head=head, start=start) if head and _INSIDE.search(line.logical.text):
            return Name(line.logical.text[start : start + len(head)], start, start + len(head)), False
    return None, False


def _is_computed(item: Item) -> bool:
    """Return whether an argument is one that prose does not have, such as `l above 20` and `n = 3`."""
    value = item.value
    if isinstance(value, Binary):
        return value.op not in ("and", "or")
    return item.name is not None or isinstance(value, Tuple | Rebase | External | Free | Member | Function)


def _is_near(a: str, b: str) -> bool:
    return (
        abs(len(a) - len(b)) <= 1 and 3 <= len(a) <= 32 and edit_distance(a, b) <= (1 if len(b) <= 4 else 2)
    )
