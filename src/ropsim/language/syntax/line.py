"""One logical line to one statement: the table of statements and the rules around it."""

import re
from collections.abc import Callable

from ropsim.core import did_you_mean
from ropsim.language.findings import syntax as kinds
from ropsim.language.syntax import declarations, flow, motion
from ropsim.language.syntax.cursor import Cursor
from ropsim.language.syntax.fault import Fault, LineFaultError
from ropsim.language.syntax.lexer import Token, tokens
from ropsim.language.syntax.statements import Broken, ContractClause, Statement
from ropsim.language.syntax.words import NOT_YET, RESERVED, VERBS

MAX_LENGTH = 2000

_STATEMENTS: dict[str, Callable[[Cursor, Token], Statement]] = {
    "program": declarations.program,
    "units": declarations.units,
    "classic": declarations.mode,
    "strict": declarations.mode,
    "frame": declarations.frame,
    "loc": declarations.location,
    "tool": declarations.tool,
    "signal": declarations.signal,
    "const": declarations.constant,
    "var": declarations.variable,
    "pattern": declarations.pattern,
    "task": declarations.task,
    "mov": motion.motion,
    "movj": motion.motion,
    "lin": motion.motion,
    "movl": motion.motion,
    "open": motion.gripper,
    "close": motion.gripper,
    "load": motion.load,
    "set": motion.set_statement,
    "with": motion.with_statement,
    "wait": flow.wait,
    "if": flow.if_statement,
    "elseif": flow.elseif,
    "else": flow.else_statement,
    "while": flow.while_statement,
    "repeat": flow.repeat,
    "until": flow.until,
    "for": flow.for_statement,
    "break": flow.jump,
    "continue": flow.jump,
    "return": flow.return_statement,
    "stop": flow.stop,
    "print": flow.print_statement,
    "call": flow.call,
    **dict.fromkeys(("endp", "endtask", "endr", "endif", "endw", "endf", "endwith"), flow.closer),
}
_CONTRACT = re.compile(r"\s*(needs|assumes)\b", re.IGNORECASE)
_ORDINAL = re.compile(r"\s*\d+\.\s+(?=task\b)", re.IGNORECASE)
_HEAD = re.compile(
    r"\s*(?:\d+\.\s+)?([A-Za-z_]\w*)\s*(?:each\s+)?\"?([A-Za-z_]\w*)?", re.ASCII | re.IGNORECASE
)
_COMMENT = re.compile(r"#|//")


def parse_line(line: str) -> tuple[Statement | None, Fault | None]:
    """Return the statement of a logical line (None for an empty one) and what is wrong with it.

    The result depends on the characters of the line only; the function never raises.
    """
    if len(line) > MAX_LENGTH:
        shown = f"the line has {len(line)} characters; at most {MAX_LENGTH} are allowed"
        return Broken("", "", 0, 1), Fault(kinds.LINE_LENGTH, 0, 1, shown, "split it")
    contract = _CONTRACT.match(line)
    if contract:
        return _contract(line, contract.start(1)), None
    try:
        return _read(line), None
    except LineFaultError as error:
        head = _HEAD.match(line)
        word, name = (head.group(1).lower(), head.group(2) or "") if head else ("", "")
        start = len(line) - len(line.lstrip())
        return Broken(word, name, start, len(line.rstrip())), error.fault


def statement(cursor: Cursor) -> Statement:
    """Read one statement from the cursor on."""
    token = cursor.token
    if token.kind != "word":
        cursor.fault(
            kinds.STATEMENT_START,
            token.start,
            max(token.end, token.start + 1),
            f"a statement cannot start with `{token.text[:40]}`",
            "start with a statement word, a task or a variable",
        )
    reader = _STATEMENTS.get(token.word)
    if reader is not None:
        if cursor.look(1).word in ("=", ":="):
            hint = f"`{token.text}` is a word of the language; choose another name for the variable"
            cursor.fault(
                kinds.STATEMENT_START, token.start, token.end, f"`{token.text}` cannot be assigned", hint
            )
        cursor.advance()
        return reader(cursor, token)
    if token.word in NOT_YET:
        cursor.not_yet(token, token.word)
    if token.word in RESERVED:
        hint = did_you_mean(token.text, VERBS) or "this word belongs inside a statement"
        cursor.fault(
            kinds.STATEMENT_START,
            token.start,
            token.end,
            f"a statement cannot start with `{token.text}`",
            hint,
        )
    return flow.plain(cursor)


def _read(line: str) -> Statement | None:
    ordinal = _ORDINAL.match(line)
    found = tokens(" " * ordinal.end() + line[ordinal.end() :] if ordinal else line)
    if found and found[-1].word == ".":
        found.pop()
    if not found:
        return None
    cursor = Cursor(found, line)
    result = statement(cursor)
    cursor.finish()
    return result


def _contract(line: str, start: int) -> ContractClause:
    comment = _COMMENT.search(line)
    text = (line[: comment.start()] if comment else line).rstrip()
    return ContractClause(text[start:], start, max(len(text), start + 1))
