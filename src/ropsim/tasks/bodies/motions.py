"""Motions as task text and as terms of a knowledge base, one line each."""

from collections.abc import Iterator, Mapping, Sequence

from ropsim.language import nodes, statements
from ropsim.prolog import Atom, Struct, Term
from ropsim.tasks.terms.expression_terms import NoTermError, term_of
from ropsim.tasks.terms.expression_text import NotTextError, expression, name_of, quantity

MOTIONS = frozenset(("mov", "lin", "circ", "spline"))
SIDES: Mapping[str, str] = {"start": "after start", "end": "before end"}
"""From where an output on the way counts, by the word of a term."""


def motion_line(term: Struct, names: Mapping[str, str]) -> str:
    """Return the line of a motion.

    Args:
        term: the motion.
        names: how the text calls each variable.

    Raises:
        NotTextError: it is none.
    """
    match term:
        case Struct("mov" | "lin" as word, (target,)):
            return f"{word} {expression(target, names)}"
        case Struct("mov" | "lin" as word, (target, tuple(modifiers))):
            way = next((one for one in modifiers if _points(one)), None)
            others = [one for one in modifiers if one is not way]
            return _joined(word, _points(way) if way is not None else (), target, others, names)
        case Struct("circ", (via, target)):
            return _joined("circ", (via,), target, (), names)
        case Struct("circ", (via, target, tuple(modifiers))):
            return _joined("circ", (via,), target, modifiers, names)
        case Struct("spline", (tuple(points), target)) if points:
            return _joined("spline", points, target, (), names)
        case Struct("spline", (tuple(points), target, tuple(modifiers))) if points:
            return _joined("spline", points, target, modifiers, names)
    raise NotTextError(term, "a motion")


def _points(term: Term) -> tuple[Term, ...]:
    """Return the points of `via([A, B])`; none for any other term."""
    match term:
        case Struct("via", (tuple(points),)):
            return points
    return ()


def _joined(
    word: str, points: tuple[Term, ...], target: Term, modifiers: Sequence[Term], names: Mapping[str, str]
) -> str:
    way = f" via {', '.join(expression(one, names) for one in points)} to" if points else ""
    behind = [_modifier(one, names) for one in modifiers]
    return " ".join([f"{word}{way} {expression(target, names)}", *behind])


def _modifier(term: Term, names: Mapping[str, str]) -> str:
    match term:
        case Struct("until", (condition,)):
            return f"until {expression(condition, names)}"
        case Struct("until", (condition, time)):
            return f"until {expression(condition, names)} timeout {quantity(time, names)}"
        case Struct("store", (name,)):
            return f"store {name_of(name, names)}"
        case Struct("at", (place, Atom(side), Struct("set", (signal, value)))) if side in SIDES:
            return f"at {quantity(place, names)} {SIDES[side]} do {output_line(signal, value, names)}"
    return setting_text(term, names)


def output_line(signal: Term, value: Term, names: Mapping[str, str]) -> str:
    """Return the line that sets an output."""
    match value:
        case Atom("on" | "off" as level):
            return f"set {name_of(signal, names)} {level}"
    return f"set {name_of(signal, names)} = {expression(value, names)}"


def setting_text(term: Term, names: Mapping[str, str]) -> str:
    """Return a setting as written behind a motion, `set` or `with`.

    Raises:
        NotTextError: it is none.
    """
    match term:
        case Atom("fine"):
            return "fine"
        case Struct("tool" | "frame" as word, (name,)):
            return f"{word} {name_of(name, names)}"
        case Struct("speed" | "acc" | "blend" | "angle" as word, (value,)):
            return f"{word} {quantity(value, names)}"
    words = "`fine`, `speed(V)`, `acc(A)`, `blend(D)`, `tool(T)`, `frame(F)`"
    raise NotTextError(
        term, f"one of {words}, of a motion `via([…])`, `until(C)`, `store(x)`, `at(D, start, set(S, V))`"
    )


_WORDS = {"movj": "mov", "movl": "lin", "movc": "circ"}
_SIDES = {"after": "start", "before": "end"}


def motion_term(line: statements.Motion, names: Mapping[str, str]) -> Term:
    """Return the term of a motion.

    Raises:
        NoTermError: it has no text.
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
