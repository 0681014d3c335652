"""Motions of task text as terms of a knowledge base: the way back of `motion_text`."""

from collections.abc import Iterator, Mapping

from ropsim.language import nodes, statements
from ropsim.prolog import Atom, Struct, Term
from ropsim.tasks.expression_terms import NoTermError, term_of

_WORDS = {"movj": "mov", "movl": "lin", "movc": "circ"}
_SIDES = {"after": "start", "before": "end"}


def motion_term(line: statements.Motion, names: Mapping[str, str]) -> Term:
    """Return the term of a motion.

    Raises:
        NoTermError: it has none.
    """
    word = _WORDS.get(line.word, line.word)
    if line.tracking is not None:
        raise NoTermError("a motion with `track`")
    target, via = term_of(line.target, names), tuple(term_of(one, names) for one in line.via)
    modifiers = tuple(_modifiers(line, names))
    match word:
        case "circ":
            begin: tuple[Term, ...] = (*via, target)
        case "spline":
            begin = (via, target)
        case "mov" | "lin":
            begin = (target,)
            modifiers = (*((Struct("via", (via,)),) if via else ()), *modifiers)
        case _:
            raise NoTermError(f"a motion with `{word}`")
    return Struct(word, (*begin, modifiers) if modifiers else begin)


def _modifiers(line: statements.Motion, names: Mapping[str, str]) -> Iterator[Term]:
    for setting in line.modifiers:
        yield setting_term(setting, names)
    for trigger in line.triggers:
        yield Struct(
            "at",
            (term_of(trigger.place, names), Atom(_SIDES[trigger.side]), output_term(trigger.action, names)),
        )
    if line.condition is not None:
        time = () if line.timeout is None else (term_of(line.timeout, names),)
        yield Struct("until", (term_of(line.condition, names), *time))
    if line.store is not None:
        yield Struct("store", (term_of(line.store, names),))


def output_term(line: statements.SetSignal, names: Mapping[str, str]) -> Term:
    """Return the term that sets an output."""
    return Struct("set", (term_of(line.name, names), term_of(line.value, names)))


def setting_term(setting: statements.Setting, names: Mapping[str, str]) -> Term:
    """Return the term of a setting."""
    value: nodes.Node | None = setting.value if setting.name is None else setting.name
    return Atom(setting.word) if value is None else Struct(setting.word, (term_of(value, names),))
