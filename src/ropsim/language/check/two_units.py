"""Numbers without a unit that count in one unit at one place and in another unit at another place."""

from ropsim.language.check.body import Body
from ropsim.language.findings import types as kinds
from ropsim.language.report import Placed


def warn(body: Body, name: str, unit: str, other: str, place: Placed) -> None:
    """Warn of a variable whose number counts in two units (T316)."""
    message = f"the number `{name}` has no unit: it counts in {unit} at one place and in {other} at another"
    hint = f"let it be a quantity: `{name}: length` as a parameter, or a value with a unit"
    if other == "N":
        hint = hint.replace("length", "force")
    body.warn(kinds.TWO_COUNTS, place, message, hint)
