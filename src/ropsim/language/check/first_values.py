"""Variables that have their types from their first values: whole numbers, and values that are none later."""

from ropsim.core import Label, TextEdit
from ropsim.language.check import fold, units
from ropsim.language.check.body import Body, Made, RejectedError
from ropsim.language.check.types import NUMBER, Type, Value, article, known
from ropsim.language.findings import types as kinds
from ropsim.language.syntax import nodes
from ropsim.language.syntax import statements as syntax


def look(body: Body, node: syntax.Assign, value: Value) -> None:
    """Report a value that is no whole number, for a variable whose first value is one.

    Args:
        body: being checked.
        node: a later assignment.
        value: that is assigned.

    Raises:
        RejectedError: it was reported.
    """
    kind, name = known(value.type), node.name.text
    if not isinstance(kind, Type) or not _has_fraction(kind, value):
        return
    is_plain = kind.dimension == units.NUMBER
    message = f"`{name}` keeps whole numbers, as its first value is one; found {_shown(kind, value)}"
    made = body.made.get(name)
    if made is None and not body.task and name not in body.world.symbols:  # it stands in a part far above
        hint = "give that a fraction, as in `7.0`, or use `round( )` here" if is_plain else "give that a unit"
        body.fail(kinds.NOT_WHOLE, node.value, message, hint)
    first = _first_number(made)
    if made is None or first is None:
        return
    line = made.line.logical
    place = line.span(body.report.source, first.start, first.end)
    written = line.text[first.start : first.end]
    found = kinds.NOT_WHOLE.at(
        body.line.logical.span(body.report.source, node.value.start, node.value.end),
        message,
        secondary=(Label(place, "its first value"),),
        hint=f"write `{written}.0` there, or use `round( )` here" if is_plain else "write a unit there",
        fix=TextEdit(place, f"{written}.0") if is_plain else None,
    )
    body.report.add(found)
    raise RejectedError


def _first_number(made: Made | None) -> nodes.Number | None:
    """Return the whole number without unit that was assigned first, None for anything else."""
    match made.line.statement if made else None:
        case syntax.Assign(value=nodes.Number(is_whole=True, unit="") as number, member=None):
            return number
    return None


def _has_fraction(kind: Type, value: Value) -> bool:
    number = fold.number_of(value.expression)
    is_whole = kind.dimension == units.NUMBER and number is not None and fold.is_whole(number)
    return kind.is_number and kind.value is NUMBER.value and not is_whole


def _shown(kind: Type, value: Value) -> str:
    number = fold.number_of(value.expression)
    if kind.dimension != units.NUMBER:
        return article(kind)
    return f"{number:g}" if number is not None else "a number that may have a fraction"
