"""The body of a task as task text: terms of a knowledge base to lines."""

from collections.abc import Iterator, Mapping, Sequence

from ropsim.prolog import Atom, Struct, Term
from ropsim.tasks.bodies.motions import MOTIONS, motion_line, output_line, setting_text
from ropsim.tasks.terms.expression_text import NotTextError, argument, expression, name_of, quantity

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
        case Struct(word, _) if word in MOTIONS:
            yield 0, motion_line(term, names)
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
            yield 0, f"set {setting_text(setting, names)}"
        case Struct("set", (signal, value)):
            yield 0, output_line(signal, value, names)
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
        case Struct("repeat_until", (condition, tuple(inner))):
            yield from _blocks((("repeat", inner),), f"until {expression(condition, names)}", names)
        case Struct("repeat_until", (count, condition, tuple(inner))):
            end = f"until {expression(condition, names)}"
            yield from _blocks(((f"repeat {expression(count, names)}", inner),), end, names)
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
        case Struct("for", (variable, first, last, step, tuple(inner))):
            bounds = f"{expression(first, names)} to {expression(last, names)} step {expression(step, names)}"
            yield from _blocks(((f"for {name_of(variable, names)} = {bounds}", inner),), "endf", names)
        case Struct("for_each", (variable, pattern, tuple(inner))):
            head = f"for each {name_of(variable, names)} in {name_of(pattern, names)}"
            yield from _blocks(((head, inner),), "endf", names)
        case Struct("with", (tuple(settings), tuple(inner))) if settings:
            head = f"with {', '.join(setting_text(one, names) for one in settings)}"
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


def _target(term: Term, names: Mapping[str, str]) -> str:
    match term:
        case Struct("coordinate", (variable, Atom(member))):
            return f"{name_of(variable, names)}.{member}"
    return name_of(term, names)
