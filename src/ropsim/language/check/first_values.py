"""Variables that have their types from their first values: whole numbers, and values that are none later."""

from collections.abc import Iterable, Iterator
from dataclasses import replace

from ropsim.core import Diagnostic, Label, TextEdit
from ropsim.language.check import convert, functions, signatures, units
from ropsim.language.check.body import Body, Made, Unfit
from ropsim.language.check.types import NAMED, Type, Value, article, known
from ropsim.language.check.world import Variable
from ropsim.language.findings import types as kinds
from ropsim.language.syntax import nodes
from ropsim.language.syntax import statements as syntax


def look(body: Body, node: syntax.Assign, variable: Variable, value: Value) -> None:
    """Report a value that is no whole number, for a variable that keeps whole numbers and is no parameter.

    Args:
        body: being checked.
        node: a later assignment.
        variable: that it assigns.
        value: that is assigned.

    Raises:
        RejectedError: it was reported.
    """
    kind, name = known(value.type), node.name.text
    if not isinstance(kind, Type) or not convert.has_fraction(kind, value):
        return
    made = body.made.get(name)
    is_made_here = made is not None and made.variable == variable.name
    if name not in body.names:
        reason, hint = _DECLARED, _other_declaration(name, kind)
    elif is_made_here or _is_from_above(body, name, variable):
        reason, hint = _BEGUN, _other_value(kind)
    elif any(loop.variable == variable.name for loop in body.loops):
        reason, hint = "as it counts a loop", _other_value(kind)
    else:
        return  # a parameter
    message = f"`{name}` keeps whole numbers, {reason}; found {convert.shown(kind, value)}"
    found = kinds.NOT_WHOLE.at(body.span(node.value), message, hint=hint)
    if made is not None and is_made_here:
        found = _with_first(found, made, kind)
    else:
        body.unfit.append(Unfit(found, variable.name, kind))
    body.reject(found)


def with_first_values(
    found: Iterable[Diagnostic], unfit: Iterable[Unfit], firsts: Iterable[Made]
) -> Iterator[Diagnostic]:
    """Yield findings, those of unfit values with the first values of their variables."""
    by_finding = {one.finding: one for one in unfit}
    by_variable = {one.variable: one for one in firsts}
    for finding in found:
        one = by_finding.get(finding)
        first = by_variable.get(one.variable) if one is not None else None
        yield _with_first(finding, first, one.kind) if one is not None and first is not None else finding


def _with_first(finding: Diagnostic, made: Made, kind: Type) -> Diagnostic:
    """Return a finding with the first value of the variable, and what that would have to be."""
    value = _first_value(made)
    place = made.place if value is None else value
    line = made.line.logical
    span = line.span(made.unit, place.start, place.end)
    is_plain, written = kind.dimension == units.NUMBER, line.text[place.start : place.end]
    fix = None
    if _is_numeral(value):
        fix = TextEdit(span, f"{written}.0") if is_plain else None
        hint = f"write `{written}.0` there, or use `round( )` here" if is_plain else "write a unit there"
    elif is_plain and _is_call(value):
        hint = _other_value(kind)  # a call of a task is no part of an expression
    elif is_plain:
        hint = "multiply it by `1.0` there, or use `round( )` here"
    else:
        hint = f"let it begin with {article(kind)}, or use a variable of its own here"
    message, labels = finding.message.replace(_DECLARED, _BEGUN), (Label(span, "its first value"),)
    return replace(finding, message=message, secondary=labels, hint=hint, fix=fix)


def _first_value(made: Made) -> nodes.Node | None:
    """Return the value that an assignment or a declaration gave first, None where something else did."""
    statement = made.line.statement
    while isinstance(statement, syntax.If | syntax.WaitCondition):
        statement = statement.body if isinstance(statement, syntax.If) else statement.otherwise
    if isinstance(statement, syntax.Assign | syntax.VariableDeclaration):
        return statement.value
    return None


def _is_numeral(value: nodes.Node | None) -> bool:
    """Return whether a value is a whole number without unit, with or without a sign."""
    while isinstance(value, nodes.Unary) and value.op == "neg":
        value = value.operand
    return isinstance(value, nodes.Number) and value.is_whole and not value.unit


def _is_call(value: nodes.Node | None) -> bool:
    """Return whether a value is what a task returns."""
    return isinstance(value, nodes.Function) and value.name.text.lower() not in functions.NAMES


def _is_from_above(body: Body, name: str, variable: Variable) -> bool:
    """Return whether a part above has made a variable."""
    before = body.sight.names.get(name)
    return before is not None and before.symbol is variable


def _other_value(kind: Type) -> str:
    """Return what can be assigned in place of a value of a type, or where it can go."""
    is_plain = kind.dimension == units.NUMBER
    return "use `round( )` here, or a variable of its own" if is_plain else "use a variable of its own"


def _other_declaration(name: str, kind: Type) -> str:
    """Return how a variable can be declared that is to keep values of a type."""
    word = signatures.word_of(kind)
    if word not in NAMED:
        return "declare it with a first value in that unit"
    hint = f"declare it as `var {name}: {word}`"
    return f"{hint}, or use `round( )` here" if kind.dimension == units.NUMBER else hint


_BEGUN, _DECLARED = "as its first value is one", "as it is declared"
"""Why a variable keeps whole numbers."""
