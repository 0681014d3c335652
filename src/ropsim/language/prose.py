"""Contract clauses: prose after `needs` and `assumes`, and the few words of it that are understood."""

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

from ropsim.flow import GripAction
from ropsim.language.findings import syntax as kinds
from ropsim.language.report import Report
from ropsim.language.syntax.statements import Assign, Broken, Call, ContractClause
from ropsim.language.syntax.words import HEADS, VERBS
from ropsim.language.text import Line

_NUMBERS = {
    word: n
    for n, word in enumerate(
        ["no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten"]
    )
}
_COUNT = r"\b(\d{1,3}|" + "|".join(_NUMBERS) + r")\s+(?:reference\s+|scalar\s+)?"
_LOCATIONS = re.compile(_COUNT + r"locations?\b", re.IGNORECASE)
_PARAMETERS = re.compile(_COUNT + r"parameters?\b", re.IGNORECASE)
_GRIPPER = re.compile(r"\bgripper\s+(?:is\s+|to\s+be\s+)?(open|close)d?\b", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class Clause:
    """What is understood of a contract clause.

    Attributes:
        text: all its words on one line.
        gripper: state the gripper must have, or None.
        locations: number of reference locations, or None.
        parameters: number of scalar parameters, or None.
    """

    text: str
    gripper: GripAction | None
    locations: int | None
    parameters: int | None


def understand(text: str) -> Clause:
    """Return what a contract clause says; words that are not understood are documentation."""
    words = " ".join(text.split())
    gripper = _GRIPPER.search(words)
    action = GripAction(gripper.group(1).lower()) if gripper else None
    return Clause(words, action, _count(_LOCATIONS, words), _count(_PARAMETERS, words))


def absorb(lines: Iterable[Line], task_names: frozenset[str], report: Report) -> Iterator[Line]:
    """Yield the lines with prose lines joined to their clause; report the faults of all others.

    A clause runs on until a full stop at the end of a line, a line that starts with a statement word, an
    assignment, a header in listing style, or the call of a known task. A prose line that looks like a
    misspelt statement is kept as a broken one as well, so that nobody draws conclusions from its absence.
    """
    clause: Line | None = None
    swallowed: list[Line] = []
    for line in lines:
        statement = line.statement
        if isinstance(statement, ContractClause):
            if clause:
                yield clause
            clause = line
        elif clause and statement is not None and _is_prose(line, task_names) and _is_open(clause):
            if _warned(line, task_names, report):
                swallowed.append(replace(line, statement=Broken("", "", line.start, line.end)))
            clause = _joined(clause, line)
        elif statement is not None:
            if clause:
                yield clause
                yield from swallowed
                clause, swallowed = None, []
            if line.fault:
                fault = line.fault
                report.at(fault.kind, line, fault, fault.message, fault.hint)
            yield line
    if clause:
        yield clause
        yield from swallowed


def _is_open(clause: Line) -> bool:
    assert isinstance(clause.statement, ContractClause)
    return not clause.statement.text.endswith(".")


def _is_prose(line: Line, task_names: frozenset[str]) -> bool:
    match line.statement:
        case Broken(head=head):
            return head not in HEADS and re.match(r"\w+\s*:?=", line.logical.text.strip()) is None
        case Call(name=name):
            return name.text not in task_names and line.head != "call"
        case Assign():
            return False
    return False


def _joined(clause: Line, line: Line) -> Line:
    assert isinstance(clause.statement, ContractClause)
    text = clause.statement.text + " " + re.split(r"#|//", line.logical.text)[0].strip()
    return replace(clause, statement=replace(clause.statement, text=text))


def _warned(line: Line, task_names: frozenset[str], report: Report) -> bool:
    """Return whether a line looks like a misspelt statement, which is then reported."""
    if not isinstance(line.statement, Call):
        return False
    name = line.statement.name
    near = [word for word in (*VERBS, *sorted(task_names)) if _is_near(name.text.lower(), word.lower())]
    if near:
        message = f"`{name.text}` was read as prose of the contract above"
        hint = f"did you mean `{near[0]}`? else end the prose above with a full stop"
        report.at(kinds.PROSE, line, name, message, hint, fix=near[0])
    return bool(near)


def _is_near(a: str, b: str) -> bool:
    return (
        abs(len(a) - len(b)) <= 1 and 3 <= len(a) <= 32 and edit_distance(a, b) <= (1 if len(b) <= 4 else 2)
    )


def edit_distance(a: str, b: str) -> int:
    """Return the number of insertions, deletions, replacements and neighbour swaps between two words.

    References:
        F. J. Damerau, A technique for computer detection and correction of spelling errors, 1964
        (restricted form: no part is edited twice).
    """
    before: list[int] = []
    last = list(range(len(b) + 1))
    for i, x in enumerate(a, 1):
        row = [i]
        for j, y in enumerate(b, 1):
            cost = min(last[j] + 1, row[j - 1] + 1, last[j - 1] + (x != y))
            if i > 1 and j > 1 and x == b[j - 2] and a[i - 2] == y:
                cost = min(cost, before[j - 2] + 1)
            row.append(cost)
        before, last = last, row
    return last[-1]


def _count(pattern: re.Pattern[str], text: str) -> int | None:
    match = pattern.search(text)
    if not match:
        return None
    word = match.group(1).lower()
    return int(word) if word.isdigit() else _NUMBERS[word]
