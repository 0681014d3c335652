"""Words for syntax errors of the reader of SWI-Prolog in a clause."""

from ropsim.prolog.terms.terms import Atom, Struct, Term

_WORDS: dict[str, tuple[str, str]] = {
    "operator_expected": (
        "an operator, a comma, a closing bracket or a full stop is missing",
        "two terms stand beside each other: what belongs between them?",
    ),
    "operator_clash": (
        "two operators cannot stand so beside each other",
        "put one of the terms into parentheses",
    ),
    "operator_balance": (
        "an operator lacks one of its terms",
        "every infix operator has a term on both sides",
    ),
    "cannot_start_term": (
        "no term can begin here",
        "a closing bracket or a bar has no partner, or a term is missing before it",
    ),
    "end_of_clause_expected": (
        "the clause should end here",
        "end it with a full stop and a blank or the end of the line",
    ),
    "end_of_clause": (
        "the clause ends too early",
        "a term or a closing bracket is missing before the full stop",
    ),
    "end_of_file": (
        "the text ends within a clause",
        "a full stop, a closing bracket or a closing quote is missing",
    ),
    "end_of_file_in_block_comment": ("the text ends within a comment", "close it with `*/`"),
    "end_of_file_in_quoted": ("the text ends within quotes", "close the quote"),
    "illegal_number": ("this is no number", "digits and one decimal point, as in `12.5` or `1.0e-3`"),
    "quoted_punctuation": (
        "a comma or a bar stands where a term should be",
        "a term is missing, or there is one comma too many",
    ),
    "illegal_atom": ("this is no name", "names begin with a small letter, or stand in single quotes"),
    "cannot_mix": (
        "brackets of different kinds close each other",
        "a round bracket closes a round one, a square one a square one",
    ),
    "undefined_char_escape": (
        "after a backslash stands a character that means nothing there",
        "write `\\\\` for a backslash",
    ),
    "long_string": ("a text in quotes goes over many lines", "close the quote"),
    "dcg_body": ("this cannot be a part of a grammar rule", ""),
}
_NEEDS = "expected are terms of Prolog: `name(Argument, …)`, lists `[a, b]`, and a full stop at the end"


_OF_QUOTES = ("end_of_file_in_quoted", "end_of_file_in_block_comment", "long_string", "undefined_char_escape")
"""If quotes or comments are not closed, the text behind them is ambiguous."""


def may_be_bracket(message: Term) -> bool:
    """Return whether a syntax error of SWI-Prolog may come from a bracket that is missing."""
    return isinstance(message, Atom | Struct) and not message.name.startswith(_OF_QUOTES)


def syntax_words(message: Term) -> tuple[str, str]:
    """Return the message and the hint for a syntax error of SWI-Prologof any kind."""
    match message:
        case Atom(name) | Struct(name, _):
            words, hint = _WORDS.get(_longest(name), (name.replace("_", " "), _NEEDS))
            return words, hint
    return "this cannot be read", _NEEDS


def _longest(name: str) -> str:
    """Return the name itself, or the longest known one that it begins with."""
    return max((known for known in _WORDS if name.startswith(known)), key=len, default=name)
