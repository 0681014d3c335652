"""The body of a task as task text: terms of a knowledge base to lines."""

from collections.abc import Iterator, Mapping, Sequence

from ropsim.prolog import Atom, Struct, Term
from ropsim.tasks.expression_text import NotTextError, argument, expression, name_of, quantity

_SIMPLE = frozenset(("open", "close", "stop", "break", "continue"))


def body_lines(body: Sequence[Term], names: Mapping[str, str], depth: int = 1) -> list[str]:
    """Return the lines of statements.

    Args:
        body: statements as terms.
        names: how the text calls each variable.
        depth: of the block in which they stand.

    Raises:
        NotTextError: a term is no statement.
    """
    return [f"{'  ' * (depth + more)}{line}" for one in body for more, line in _statement(one, names)]


def _statement(term: Term, names: Mapping[str, str]) -> Iterator[tuple[int, str]]:
    """Yield the lines of one statement, each with how deep in it it stands."""
    match term:
        case Atom(word) if word in _SIMPLE:
            yield 0, word
        case Struct("mov" | "lin" as word, (target,)):
            yield 0, f"{word} {expression(target, names)}"
        case Struct("mov" | "lin" as word, (target, tuple(modifiers))):
            words = [f"{word} {expression(target, names)}", *(_setting(one, names) for one in modifiers)]
            yield 0, " ".join(words)
        case Struct("open" | "close" as word, (tool,)):
            yield 0, f"{word} {name_of(tool, names)}"
        case _:
            yield from _other(term, names)


def _other(term: Term, names: Mapping[str, str]) -> Iterator[tuple[int, str]]:
    """Yield the lines of a statement that moves neither arm nor gripper."""
    match term:
        case Struct("wait", (time,)):
            yield 0, f"wait {expression(time, names)}"
        case Struct("wait_until", (condition,)):
            yield 0, f"wait until {expression(condition, names)}"
        case Struct("wait_until", (condition, time)):
            yield 0, f"wait until {expression(condition, names)} timeout {quantity(time, names)}"
        case Struct("set", (setting,)):
            yield 0, f"set {_setting(setting, names)}"
        case Struct("set", (signal, Atom("on" | "off" as level))):
            yield 0, f"set {name_of(signal, names)} {level}"
        case Struct("set", (signal, value)):
            yield 0, f"set {name_of(signal, names)} = {expression(value, names)}"
        case Struct("load", (tuple(targets), source)):
            yield (
                0,
                f"load ({', '.join(name_of(one, names) for one in targets)}), {expression(source, names)}",
            )
        case Struct("call", (Atom(name),)):
            yield 0, f"call {name}"
        case Struct("call", (Struct(name, arguments),)):  # with a blank: one parenthesis may be one location
            yield 0, f"call {name} {', '.join(argument(one, names) for one in arguments)}"
        case Struct(":=", (target, value)):
            yield 0, f"{_target(target, names)} := {expression(value, names)}"
        case Struct("print", (tuple(values),)) if values:
            yield 0, f"print {', '.join(expression(one, names) for one in values)}"
        case Struct("stop", (words,)):
            yield 0, f"stop {expression(words, names)}"
        case _:
            yield from _block(term, names)


def _block(term: Term, names: Mapping[str, str]) -> Iterator[tuple[int, str]]:
    match term:
        case Struct("repeat", (tuple(inner),)):
            yield from _blocks((("repeat", inner),), "endr", names)
        case Struct("repeat", (count, tuple(inner))):
            yield from _blocks(((f"repeat {expression(count, names)}", inner),), "endr", names)
        case Struct("if", (condition, tuple(inner))):
            yield from _blocks(((f"if {expression(condition, names)} then", inner),), "endif", names)
        case Struct("if", (condition, tuple(inner), tuple(otherwise))):
            first = (f"if {expression(condition, names)} then", inner)
            yield from _blocks((first, ("else", otherwise)), "endif", names)
        case Struct("while", (condition, tuple(inner))):
            yield from _blocks(((f"while {expression(condition, names)} do", inner),), "endw", names)
        case Struct("for", (variable, first, last, tuple(inner))):
            bounds = f"{expression(first, names)} to {expression(last, names)}"
            yield from _blocks(((f"for {name_of(variable, names)} = {bounds}", inner),), "endf", names)
        case Struct("with", (tuple(settings), tuple(inner))) if settings:
            head = f"with {', '.join(_setting(one, names) for one in settings)}"
            yield from _blocks(((head, inner),), "endwith", names)
        case _:
            raise NotTextError(term, "a statement")


def _blocks(
    parts: Sequence[tuple[str, Sequence[Term]]], end: str, names: Mapping[str, str]
) -> Iterator[tuple[int, str]]:
    for head, inner in parts:
        yield 0, head
        for one in inner:
            yield from ((depth + 1, line) for depth, line in _statement(one, names))
    yield 0, end


def _setting(term: Term, names: Mapping[str, str]) -> str:
    match term:
        case Atom("fine"):
            return "fine"
        case Struct("tool" | "frame" as word, (name,)):
            return f"{word} {name_of(name, names)}"
        case Struct("speed" | "acc" | "blend" | "angle" as word, (value,)):
            return f"{word} {quantity(value, names)}"
    raise NotTextError(term, "one of `fine`, `speed(V)`, `acc(A)`, `blend(D)`, `tool(T)`, `frame(F)`")


def _target(term: Term, names: Mapping[str, str]) -> str:
    match term:
        case Struct("coordinate", (variable, Atom(member))):
            return f"{name_of(variable, names)}.{member}"
    return name_of(term, names)
