"""First words that are misspelt, where the intended word is certain: the line keeps its role."""

import re
from collections import Counter
from collections.abc import Container, Iterable, Iterator, Sequence
from dataclasses import replace

from ropsim.core import edit_distance
from ropsim.language.blocks.block_ends import ANY, STEERING, closed, opened
from ropsim.language.findings import names as kinds
from ropsim.language.syntax.fault import Fault
from ropsim.language.syntax.line import LOOP_NAME
from ropsim.language.syntax.other_languages import ENDS
from ropsim.language.syntax.statements import Broken, Call
from ropsim.language.syntax.text import Line
from ropsim.language.syntax.words import END, HEADS, OPENERS

_DOUBTFUL = frozenset({Call, Broken})
"""Statements whose first word may be a misspelt one."""
_CLOSES = {word: opener for opener, words in OPENERS.items() for word in words}
_DECLARATIONS = ("frame", "loc", "tool", "signal", "const", "var", "pattern")
_DECLARED = re.compile(r"\s*\w+\s+([A-Za-z_]\w*)\s*(?::\s*\w+\s*)?:?=(?!=)", re.ASCII)
_ASSIGNED = re.compile(r"\s*\w+\s*:?=", re.ASCII)
_SECOND = re.compile(r"\s*\w+\s+\"?([A-Za-z_]\w*)", re.ASCII)


def ends_of(lines: Iterable[Line]) -> Counter[str]:
    """Return how many more ends than beginnings of blocks there are, by the word that opens them."""
    ends: Counter[str] = Counter()
    for line in lines:
        if type(line.statement) not in STEERING:
            continue
        if word := closed(line):
            ends[word] += 1
        if word := opened(line):
            ends[word] -= 1
    return ends


def foreign(lines: Iterable[Line], task_names: Container[str]) -> bool:
    """Return whether some line begins with a word that is no statement and no task that can be called."""
    return any(_foreign(line, task_names) for line in lines if type(line.statement) in _DOUBTFUL)


def mended(lines: Sequence[Line], task_names: Container[str], ends: Counter[str]) -> Iterator[Line]:
    """Yield the lines; one whose first word is misspelt is a broken statement of the word that was meant.

    A word near to an opener is one where the text has more ends than beginnings of blocks of this kind, a
    word near to an end the other way round, and one near to a declaration where a name and `=` follow.

    Args:
        lines: of the text.
        task_names: of all tasks that can be called.
        ends: `ends_of` the whole text; mended words are included.
    """
    for line in lines:
        word = _foreign(line, task_names)
        meant = _meant(line, word.lower(), ends) if word else ""
        if not meant:
            yield line
            continue
        if meant in OPENERS:
            ends[meant] -= 1
        elif meant in _CLOSES:
            ends[_CLOSES[meant]] += 1
        elif meant == END:
            ends[ANY] += 1
        message, hint = f"Task not defined: `{word}`", f"did you mean `{meant}`?"
        fault = Fault(kinds.UNKNOWN_TASK, line.start, line.start + len(word), message, hint, meant)
        yield replace(line, statement=Broken(meant, _name(line, meant), line.start, line.end), fault=fault)


def _foreign(line: Line, task_names: Container[str]) -> str:
    """Return the first word of a line that is neither a statement nor the call of a known task."""
    text, statement = line.logical.text, line.statement
    match statement:
        case Call(name=name) if name.start == statement.start and name.text not in task_names:
            return name.text
        case Broken(head=head) if line.fault and head and head not in HEADS and not _ASSIGNED.match(text):
            word = text[line.start : line.start + len(head)]
            return word if word.lower() == head and word not in task_names else ""
    return ""


def _meant(line: Line, word: str, ends: Counter[str]) -> str:
    """Return the intended word, empty if the text does not determine it."""
    if word in ENDS and line.logical.text[line.start : line.end].strip().lower() == word:
        return ENDS[word]
    spare = ends[ANY] + sum(min(ends[one], 0) for one in OPENERS)  # of the `end`s that close any block
    words = [one for one in OPENERS if ends[one] > 0 or spare > 0]
    words += [one for one, opener in _CLOSES.items() if ends[opener] < 0 and spare < 0]
    words += [END] if spare < 0 and line.logical.text.strip().lower() == word else ()
    words += _DECLARATIONS if _DECLARED.match(line.logical.text) else ()
    return min(
        (one for one in words if _is_near(word, one)), key=lambda one: edit_distance(word, one), default=""
    )


def _is_near(word: str, other: str) -> bool:
    if not 2 <= len(word) <= 12 or abs(len(word) - len(other)) > 2:
        return False
    return edit_distance(word, other) <= (1 if len(other) <= 4 else 2)


def _name(line: Line, meant: str) -> str:
    """Return the name that the statement defines."""
    text = line.logical.text
    found = (LOOP_NAME if meant == "for" else _SECOND).match(text)
    return next(filter(None, found.groups()), "") if found else ""
