"""Motions as task text: terms of a knowledge base to one line each."""

from collections.abc import Mapping, Sequence

from ropsim.prolog import Atom, Struct, Term
from ropsim.tasks.expression_text import NotTextError, expression, name_of, quantity

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
    """Return a setting as it stands behind a motion, `set` or `with`.

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
