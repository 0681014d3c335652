"""Tasks as records, from the terms of the reply of Prolog."""

from collections.abc import Mapping

from ropsim.core import Span
from ropsim.prolog import Atom, Struct, Term, Var
from ropsim.tasks.kinds import Layer
from ropsim.tasks.terms.bounds import bound_of
from ropsim.tasks.terms.known_task import KnownTask, Parameter


def task_of(reply: Term, place: Span, layer: Layer) -> KnownTask | None:
    """Return the task of `told(Name, Arity, Task)`, None for another term.

    Args:
        reply: the reply.
        place: where the task is defined.
        layer: whose text that is.
    """
    match reply:
        case Struct("told", (Atom(name), int(), Struct("task", parts))):
            names = names_in(parts[7])
            parameters, pre, eff, geo, body = (_list(renamed(part, names)) for part in parts[2:7])
            words, ranges = (_list(renamed(part, names)) for part in parts[8:10])
            return KnownTask(
                name,
                tuple(_parameter(one, words, ranges) for one in parameters),
                parts[1] if isinstance(parts[1], str) else getattr(parts[1], "name", ""),
                pre,
                tuple(one.arguments[0] for one in eff if isinstance(one, Struct) and one.name == "+"),
                tuple(one.arguments[0] for one in eff if isinstance(one, Struct) and one.name == "-"),
                geo,
                body,
                place,
                layer,
            )
    return None


def renamed(term: Term, names: Mapping[str, str]) -> Term:
    """Return a term whose variables have the names of the text."""
    match term:
        case Var(name):
            return Var(names.get(name, name))
        case Struct(name, arguments):
            return Struct(name, tuple(renamed(one, names) for one in arguments))
        case tuple():
            return tuple(renamed(one, names) for one in term)
    return term


def names_in(reply: Term) -> Mapping[str, str]:
    """Return the name in the text of each variable of a reply."""
    return {variable.name: word for word, variable in map(_name, _list(reply)) if variable}


def _parameter(term: Term, words: tuple[Term, ...], ranges: tuple[Term, ...]) -> Parameter:
    match term:
        case Struct("p", (Var(name), Atom(kind), default)):
            word, sentence = next((said for one in words if (said := _said(one, name))), ("", ""))
            bounds = tuple(found[1] for one in ranges if (found := bound_of(one)) and found[0] == name)
            given = None if default == Atom("none") else default
            return Parameter(name, kind, given, word, sentence, bounds)
    raise ValueError(f"{term} is no parameter")


def _said(term: Term, parameter: str) -> tuple[str, str] | None:
    """Return word and sentence of `word(V, Word, Sentence)`, None where V is another parameter."""
    match term:
        case Struct("word", (Var(name), str(word), *rest)) if name == parameter:
            return word, next((one for one in rest if isinstance(one, str)), "")
    return None


def _name(pair: Term) -> tuple[str, Var | None]:
    match pair:
        case Struct("=", (Atom(word), Var() as variable)):
            return word, variable
    return "", None


def _list(term: Term) -> tuple[Term, ...]:
    return term if isinstance(term, tuple) else ()
