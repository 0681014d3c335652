"""Text behind the end of a statement, and the hint for it."""

from collections.abc import Mapping

from ropsim.core import did_you_mean, edit_distance
from ropsim.language.findings import syntax as kinds
from ropsim.language.syntax.cursor import Cursor
from ropsim.language.syntax.fault import Fault, LineFaultError
from ropsim.language.syntax.lexer import UNITS, Token
from ropsim.language.syntax.other_languages import DECIMAL, LEFT_OVER
from ropsim.language.syntax.other_languages import UNITS as WRITTEN_OUT
from ropsim.language.syntax.other_settings import meant
from ropsim.language.syntax.readers.headers import CLOSERS, begins_statement, names_task
from ropsim.language.syntax.words import ACTIONS, END, INSIDE, MOTIONS, NOT_YET_MODIFIERS, RESERVED, SETTINGS

_POSTURE_WORDS = {"config": "(left, up)", "turns": "(0, -1)"}
"""Terms of a location that users write behind it; each with an example."""
_TELLING = 3
"""Letters of a unit from which on a longer word may begin with it, as "degs" does."""
_BEHIND_TARGETS = frozenset(SETTINGS) - {"frame"} | {"angle", "at", "until", "store", "track"}
_HOLDING = frozenset(("if", "elseif", "else", "wait"))
"""Words that execute a statement on their line: whether they include the next one is ambiguous."""
_WORDS: Mapping[str, str] = {
    "else": "an `else` stands on a line of its own: `if … then`, below it `else`, below that `endif`",
    "then": "leave the `then` out",
    "do": "leave the `do` out",
}
"""Hints for words that belong to other statements."""


def finish(cursor: Cursor) -> None:
    """Make sure that nothing is left over."""
    if not cursor.at_end:
        _refuse(cursor)


def _refuse(cursor: Cursor) -> None:
    token, head = cursor.token, cursor.tokens[0]
    if token.word in _POSTURE_WORDS:
        hint = f"write `(x, y, z; {token.word} {_POSTURE_WORDS[token.word]})`"
        message = f"`{token.word}` stands in a location, behind its `;`"
        cursor.fault(kinds.UNEXPECTED, token.start, token.end, message, hint)
    settings = _setting_of_other_languages, _second_setting
    for reader in (_semicolon, _end, _decimal, *settings, _comma, _with, _statement, _unit):
        fault = reader(cursor, token, head)
        if fault is not None:
            raise LineFaultError(fault)
    if token.word in NOT_YET_MODIFIERS:
        cursor.not_yet(token, token.word)
    hint = LEFT_OVER.get(token.word, "") or _WORDS.get(token.word, "")
    if token.kind == "word" and len(token.text) > 1 and not hint:
        hint = did_you_mean(token.text, INSIDE)
    cursor.fail("the end of the line", hint)


def _decimal(cursor: Cursor, comma: Token, _: Token) -> Fault | None:
    """Return the fault of a decimal comma, as in `0,5`."""
    before, behind = cursor.look(-1), cursor.look(1)
    is_decimal = comma.word == "," and before.kind == behind.kind == "number"
    if not is_decimal or before.end != comma.start or comma.end != behind.start:
        return None
    return cursor.unexpected("the end of the line", DECIMAL.format(before.text, behind.text), "")


def _setting_of_other_languages(cursor: Cursor, token: Token, head: Token) -> Fault | None:
    """Return the fault of a speed or zone that is written in another way, also behind a comma."""
    at = cursor.index + (token.word == ",")
    if head.word not in MOTIONS or at >= cursor.length:
        return None
    found = meant(cursor.tokens[: cursor.length], at)
    if found is None:
        return None
    last = cursor.tokens[at + found.count - 1]
    fix = f" {found.fix}" if token.word == "," and found.fix else found.fix
    message = f"expected the end of the line, found `{token.text}`"
    return Fault(kinds.UNEXPECTED, token.start, last.end, message, found.hint, fix)


def _second_setting(cursor: Cursor, token: Token, head: Token) -> Fault | None:
    """Return the fault of the words behind the setting of a `set`."""
    if head.word != "set":
        return None
    behind, is_output = cursor.look(1), cursor.tokens[1].word not in SETTINGS
    if token.word in SETTINGS:
        hint, fix = "each `set` has one setting: write the next one below", f"{cursor.below}set {token.text}"
    elif token.word == "," and behind.word in SETTINGS:
        hint, fix = "each `set` has one setting: write the next one below", f"{cursor.below}set"
    elif "number" in (token.kind, behind.kind) and token.word in ("", ",", "for") and is_output:
        hint, fix = "nothing stands behind what is set; a time is a line of its own: `wait 0.5 s`", ""
    else:
        return None
    return cursor.unexpected("the end of the line", hint, fix)


