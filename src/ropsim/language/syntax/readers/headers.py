"""Words of other languages behind the header of a block; the intended header is read nevertheless."""

from ropsim.core import did_you_mean
from ropsim.language.findings import syntax as kinds
from ropsim.language.syntax.cursor import Cursor
from ropsim.language.syntax.fault import Fault, LineFaultError
from ropsim.language.syntax.lexer import UNITS, Token
from ropsim.language.syntax.other_languages import COMPARISONS, END_OF_PROGRAM
from ropsim.language.syntax.other_languages import UNITS as WRITTEN_OUT
from ropsim.language.syntax.statements import Closer
from ropsim.language.syntax.words import ACTIONS, END, OPENERS, RESERVED

_OR_EQUAL = {">": ">=", "<": "<="}
_TIMES = frozenset(("times", "do", "loop", "x"))
"""Words of other languages behind a count."""
_ENDED = {
    **{opener: closers[0] for opener, closers in OPENERS.items()},
    **dict.fromkeys(("proc", "procedure", "function", "func", "sub", "def"), "endp"),
    **dict.fromkeys(("switch", "select", "case"), "endif"),
    "loop": END,
}
"""End of a block, by the word behind `end` in other languages."""


CLOSERS = frozenset(word for words in OPENERS.values() for word in words if word != "until") | {END}
"""Words that end blocks."""


def begins_statement(cursor: Cursor) -> bool:
    """Return whether a statement begins with the next token, by its words."""
    token = cursor.token
    is_assigned = token.kind == "word" and cursor.look(1).word in ("=", ":=") and token.word not in RESERVED
    return token.word in ACTIONS or is_assigned


def then(cursor: Cursor) -> bool:
    """Step over `then`, or read on without it; return whether a statement may follow."""
    if cursor.accept("then"):
        return True
    token = cursor.token
    if token.word in COMPARISONS:
        raise LineFaultError(_comparison(cursor, token))
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


def _comparison(cursor: Cursor, token: Token) -> Fault:
    """Return the fault of a comparison in words, as `greater than or equal to`."""
    here, count = COMPARISONS[token.word], 1
    count += cursor.look(count).word == "than"
    if here in _OR_EQUAL and (cursor.look(count).word, cursor.look(count + 1).word) == ("or", "equal"):
        here, count = _OR_EQUAL[here], count + 2
    count += cursor.look(count).word == "to"
    message = f"expected `then` or the end of the line, found `{token.text}`"
    end = cursor.look(count - 1).end
    return Fault(kinds.UNEXPECTED, token.start, end, message, f"write `{here}`", here)


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
    """Step over `do`, and over statements behind it on the line."""
    _body_below(cursor, "" if cursor.accept("do") else "do", closer)


def repeated(cursor: Cursor) -> None:
    """Step over words behind the count of a `repeat`."""
    token, count = cursor.token, cursor.look(-1)
    if token.word in _TIMES:
        message = f"expected the end of the line, found `{token.text}`"
        hint = f"leave the `{token.text}` out"
        cursor.mend(Fault(kinds.UNEXPECTED, count.start, token.end, message, hint, count.text))
        cursor.go(1)
    _body_below(cursor, "", "endr")


def section_body(cursor: Cursor, closer: str) -> None:
    """Step over statements on the line of a header without `do`."""
    _body_below(cursor, "", closer)


def _body_below(cursor: Cursor, missing: str, closer: str) -> None:
    if not begins_statement(cursor):
        return
    token = cursor.token
    below = "write it on a line of its own"
    hint = f"write `{missing}`, and `{token.text} …` on a line of its own" if missing else below
    expected = f"`{missing}`" if missing else "the end of the line"
    end = _end_behind(cursor)
    message = f"expected {expected}, found `{token.text}`"
    fix, last = missing + f"{cursor.below}  {token.text}", token
    if end is not None:  # it is on the same line
        body = cursor.line[token.start : end.start].rstrip()
        last = cursor.tokens[cursor.length - 1]
        fix = missing + f"{cursor.below}  {body}{cursor.below}{cursor.line[end.start : last.end]}"
    hint = f"{hint}; the block ends with `{closer}`"
    blanks = 0 if missing else token.start - cursor.end  # none are left at the end of the line
    cursor.mend(Fault(kinds.UNEXPECTED, token.start, last.end, message, hint, fix, blanks))
    cursor.go(cursor.length - cursor.index)


def _end_behind(cursor: Cursor) -> Token | None:
    """Return the first word of the end of a block at the end of the line, None where none stands there."""
    before, last = cursor.tokens[cursor.length - 2 : cursor.length]
    if last.word in CLOSERS:
        return last
    return before if before.word == END and last.word in _ENDED else None


def without_end(cursor: Cursor) -> None:
    """Leave out an `endif` or `end if` behind the statement of a one-line `if … then`, which has no end."""
    last, before = cursor.tokens[cursor.length - 1], cursor.tokens[cursor.length - 2]
    if last.word == "endif":
        count = 1
    elif last.word == "if" and before.word == END:
        count = 2
    else:
        return
    first, kept = cursor.tokens[cursor.length - count], cursor.tokens[cursor.length - count - 1]
    if kept.start < cursor.start:
        return
    found = cursor.line[first.start : last.end]
    message = f"expected the end of the line, found `{found}`"
    hint = "remove it: `endif` ends an `if` with lines below"
    before_it = first.start - kept.start
    cursor.mend(Fault(kinds.UNEXPECTED, first.start, last.end, message, hint, kept.text, before_it))
    cursor.leave_out(count)


def ended_again(cursor: Cursor, head: Token) -> None:
    """Leave out the word of a block behind the word that ends it, as in `endif if`."""
    word = cursor.token
    if word.word in _ENDED and cursor.look(1).kind == "end":
        message, hint = f"expected the end of the line, found `{word.text}`", "remove it"
        before = word.start - head.start
        cursor.mend(Fault(kinds.UNEXPECTED, word.start, word.end, message, hint, head.text, before))
        cursor.leave_out(1)


def ended(cursor: Cursor, head: Token) -> Closer | None:
    """Read the end of a block in two words, as `end while`; None if it is something else."""
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
