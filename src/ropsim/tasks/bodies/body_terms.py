"""The body of a task text as terms of a knowledge base: the way back of `body_text`."""

from collections.abc import Iterator, Mapping

from ropsim.language import nodes, statements
from ropsim.prolog import Atom, Struct, Term
from ropsim.tasks.bodies.motions import motion_term, output_term, setting_term
from ropsim.tasks.terms.expression_terms import NoTermError, arguments_of, term_of

_CLOSERS = (statements.Closer, statements.Else, statements.ElseIf, statements.Until)


def body_terms(lines: Iterator[statements.Statement], names: Mapping[str, str]) -> tuple[Term, ...]:
    """Return the statements up to the one that closes their block, including that one.

    Args:
        lines: the statements of a task behind its header.
        names: the variable of each parameter by its name in the text.

    Raises:
        NoTermError: a statement has no term.
    """
    return _block(lines, names)[0]


def _block(
    lines: Iterator[statements.Statement], names: Mapping[str, str]
) -> tuple[tuple[Term, ...], statements.Statement | None]:
    """Return the statements of a block, and its last line; None if the text ends before."""
    found: list[Term] = []
    for line in lines:
        if isinstance(line, _CLOSERS):
            return tuple(found), line
        found.append(_statement(line, lines, names))
    return tuple(found), None


def _statement(
    line: statements.Statement, lines: Iterator[statements.Statement], names: Mapping[str, str]
) -> Term:
    match line:
        case statements.If(condition=condition, body=None):
            return _if(condition, lines, names)
        case statements.If(condition=condition, body=one) if one is not None:
            return Struct("if", (term_of(condition, names), (_statement(one, lines, names),)))
        case statements.Repeat(count=count):
            inner, end = _block(lines, names)
            passes = () if count is None else (term_of(count, names),)
            if isinstance(end, statements.Until):
                return Struct("repeat_until", (*passes, term_of(end.condition, names), inner))
            return Struct("repeat", (*passes, inner))
        case statements.While(condition=condition):
            return Struct("while", (term_of(condition, names), _block(lines, names)[0]))
        case statements.For(name=name, first=first, last=last, step=step):
            bounds = tuple(term_of(one, names) for one in (first, last, step) if one is not None)
            return Struct("for", (term_of(name, names), *bounds, _block(lines, names)[0]))
        case statements.ForEach(name=name, pattern=pattern):
            what = term_of(name, names), term_of(pattern, names)
            return Struct("for_each", (*what, _block(lines, names)[0]))
        case statements.With(settings=settings):
            modes = tuple(setting_term(one, names) for one in settings)
            return Struct("with", (modes, _block(lines, names)[0]))
    return _simple(line, names)


def _if(condition: nodes.Node, lines: Iterator[statements.Statement], names: Mapping[str, str]) -> Term:
    """Return the term of `if` and the rest of it; `elseif` is an `if` inside the else branch."""
    then, end = _block(lines, names)
    sides = (term_of(condition, names), then)
    match end:
        case statements.Else():
            return Struct("if", (*sides, _block(lines, names)[0]))
        case statements.ElseIf(condition=other):
            return Struct("if", (*sides, (_if(other, lines, names),)))
    return Struct("if", sides)


def _simple(line: statements.Statement, names: Mapping[str, str]) -> Term:  # noqa: PLR0911 - a case for each kind
    match line:
        case statements.Motion():
            return motion_term(line, names)
        case statements.Gripper(word=word, tool=tool):
            return Atom(word) if tool is None else Struct(word, (term_of(tool, names),))
        case statements.WaitTime(duration=duration):
            return Struct("wait", (term_of(duration, names),))
        case statements.WaitCondition(condition=condition, timeout=timeout, otherwise=None):
            more = () if timeout is None else (term_of(timeout, names),)
            return Struct("wait_until", (term_of(condition, names), *more))
        case statements.SetSignal():
            return output_term(line, names)
        case statements.SetMode(setting=setting):
            return Struct("set", (setting_term(setting, names),))
        case statements.Load(names=targets, source=source):
            return Struct("load", (tuple(term_of(one, names) for one in targets), term_of(source, names)))
        case statements.Call(name=name, arguments=items):
            arguments = arguments_of(name, items, names)
            return Struct("call", (Struct(name.text, arguments) if arguments else Atom(name.text),))
        case statements.Assign(name=name, member=member, value=value):
            target = term_of(name, names)
            if member is not None:
                target = Struct("coordinate", (target, Atom(member.text)))
            return Struct(":=", (target, term_of(value, names)))
        case statements.Print(values=values):
            return Struct("print", (tuple(term_of(one, names) for one in values),))
        case statements.Stop(message=message):
            return Atom("stop") if message is None else Struct("stop", (term_of(message, names),))
        case statements.Jump(word=word):
            return Atom(word)
    raise NoTermError("a statement that terms have no form for")
