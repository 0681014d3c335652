"""What stands behind the header of a block and belongs elsewhere; what was meant is read all the same."""

from ropsim.core import did_you_mean
from ropsim.language.findings import syntax as kinds
from ropsim.language.syntax.cursor import Cursor
from ropsim.language.syntax.fault import Fault, LineFaultError
from ropsim.language.syntax.lexer import UNITS, Token
from ropsim.language.syntax.other_languages import COMPARISONS, END_OF_PROGRAM
from ropsim.language.syntax.other_languages import UNITS as WRITTEN_OUT
from ropsim.language.syntax.statements import Closer
from ropsim.language.syntax.words import ACTIONS, END, OPENERS, RESERVED

_TIMES = frozenset(("times", "do", "loop", "x"))
"""What stands behind a count elsewhere."""
_ENDED = {
    **{opener: closers[0] for opener, closers in OPENERS.items()},
    **dict.fromkeys(("proc", "procedure", "function", "func", "sub", "def"), "endp"),
    **dict.fromkeys(("switch", "select", "case"), "endif"),
    "loop": END,
}
"""What ends a block, by the word that stands behind `end` elsewhere."""


def begins_statement(cursor: Cursor) -> bool:
    """Return whether a statement begins with the next token, as far as its words tell."""
    token = cursor.token
    is_assigned = token.kind == "word" and cursor.look(1).word in ("=", ":=") and token.word not in RESERVED
    return token.word in ACTIONS or is_assigned


def then(cursor: Cursor) -> bool:
    """Step over `then`, or read on without it; return whether a statement may follow."""
    if cursor.accept("then"):
        return True
    token = cursor.token
    if token.word in COMPARISONS:
        here = COMPARISONS[token.word]
        raise LineFaultError(cursor.unexpected("`then` or the end of the line", f"write `{here}`", here))
    if begins_statement(cursor) or names_task(cursor):
        cursor.mend(cursor.unexpected("`then`", "write `then`", f"then {token.text}"))
        return True
    if token.word == "do" or (token.kind == "word" and did_you_mean(token.text, ("then",))):
        hint = "write `then`" if token.word == "do" else "did you mean `then`?"
        cursor.mend(cursor.unexpected("`then`", hint, "then"))
        cursor.go(1)
        return True
    if token.kind == "word" and token.word not in RESERVED and not _is_unit(cursor):
        cursor.fail(
            "`then` or the end of the line", "a statement on the line of an `if` stands behind `then`"
        )
    return False


def names_task(cursor: Cursor) -> bool:
    """Return whether the next token has the capital letter of the name of a task."""
    text = cursor.token.text
    is_name = cursor.token.kind == "word" and cursor.word not in RESERVED and not text.isupper()
    return is_name and text[:1].isupper() and not _is_unit(cursor)


def _is_unit(cursor: Cursor) -> bool:
    """Return whether the next token was meant as the unit of the number before it."""
    token = cursor.token
    is_alike = token.word in WRITTEN_OUT or bool(did_you_mean(token.text, UNITS))
    return cursor.look(-1).kind == "number" and is_alike


def loop_body(cursor: Cursor, closer: str) -> None:
    """Step over `do`, and over what is done where it stands behind it on the line."""
    _body_below(cursor, "" if cursor.accept("do") else "do", closer)


def repeated(cursor: Cursor) -> None:
    """Step over what stands behind the count of a `repeat`."""
    token, count = cursor.token, cursor.look(-1)
    if token.word in _TIMES:
        message = f"expected the end of the line, found `{token.text}`"
        hint = f"leave the `{token.text}` out"
        cursor.mend(Fault(kinds.UNEXPECTED, count.start, token.end, message, hint, count.text))
        cursor.go(1)
    _body_below(cursor, "", "endr")


def section_body(cursor: Cursor, closer: str) -> None:
    """Step over what is done where it stands on the line of a header without `do`."""
    _body_below(cursor, "", closer)


def _body_below(cursor: Cursor, missing: str, closer: str) -> None:
    if not begins_statement(cursor):
        return
    token = cursor.token
    below = "write it on a line of its own"
    hint = f"write `{missing}`, and `{token.text} …` on a line of its own" if missing else below
    expected = f"`{missing}`" if missing else "the end of the line"
    fix = missing + f"{cursor.below}  {token.text}"
    cursor.mend(cursor.unexpected(expected, f"{hint}; the block ends with `{closer}`", fix))
    cursor.go(cursor.length - cursor.index)


def ended(cursor: Cursor, head: Token) -> Closer | None:
    """Read what ends a block in two words, as `end while`; None where it is something else."""
    kind = cursor.token
    if kind.word in ("program", "module") and cursor.look(1).kind == "end":
        cursor.fail("the end of the line", END_OF_PROGRAM)
    closer = _ENDED.get(kind.word)
    if closer is None or cursor.look(1).kind != "end":
        return None
    cursor.advance()
    hint = f"write `{closer}`" if closer == END else f"write `{closer}`, or `{END}` alone"
    message = f"expected the end of the line, found `{kind.text}`"
    cursor.mend(Fault(kinds.UNEXPECTED, head.start, kind.end, message, hint, closer))
    return Closer(closer, head.start, cursor.end)
