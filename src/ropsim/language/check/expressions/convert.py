"""A value to the type that its place needs: units of bare numbers, whole numbers to real ones."""

from ropsim.language.check.doubts import origins
from ropsim.language.check.scope import fold, units
from ropsim.language.check.scope.body import Body
from ropsim.language.check.scope.types import AnyType, Type, Unknown, Value, article, bind, known
from ropsim.language.findings import types as kinds
from ropsim.language.report import Placed
from ropsim.program import Constant, Expression, ValueType, variables_of

_REAL, _INT = ValueType.REAL, ValueType.INT


def note(cell: Unknown, value: Value) -> None:
    """Record the evidence of a bare number for an unknown type."""
    cell.has_number = True
    kind = known(value.type)
    if isinstance(kind, Type) and kind.value is _REAL:
        cell.has_fraction = True


def to(body: Body, value: Value, wanted: AnyType, place: Placed, what: str) -> Expression:
    """Return the expression of `value` as `wanted`; `what` names the place, e.g. "the target of `mov`".

    Raises:
        RejectedError: the value does not fit.
    """
    if value.type is wanted and isinstance(wanted, Type):
        return value.expression
    wanted, found = known(wanted), known(value.type)
    if isinstance(wanted, Unknown):
        if value.is_bare:
            note(wanted, value)
        else:
            bind(wanted, found)
        return value.expression
    if isinstance(found, Unknown):
        bind(found, wanted)
        return value.expression
    if wanted.value is found.value is _REAL and wanted.dimension == found.dimension:
        return value.expression
    if wanted.value is _REAL and found.is_number:
        return _real(body, value, wanted, place, what)
    if wanted.value is _INT and found.is_number:
        return _whole(body, value, found, place, what)
    if found.value is not wanted.value:
        body.fail(
            kinds.WRONG_TYPE,
            place,
            f"{what} must be {article(wanted)}, found {article(found)}",
            _hint(wanted, found),
        )
    return value.expression


def real(value: Value) -> Expression:
    """Return a number as REAL, of any dimension."""
    found = known(value.type)
    if isinstance(found, Type) and found.value is _INT:
        return fold.to_real(value.expression)
    return value.expression


def _real(body: Body, value: Value, wanted: Type, place: Placed, what: str) -> Expression:
    found = known(value.type)
    assert isinstance(found, Type)
    expression = real(value)
    if found.value is _REAL and found.dimension == wanted.dimension:
        return expression
    if value.is_bare and wanted.dimension == units.NUMBER:
        return expression
    if not value.is_bare or wanted.dimension == units.SHARE:
        hint = "write a unit" if value.is_bare else _dimension_hint(wanted, found)
        body.fail(
            kinds.WRONG_DIMENSION, place, f"{what} must be {article(wanted)}, found {article(found)}", hint
        )
    if body.world.is_strict and fold.number_of(expression) != 0:
        body.warn(
            kinds.BARE, place, f"{what} is {article(wanted)} without unit", "write the unit behind the number"
        )
    if not isinstance(expression, Constant):
        unit = body.world.units.name(wanted.dimension)
        names = {*variables_of(expression)}
        body.quantities.update((name, unit) for name in names)
        both = sorted(names if origins.is_reading(body, expression) else names & body.counted)
        si = units.SI.name(wanted.dimension)
        if both and unit != si and wanted.dimension in (units.LENGTH, units.FORCE):
            warn_of_two_counts(body, both[0], unit, si, place)
    factor = body.world.units.factor(wanted.dimension)
    try:
        return fold.scaled(expression, factor)
    except ArithmeticError as error:
        body.fail(kinds.OUT_OF_RANGE, place, f"the value cannot be computed: {error}", "check the numbers")


def has_fraction(found: Type, value: Value) -> bool:
    """Return whether a value, of type `found`, is a number that may be no whole one."""
    number = fold.number_of(value.expression)
    is_whole = found.dimension == units.NUMBER and number is not None and fold.is_whole(number)
    return found.value is _REAL and not is_whole


def shown(found: Type, value: Value) -> str:
    """Return the words of a message for a number, of type `found`, that may be no whole one."""
    number = fold.number_of(value.expression)
    if found.dimension != units.NUMBER:
        return article(found)
    return f"{number:g}" if number is not None else "a number that may have a fraction"


def _whole(body: Body, value: Value, found: Type, place: Placed, what: str) -> Expression:
    if has_fraction(found, value):
        is_plain = found.dimension == units.NUMBER
        message = f"{what} must be a whole number, found {shown(found, value)}"
        hint = "use `round( )` or `trunc( )`" if is_plain else "divide by one unit and `round` it"
        body.fail(kinds.NOT_WHOLE, place, message, hint)
    number = fold.number_of(value.expression)
    return value.expression if found.value is _INT or number is None else fold.whole(int(number))


def constant(body: Body, expression: Expression, place: Placed, what: str) -> Constant:
    """Return a constant.

    Raises:
        RejectedError: the value is only known when the program runs.
    """
    if isinstance(expression, Constant):
        return expression
    body.fail(
        kinds.NOT_CONSTANT,
        place,
        f"{what} must be known before the program runs",
        "use numbers and constants only",
    )


def _dimension_hint(wanted: Type, found: Type) -> str:
    if found.dimension == units.NUMBER:
        return f"a plain number has no unit; declare it as {wanted}, or multiply it by one unit"
    return "check the units"


def _hint(wanted: Type, found: Type) -> str:
    if wanted.value is ValueType.POSE and found.value is ValueType.JOINTS:
        return "joint targets are reached by `mov` only"
    if wanted.value is ValueType.POSE:
        return "a location is a name, or three numbers in parentheses: `(x, y, z)`"
    if wanted.value is ValueType.BOOL:
        return "a truth value is `true`, `false`, a digital signal or a comparison such as `n > 3`"
    return ""


def warn_of_two_counts(body: Body, name: str, unit: str, other: str, place: Placed) -> None:
    """Warn of a variable whose number counts in two units (T316)."""
    message = f"the number `{name}` has no unit: it counts in {unit} at one place and in {other} at another"
    hint = f"let it be a quantity: `{name}: length` as a parameter, or a value with a unit"
    if other == "N":
        hint = hint.replace("length", "force")
    body.warn(kinds.TWO_COUNTS, place, message, hint)
