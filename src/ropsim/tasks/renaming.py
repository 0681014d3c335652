"""Bodies whose calls go to tasks of other names."""

from collections.abc import Mapping

from ropsim.prolog import Atom, Struct, Term


def renamed_calls(body: tuple[Term, ...], names: Mapping[str, str]) -> tuple[Term, ...]:
    """Return a body that calls tasks by other names.

    Args:
        body: statements as terms.
        names: the other name of each task, by its own; tasks without one keep theirs.
    """
    return tuple(_renamed(one, names) for one in body) if names else body


def _renamed(term: Term, names: Mapping[str, str]) -> Term:
    match term:
        case Struct("call", (Struct(name, arguments),)):
            return Struct("call", (Struct(names.get(name, name), arguments),))
        case Struct("call", (Atom(name),)):
            return Struct("call", (Atom(names.get(name, name)),))
        case Struct(name, arguments):
            return Struct(name, tuple(_renamed(one, names) for one in arguments))
        case tuple():
            return tuple(_renamed(one, names) for one in term)
    return term