def _comma(cursor: Cursor, comma: Token, head: Token) -> Fault | None:
    """Return the fault of a comma between a target and the words behind it."""
    behind = cursor.look(1)
    if comma.word != "," or head.word not in MOTIONS or behind.kind != "word":
        return None
    if behind.word not in _BEHIND_TARGETS:
        hint = "points on the way stand behind `via`, settings without commas: "
        hint += "`lin via a, b to c speed 100 mm/s`"
        return cursor.unexpected("the end of the line", hint, "")
    message = "expected the end of the line, found `,`"
    hint = "what follows a target stands without commas"
    return Fault(kinds.UNEXPECTED, comma.start, behind.end, message, hint, f" {behind.text}")


def _with(cursor: Cursor, token: Token, head: Token) -> Fault | None:
    """Return the fault of a `with` before the settings of a motion."""
    behind = cursor.look(1)
    if token.word != "with" or head.word not in MOTIONS or behind.word not in _BEHIND_TARGETS:
        return None
    message, hint = (
        "expected the end of the line, found `with`",
        "settings stand behind a target without `with`",
    )
    return Fault(kinds.UNEXPECTED, token.start, behind.end, message, hint, behind.text)


def _statement(cursor: Cursor, token: Token, head: Token) -> Fault | None:
    """Return the fault of a second statement on a line."""
    if not begins_statement(cursor) or (token.word not in ACTIONS and head.word in MOTIONS):
        return None
    hint = "each statement stands on a line of its own"
    fix = cursor.below + token.text if head.word not in _HOLDING else ""
    return cursor.unexpected("the end of the line", hint, fix)


def _end(cursor: Cursor, token: Token, head: Token) -> Fault | None:
    """Return the fault of the end of a block behind a statement."""
    if token.word not in CLOSERS:
        return None
    if head.word != "if":
        hint = "the end of a block stands on a line of its own"
        return cursor.unexpected("the end of the line", hint, cursor.below + token.text)
    hint = "an `if` with its statement on the line has no end: leave it out"
    if token.word != END or cursor.look(1).kind != "end":
        return cursor.unexpected("the end of the line", hint, "")
    before, message = cursor.look(-1), f"expected the end of the line, found `{token.text}`"
    return Fault(kinds.UNEXPECTED, before.start, token.end, message, hint, before.text)


def _semicolon(cursor: Cursor, sign: Token, head: Token) -> Fault | None:
    """Return the fault of a `;` between two statements."""
    if sign.word != ";":
        return None
    cursor.go(1)
    behind, is_other = cursor.token, begins_statement(cursor) or names_task(cursor)
    cursor.go(-1)
    if not is_other or head.word in _HOLDING:
        return None
    message = "expected the end of the line, found `;`"
    fix = cursor.below + behind.text
    return Fault(kinds.UNEXPECTED, sign.start, behind.end, message, LEFT_OVER[";"], fix)


def _unit(cursor: Cursor, token: Token, _: Token) -> Fault | None:
    """Return the fault of a word that stands where the unit of a number stands."""
    if cursor.look(-1).kind != "number" or token.kind != "word" or token.word in RESERVED:
        return None
    written = WRITTEN_OUT.get(token.word, "")
    if not written and (token.word in INSIDE or did_you_mean(token.text, INSIDE)):
        return None
    hint = f"write `{written}`" if written else _near_unit(token.word)
    message = f"unknown unit `{token.text}`"
    return Fault(
        kinds.UNEXPECTED, token.start, token.end, message, hint or "units are " + " ".join(UNITS), written
    )


def _near_unit(word: str) -> str:
    """Return "did you mean `cm`?", or an empty string where no unit, or more than one, is near."""
    alike = [unit for unit in UNITS if unit[0].lower() == word[0]]
    longer = [unit for unit in alike if len(unit) >= _TELLING and word.startswith(unit)]
    nearest = sorted((edit_distance(word, one.lower()), abs(len(one) - len(word)), one) for one in alike)
    best = [one for *key, one in nearest if key[0] <= 1 and key == [*nearest[0][:2]]]
    found = [max(longer, key=len)] if longer else best
    return f"did you mean `{found[0]}`?" if len(found) == 1 else ""
