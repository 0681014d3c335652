"""What a name means that a parameter or a declaration takes for itself."""

from ropsim.language.check.types import POSE, Value, known
from ropsim.language.check.world import Pattern, Symbol
from ropsim.program import SignalUse, ValueType


def what(symbol: Symbol) -> str:
    """Return what a name stands for, with its article."""
    match symbol:
        case SignalUse(is_input=is_input, type=kind):
            return f"an {'analog ' if kind is ValueType.REAL else ''}{'input' if is_input else 'output'}"
        case Pattern():
            return "a pattern"
        case Value(type=kind):
            return "a location" if known(kind) == POSE else "a constant"
    return "a variable"
