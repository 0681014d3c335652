"""Words for errors of Prolog: names that a text or a goal has, and none of Prolog's or ropsim's own parts."""

import re

from ropsim.prolog.terms.terms import Atom, Struct, Term
from ropsim.prolog.terms.writing import write_term

MOST_CHARACTERS = 500
"""Longer words are cut off."""
SHOWN_FAILURES = frozenset(("ValueError", "ZeroDivisionError", "OverflowError", "OSError", "RopsimError"))
"""Errors of functions whose words are written for users; messages of other errors name parts of Python."""
INTO_ROPSIM = "this reaches into ropsim itself, which is not allowed"
INTO_PROLOG = "this reaches into Prolog itself, which is not allowed"

_QUOTED_NAME = re.compile(r"`'((?:[^'\\]|\\.)*)'(?=[\s.,:;)]|$)")
_QUOTED = re.compile(r"`((?:'(?:[^'\\]|\\.)*'|[^'`])*)'")
_VARIABLE = re.compile(r"(?<![\w'\"])_G?\d+\b")
_OWN = re.compile(r"\bropsim_\w+'?:|module `?ropsim_")
_CONTEXT = re.compile(r"^'?[\w$]+'?/\d+: ")
_PLACE = re.compile(r"\s*Defined at \S+")
_FILE = re.compile(r"(?<![\w/])/kb/")
_SANDBOXED = re.compile(r"No permission to call sandboxed (`[^`]*`|a part of Prolog)")
_OF_PROLOG = re.compile(r"`[^`]*\$[^`]*`|(?:\w+:)?'\$[^']*'(?:\([^()]*\)|/\d+)?|(?:\w+:)?\$\w+/\d+")
_NEAR = re.compile(r",?\s*However,? there are definitions for:\s*(.*)$")
_WORDS = (
    ("Unknown error term: ", "Prolog has no words for the error "),
    ("Unknown message: ", "Prolog has no words for "),
    ("source_sink", "file"),
    ("sandboxed_clause", "a clause of another text:"),
)


def error_words(formal: Term, words: str) -> str:
    """Return the message for an error.

    Args:
        formal: formal term of the error in Prolog's standard.
        words: Prolog's own, for errors without own words.
    """
    match formal:
        case Struct("existence_error", (Atom("procedure"), called)):
            indicator = _indicator(called)
            if _OWN.search(indicator):
                return INTO_ROPSIM
            return INTO_PROLOG if "$" in indicator else f"predicate `{indicator}` is defined nowhere"
        case Struct("python_error", (Atom(sort), said)):
            failed = "a function that the goal calls failed"
            return (
                f"{failed}: {_text(said)}" if sort in SHOWN_FAILURES else f"{failed} by a mistake of its own"
            )
    return shown_words(words)


def near_words(words: str) -> str:
    """Return the hint on predicates whose names are near, which Prolog puts behind an error; else nothing."""
    found = _NEAR.search(" ".join(words.split()))
    names = [f"`{_without_modules(one)}`" for one in found[1].split()[:3]] if found else []
    return f"there is {' and '.join(names)}" if names else ""


def thrown_words(ball: Term) -> str:
    """Return the message for the thrown term of a goal."""
    thrown = shown_words(f"`{_written(ball)}`")
    return INTO_ROPSIM if thrown == INTO_ROPSIM else f"the goal threw {thrown}, which nothing caught"


def shown_words(words: str, module: str = "user") -> str:
    """Return words of Prolog without names of its own parts: variables are `_`, files have their names.

    Args:
        words: of one or several lines.
        module: of the text that they are about, in front of its names.
    """
    joined = quoted(" ".join(words.split())[:MOST_CHARACTERS])
    if _OWN.search(joined):
        return INTO_ROPSIM
    plain = _VARIABLE.sub("_", _without_modules(_NEAR.sub("", joined), module))
    plain = _FILE.sub("", _PLACE.sub("", _CONTEXT.sub("", plain)))
    plain = _OF_PROLOG.sub("a part of Prolog", plain)
    plain = _SANDBOXED.sub(r"\1 may not be called by a text that is not trusted", plain)
    for own, ours in _WORDS:
        plain = plain.replace(own, ours)
    return plain or "an error without words"


def quoted(words: str) -> str:
    """Return the words of Prolog with names quoted as in all findings."""
    return _QUOTED.sub(r"`\1`", _QUOTED_NAME.sub(r"`\1`", words))


def _without_modules(words: str, module: str = "user") -> str:
    """Return words without modules in front of names: the text's own, and those in Prolog's libraries."""
    return re.sub(rf"(?<![\w'])(?:user|system|{re.escape(module)}):(?=[\w'(\[])", "", words)


def _indicator(called: Term) -> str:
    """Return `name/arity` of a predicate or of a goal, without the module of goals."""
    match called:
        case Struct(":", (Atom(module), inner)):
            inside = _indicator(inner)
            return inside if module in ("user", "system") else f"{module}:{inside}"
        case Struct("/", (Atom(name), int(arity))):
            return f"{name}/{arity}"
        case Struct(name, arguments):
            return f"{name}/{len(arguments)}"
        case Atom(name):
            return f"{name}/0"
    return _written(called)


def _text(said: Term) -> str:
    return said if isinstance(said, str) else _written(said)


def _written(term: Term) -> str:
    return write_term(term)[:MOST_CHARACTERS]
