"""Expressions of task text as terms of a knowledge base: the way back of `expression_text`."""

from collections.abc import Mapping

from ropsim.language import nodes
from ropsim.prolog import Atom, Struct, Term, Var
from ropsim.tasks.terms.expression_text import COMPARISONS, TURNS
from ropsim.tasks.terms.task_call import quantity_term

_FROM_TEXT = {**{text: name for name, text in COMPARISONS.items()}, "!=": "\\="}


class NoTermError(ValueError):
    """A piece of task text without a form as a term; the message names it."""


def term_of(node: nodes.Node, names: Mapping[str, str]) -> Term:  # noqa: PLR0911 - a case for each kind
    """Return the term of an expression.

    Args:
        node: the expression.
        names: the variable of each parameter by its name in the text.

    Raises:
        NoTermError: the text has no term.
    """
    match node:
        case nodes.Name(text=text):
            return Var(names[text]) if text in names else Atom(text)
        case nodes.Number():
            return _number(node)
        case nodes.Text(value=value):
            return value
        case nodes.Literal(word=word):
            return Atom(word)
        case nodes.Unary(op="neg", operand=nodes.Number() as number):
            return _negative(number)
        case nodes.Unary(op=op, operand=operand):
            return Struct("-" if op == "neg" else op, (term_of(operand, names),))
        case nodes.Binary(op=op, left=left, right=right):
            return Struct(_FROM_TEXT.get(op, op), (term_of(left, names), term_of(right, names)))
        case nodes.State(operand=operand, word=word, negated=negated):
            level = Struct("is", (term_of(operand, names), Atom(word)))
            return Struct("not", (level,)) if negated else level
        case nodes.Rebase(operand=operand, frame=frame):
            return Struct("in", (term_of(operand, names), term_of(frame, names)))
        case nodes.Member(operand=operand, name=name):
            return Struct("coordinate", (term_of(operand, names), Atom(name.text)))
        case nodes.Function(name=name, arguments=arguments):
            return Struct(name.text.lower(), tuple(_argument(one, names) for one in arguments))
        case nodes.Joints(values=values):
            return Struct("joints", tuple(term_of(one, names) for one in values))
        case nodes.Tuple():
            return _point(node, names)
    what = "a free orientation" if isinstance(node, nodes.Free) else "values of external axes"
    raise NoTermError(f"a location with {what}")


def arguments_of(
    name: nodes.Name, items: tuple[nodes.Item, ...], names: Mapping[str, str]
) -> tuple[Term, ...]:
    """Return the arguments of a call; one parenthesis that touches the name is their list.

    Raises:
        NoTermError: one of them has no term.
    """
    match items:
        case (nodes.Item(name=None, value=nodes.Tuple(turns=(), posture=None) as inner),) if (
            inner.start == name.end or len(inner.items) not in (3, 5, 6)
        ):
            items = inner.items
    return tuple(_argument(one, names) for one in items)


def _argument(item: nodes.Item, names: Mapping[str, str]) -> Term:
    value = term_of(item.value, names)
    if item.name is not None:
        return Struct("=", (Atom(item.name.text), value))
    match value:
        case Struct("=", sides):
            return Struct("==", sides)
    return value


def _number(number: nodes.Number) -> Term:
    value = int(number.value) if number.is_whole else number.value
    return quantity_term(value, number.unit) if number.unit else value


def _negative(number: nodes.Number) -> Term:
    value = -int(number.value) if number.is_whole else -number.value
    return quantity_term(value, number.unit) if number.unit else value


def _point(node: nodes.Tuple, names: Mapping[str, str]) -> Term:
    if node.posture is not None:
        raise NoTermError("a location with a posture or a free orientation")
    if any(item.name is not None for item in node.items):
        raise NoTermError("a location whose numbers have names")
    numbers = tuple(term_of(item.value, names) for item in node.items)
    if not node.turns:
        return Struct("p", numbers)
    return Struct("p", (*numbers, tuple(_turn(one, names) for one in node.turns)))


def _turn(turn: nodes.Turn, names: Mapping[str, str]) -> Term:
    if turn.word not in TURNS or turn.like is not None:
        raise NoTermError(f"the turn `{turn.word}` of a location")
    values = tuple(term_of(one, names) for one in turn.values)
    return Struct(turn.word, values) if values else Atom(turn.word)
