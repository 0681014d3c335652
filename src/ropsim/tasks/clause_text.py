"""A clause as people write it: operators between their terms, one property of a task on a line."""

import re

from ropsim.prolog import Atom, Struct, Term, Var, write_term

_OPERATORS = {
    ":=": 990, "is": 700, "=": 700, "==": 700, "\\=": 700, "<": 700, ">": 700, "=<": 700, ">=": 700,
    "+": 500, "-": 500, "*": 400, "/": 400, "mod": 400,
}  # fmt: skip
_LOOSEST = 999
_ANONYMOUS = re.compile(r"_\d+")
"""Names that Prolog gives to variables that have none."""


def clause_text(task: Term) -> str:
    """Return the text of a clause; a `task(Head, [Properties])` has a line for each property."""
    match task:
        case Struct("task", (head, tuple(properties))) if properties:
            lines = ",\n  ".join(term_text(one) for one in properties)
            return f"task({term_text(head)}, [\n  {lines}]).\n"
    return f"{term_text(task)}.\n"


def term_text(term: Term, most: int = _LOOSEST) -> str:
    """Return the text of a term, in parentheses where its operator is looser than `most`."""
    match term:
        case Var(name):
            return "_" if _ANONYMOUS.fullmatch(name) else name
        case Struct("\\+", (one,)):
            text = f"\\+ {term_text(one, 900)}"
            return text if most >= 900 else f"({text})"
        case Struct(name, (left, right)) if name in _OPERATORS:
            level = _OPERATORS[name]
            is_left = level in (400, 500)
            words = f"{term_text(left, level if is_left else level - 1)}", f"{term_text(right, level - 1)}"
            is_tight = name in ("*", "/") or (name == "-" and isinstance(right, Atom))
            space = "" if is_tight and not words[1].startswith("-") else " "
            text = f"{words[0]}{space}{name}{space}{words[1]}"
            return text if level <= most else f"({text})"
        case Struct("+" | "-" as name, (one,)) if not isinstance(one, int | float):
            text = f"{name} {term_text(one, 199)}" if most < 200 else f"{name}{term_text(one, 199)}"
            return text if most >= 200 else f"({text})"
        case Struct(name, arguments) if name != "[|]":
            return f"{write_term(Struct(name, ()))[:-2]}({', '.join(term_text(one) for one in arguments)})"
        case tuple():
            return f"[{', '.join(term_text(one) for one in term)}]"
    return write_term(term)
