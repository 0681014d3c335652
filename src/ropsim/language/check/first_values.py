"""Variables that have their types from their first values: whole numbers, and values that are none later."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

from ropsim.core import Diagnostic, Label, TextEdit
from ropsim.language.check import fold, functions, signatures, units
from ropsim.language.check.body import Body, Made, RejectedError, Unfit
from ropsim.language.check.types import NAMED, NUMBER, Type, Value, article, known
from ropsim.language.check.world import Variable
from ropsim.language.findings import types as kinds
from ropsim.language.syntax import nodes
from ropsim.language.syntax import statements as syntax


def look(body: Body, node: syntax.Assign, variable: Variable, value: Value) -> None:
    """Report a value that is no whole number, for a variable whose first value is one.

    Args:
        body: being checked.
        node: a later assignment.
        variable: that it assigns.
        value: that is assigned.

    Raises:
        RejectedError: it was reported.
    """
    kind, name = known(value.type), node.name.text
    if not isinstance(kind, Type) or not _has_fraction(kind, value):
        return
    made, before = body.made.get(name), body.sight.names.get(name)
    is_made_here = made is not None and made.variable == variable.name
    is_declared = name not in body.names and name in body.world.symbols
    if body.task and not (is_made_here or is_declared):
        return  # a parameter or a counter
    message = f"`{name}` keeps whole numbers, as its first value is one; found {_shown(kind, value)}"
    is_plain = kind.dimension == units.NUMBER
    hint = "use `round( )` here, or a variable of its own" if is_plain else "use a variable of its own"
    found = kinds.NOT_WHOLE.at(body.span(node.value), message, hint=hint)
    if is_declared:
        found = _with_declaration(found, body.declared.get(name), name, kind)
    elif made is not None and is_made_here:
        found = _with_first(found, made, kind)
    elif before is not None and before.symbol is variable:
        body.unfit.append(Unfit(found, variable.name, kind))
    body.report.add(found)
    raise RejectedError


def with_first_values(
    found: Iterable[Diagnostic], unfit: Iterable[Unfit], made: Mapping[str, Made]
) -> Iterator[Diagnostic]:
    """Yield findings, those of unfit values with the first values of their variables."""
    by_finding = {one.finding: one for one in unfit}
    by_variable = {one.variable: one for one in made.values()}
    for finding in found:
        one = by_finding.get(finding)
        first = by_variable.get(one.variable) if one is not None else None
        yield _with_first(finding, first, one.kind) if one is not None and first is not None else finding


def _with_declaration(finding: Diagnostic, declared: Made | None, name: str, kind: Type) -> Diagnostic:
    """Return a finding with the first value of the declaration, where that is in sight and has no type."""
    statement = declared.line.statement if declared is not None else None
    if declared is not None and isinstance(statement, syntax.VariableDeclaration) and not statement.type:
        return _with_first(finding, declared, kind)
    message = finding.message.replace("as its first value is one", "as it is declared")
    return replace(finding, message=message, hint=_other_declaration(name, kind))


def _with_first(finding: Diagnostic, made: Made, kind: Type) -> Diagnostic:
    """Return a finding with the first value of the variable, and what that would have to be."""
    value = _first_value(made)
    place = made.place if value is None else value
    line = made.line.logical
    span = line.span(made.unit, place.start, place.end)
    is_plain, written = kind.dimension == units.NUMBER, line.text[place.start : place.end]
    fix = None
    if value is not None and _is_numeral(value):
        fix = TextEdit(span, f"{written}.0") if is_plain else None
        hint = f"write `{written}.0` there, or use `round( )` here" if is_plain else "write a unit there"
    elif is_plain and isinstance(value, nodes.Function) and value.name.text.lower() not in functions.NAMES:
        hint = "use `round( )` here, or a variable of its own"  # a call of a task is no part of an expression
    elif is_plain:
        hint = "multiply it by `1.0` there, or use `round( )` here"
    else:
        hint = f"let it begin with {article(kind)}, or use a variable of its own here"
    return replace(finding, secondary=(Label(span, "its first value"),), hint=hint, fix=fix)


def _first_value(made: Made) -> nodes.Node | None:
    """Return the value that an assignment or a declaration gave first, None where something else did."""
    statement = made.line.statement
    while isinstance(statement, syntax.If | syntax.WaitCondition):
        statement = statement.body if isinstance(statement, syntax.If) else statement.otherwise
    return statement.value if isinstance(statement, syntax.Assign | syntax.VariableDeclaration) else None


def _is_numeral(value: nodes.Node) -> bool:
    """Return whether a value is a whole number without unit, with or without a sign."""
    while isinstance(value, nodes.Unary) and value.op == "neg":
        value = value.operand
    return isinstance(value, nodes.Number) and value.is_whole and not value.unit


def _other_declaration(name: str, kind: Type) -> str:
    """Return how a variable can be declared that is to keep values of a type."""
    word = signatures.word_of(kind)
    if word not in NAMED:
        return "declare it with a first value in that unit"
    hint = f"declare it as `var {name}: {word}`"
    return f"{hint}, or use `round( )` here" if kind.dimension == units.NUMBER else hint


def _has_fraction(kind: Type, value: Value) -> bool:
    number = fold.number_of(value.expression)
    is_whole = kind.dimension == units.NUMBER and number is not None and fold.is_whole(number)
    return kind.is_number and kind.value is NUMBER.value and not is_whole


def _shown(kind: Type, value: Value) -> str:
    number = fold.number_of(value.expression)
    if kind.dimension != units.NUMBER:
        return article(kind)
    return f"{number:g}" if number is not None else "a number that may have a fraction"
