"""Variables that have their types from their first values: whole numbers, and values that are none later."""

from collections.abc import Collection, Container, Iterable, Iterator
from dataclasses import replace

from ropsim.core import Diagnostic, Label, TextEdit
from ropsim.language.check.calls import signatures
from ropsim.language.check.expressions import convert, functions
from ropsim.language.check.scope import units
from ropsim.language.check.scope.body import Body, Made, Unfit
from ropsim.language.check.scope.types import NAMED, Type, Value, article, known
from ropsim.language.check.scope.world import Variable
from ropsim.language.findings import types as kinds
from ropsim.language.syntax import nodes
from ropsim.language.syntax import statements as syntax
from ropsim.program import variables_of


def look(body: Body, node: syntax.Assign, variable: Variable, value: Value) -> None:
    """Report a value that is no whole number, for a variable that keeps whole numbers and is no parameter.

    Variables that occur in it are noted: another first value of theirs would change this one.

    Args:
        body: being checked.
        node: a later assignment.
        variable: that it assigns.
        value: that is assigned.

    Raises:
        RejectedError: it was reported.
    """
    kind, name = known(value.type), node.name.text
    others = (one for one in variables_of(value.expression) if one != variable.name)
    body.quantities.update((one, "") for one in others)  # this one has their type
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
    unit = body.world.units.name(kind.dimension)
    body.unfit.append(Unfit(found, variable.name, kind, unit, value.is_bare))
    body.reject(found)


def with_first_values(
    found: Iterable[Diagnostic],
    unfit: Iterable[Unfit],
    firsts: Iterable[Made],
    quantities: Iterable[tuple[str, str]],
    shared: Container[str],
) -> Iterator[Diagnostic]:
    """Yield findings, findings about unfit values with the first values of their variables.

    Args:
        found: in order.
        unfit: those among them.
        firsts: where variables have their first values.
        quantities: variables that stand in place of a quantity, each with its unit, empty if uncertain.
        shared: variables that may occur in other units of the text.
    """
    by_finding = {one.finding: one for one in unfit}
    by_variable = {one.variable: one for one in firsts}
    units_of: dict[str, set[str]] = {}
    for name, unit in quantities:
        units_of.setdefault(name, set()).add(unit)
    for finding in found:
        one = by_finding.get(finding)
        first = by_variable.get(one.variable) if one is not None else None
        if one is None or first is None:
            yield finding
            continue
        with_first = _with_first(one, first, units_of.get(one.variable, set()))
        yield replace(with_first, fix=None) if one.variable in shared else with_first


def _with_first(unfit: Unfit, made: Made, used_in: Collection[str]) -> Diagnostic:
    """Return a finding with the first value of the variable, and its required form.

    Args:
        unfit: the value that does not fit.
        made: the first value.
        used_in: units of the quantities as which the variable is used.
    """
    finding, kind, value = unfit.finding, unfit.kind, _first_value(made)
    place = made.place if value is None else value
    line = made.line.logical
    span = line.span(made.unit, place.start, place.end)
    is_plain, written = kind.dimension == units.NUMBER, line.text[place.start : place.end]
    fix = None
    if not _is_numeral(value):
        hint = _other_first(kind, value, used_in)
    elif not is_plain and written == "0" and unfit.unit and {unfit.unit}.issuperset(used_in):
        fix = TextEdit(span, f"0 {unfit.unit}")
        hint = f"write `{fix.replacement}` there"
    elif not is_plain:
        hint = "write a unit there"
    elif not used_in:
        fix = TextEdit(span, f"{written}.0")
        hint = f"write `{fix.replacement}` there, or use `round( )` here"
    elif unfit.is_bare and len(used_in) == 1 and all(used_in):
        hint = f"write `{written} {''.join(used_in)}` there, as it is used, or use `round( )` here"
    else:
        hint = _other_value(kind)
    message, labels = finding.message.replace(_DECLARED, _BEGUN), (Label(span, "its first value"),)
    return replace(finding, message=message, secondary=labels, hint=hint, fix=fix)


def _other_first(kind: Type, value: nodes.Node | None, used_in: Collection[str]) -> str:
    """Return the remedy if the first value is no numeral."""
    if kind.dimension != units.NUMBER:
        return f"let it begin with {article(kind)}, or use a variable of its own here"
    if used_in or _is_call(value):
        return _other_value(kind)  # a call of a task is no part of an expression
    return "multiply it by `1.0` there, or use `round( )` here"


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
    """Return whether a value is the result of a task."""
    return isinstance(value, nodes.Function) and value.name.text.lower() not in functions.NAMES


def _is_from_above(body: Body, name: str, variable: Variable) -> bool:
    """Return whether a part above has made a variable."""
    before = body.sight.names.get(name)
    return before is not None and before.symbol is variable


def _other_value(kind: Type) -> str:
    """Return a value to assign in place of a value of a type, or the place for that value."""
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
