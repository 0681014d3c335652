"""One logical line to one statement, or to its fault; it never raises."""

import re
from collections.abc import Sequence
from dataclasses import replace

from ropsim.core import near
from ropsim.language.findings import syntax as kinds
from ropsim.language.syntax.cursor import Cursor
from ropsim.language.syntax.fault import Fault, LineFaultError
from ropsim.language.syntax.lexer import Token, tokens
from ropsim.language.syntax.other_languages import LEFT_OVER
from ropsim.language.syntax.readers.left_over import finish
from ropsim.language.syntax.readers.statement import statement
from ropsim.language.syntax.statements import Broken, ContractClause, Statement
from ropsim.language.syntax.words import HEADS, VERBS

MAX_LENGTH = 2000

ORDINAL = re.compile(r"\s*\d+\.\s+(?=task\b)", re.IGNORECASE)
"""The number before a task in listing style."""
_SPECIAL = re.compile(r"\s*(needs|assumes)\b|" + ORDINAL.pattern, re.IGNORECASE)
"""First words of a line that is a contract, or a task in listing style."""
_HEAD = re.compile(
    r"\s*(?:\d+\.\s+)?([A-Za-z_]\w*)\s*(?:each\s+)?\"?([A-Za-z_]\w*)?", re.ASCII | re.IGNORECASE
)
LOOP_NAME = re.compile(
    r"\s*\w+\s+(?:\w+\s+)?([A-Za-z_]\w*)\s+in\b|\s*\w+\s+([A-Za-z_]\w*)\s*:?=", re.ASCII | re.IGNORECASE
)
"""The variable of a loop, in a line whose first words may be wrong."""

_NEAR = re.compile(r"did you mean `(\w+)`\?")
_COMMENT = re.compile(r"#|//")


def parse_line(line: str) -> tuple[Statement | None, Fault | None]:
    """Return the statement of a logical line (None for an empty one) and its fault.

    The result depends on the characters of the line only; the function never raises.
    """
    if len(line) > MAX_LENGTH:
        shown = f"the line has {len(line)} characters; at most {MAX_LENGTH} are allowed"
        return Broken("", "", 0, 1), Fault(kinds.LINE_LENGTH, 0, 1, shown, "split it")
    special = _SPECIAL.match(line)
    if special and special[1]:
        return _contract(line, special.start(1)), None
    try:
        return _read(line, special.end() if special else 0)
    except LineFaultError as error:
        head = _HEAD.match(line)
        word, name = (head.group(1).lower(), head.group(2) or "") if head else ("", "")
        loop = LOOP_NAME.match(line) if word == "for" else None
        name = next(filter(None, loop.groups()), name) if loop else name
        start = len(line) - len(line.lstrip())
        fault = _confirmed(line, error.fault)
        if not fault.hint and head and word not in HEADS:
            fault = replace(fault, hint=_verb_hint(line, head.span(1)))
        return Broken(word, name, start, len(line.rstrip())), fault


def _read(line: str, start: int) -> tuple[Statement | None, Fault | None]:
    """Return the statement of a line that begins at an offset, and the mended fault."""
    found = tokens(" " * start + line[start:] if start else line)
    if found and found[-1].word == ".":
        found.pop()
    if not found:
        return None, None
    semicolon = _semicolon(found)
    cursor = Cursor(found if semicolon is None else found[:-1], line)
    try:
        result = statement(cursor)
        finish(cursor)
    except LineFaultError as error:
        raise LineFaultError(cursor.mended or error.fault) from None
    return result, cursor.mended or semicolon


def _semicolon(found: Sequence[Token]) -> Fault | None:
    """Return the fault of a `;` at the end of a line, as other languages have it; None where none stands."""
    if len(found) < 2 or found[-1].word != ";":
        return None
    last, sign = found[-2:]
    message = "expected the end of the line, found `;`"
    return Fault(kinds.UNEXPECTED, last.start, sign.end, message, LEFT_OVER[";"], last.text)


def _confirmed(line: str, fault: Fault) -> Fault:
    """Return a fault whose near word is left out where the line with it is wrong at the same place."""
    found = _NEAR.fullmatch(fault.hint)
    if found is None or fault.fix:
        return fault
    word = found[1]
    special = _SPECIAL.match(line)
    try:
        _read(line[: fault.start] + word + line[fault.end :], special.end() if special else 0)
    except LineFaultError as error:
        if error.fault.start <= fault.start + len(word):
            return replace(fault, hint="")
    return replace(fault, fix=word)


def _verb_hint(line: str, place: tuple[int, int]) -> str:
    """Return the near verb with which a line is a statement, in words; empty where none is."""
    begin, end = place
    written, special = line[begin:end], _SPECIAL.match(line)
    for verb in near(written, VERBS):
        try:
            _read(line[:begin] + verb + line[end:], special.end() if special else 0)
        except LineFaultError:
            continue
        return f"with `{verb}` instead of `{written}` the line is a statement"
    return ""


def _contract(line: str, start: int) -> ContractClause:
    comment = _COMMENT.search(line)
    text = (line[: comment.start()] if comment else line).rstrip()
    return ContractClause(text[start:], start, max(len(text), start + 1))
