"""Between which bounds the value of a parameter is, and whether it is."""

import operator
from collections.abc import Callable, Mapping

from ropsim.core import frozen_dataclass
from ropsim.prolog import Struct, Term
from ropsim.tasks.terms.expression_text import short_text, unit_of
from ropsim.tasks.terms.task_call import Quantity, Value

_KEEPS: Mapping[str, Callable[[float, float], bool]] = {
    ">=": operator.ge,
    "=<": operator.le,
    ">": operator.gt,
    "<": operator.lt,
}
SIGNS = tuple(_KEEPS)
"""How bounds are written."""
_WORDS: Mapping[str, str] = {">=": "at least", "=<": "at most", ">": "more than", "<": "less than"}
_SCALES: Mapping[str, tuple[str, float]] = {
    **{unit: ("length", one) for unit, one in (("mm", 1e-3), ("cm", 1e-2), ("m", 1.0), ("inch", 0.0254))},
    **{unit: ("angle", one) for unit, one in (("deg", 0.017453292519943295), ("rad", 1.0))},
    **{unit: ("time", one) for unit, one in (("ms", 1e-3), ("s", 1.0), ("min", 60.0))},
    **{unit: ("speed", one) for unit, one in (("mm/s", 1e-3), ("cm/s", 1e-2), ("m/s", 1.0))},
    **{unit: ("turning speed", one) for unit, one in (("deg/s", 0.017453292519943295), ("rad/s", 1.0))},
    **{unit: ("acceleration", one) for unit, one in (("mm/s2", 1e-3), ("cm/s2", 1e-2), ("m/s2", 1.0))},
    "deg/s2": ("turning acceleration", 1.0),
    "N": ("force", 1.0),
    "%": ("share", 1.0),
}
"""Dimension of a unit, and its size in SI units."""
PROGRAM_UNITS: Mapping[str, str] = {
    "length": "mm",
    "angle": "deg",
    "time": "s",
    "speed": "mm/s",
    "accel": "mm/s2",
    "force": "N",
}
"""Unit of a bare number of each kind in a program made of tasks; other kinds have no unit."""


@frozen_dataclass
class Bound:
    """One bound of a parameter.

    Attributes:
        sign: `>=`, `=<`, `>` or `<`.
        value: a number, or a quantity in the units that an operator reads.
    """

    sign: str
    value: float | Quantity

    @property
    def number(self) -> str:
        """Return its value as typed."""
        return str(self.value) if isinstance(self.value, Quantity) else short_text(self.value)

    def __str__(self) -> str:
        return f"{_WORDS[self.sign]} {self.number}"

    def keeps(self, value: Value, kind: str) -> bool:
        """Return whether a value of a parameter of a kind lies on the right side; names and texts do."""
        if isinstance(value, bool | str):
            return True
        (of_value, first), (of_bound, second) = _measured(value, kind), _measured(self.value, kind)
        return of_value != of_bound or _KEEPS[self.sign](first, second)


def millimetres(term: Term) -> float | None:
    """Return a length of a call [mm], a bare number in the units of programs; None for a name."""
    quantity = unit_of(term) if isinstance(term, Struct) else None
    value = Quantity(*quantity) if quantity is not None else term
    if not isinstance(value, int | float | Quantity):
        return None
    return _measured(value, "length")[1] / _SCALES["mm"][1]


def bound_of(term: Term) -> tuple[str, Bound] | None:
    """Return the name of the parameter in a term such as `B >= 1`, and the bound."""
    match term:
        case Struct(sign, (variable, bound)) if sign in _KEEPS:
            quantity = unit_of(bound) if isinstance(bound, Struct) else None
            value = Quantity(*quantity) if quantity is not None else bound
            name = getattr(variable, "name", "")
            return (name, Bound(sign, value)) if isinstance(value, int | float | Quantity) else None
    return None


def _measured(value: float | Quantity, kind: str) -> tuple[str, float]:
    unit = value.unit if isinstance(value, Quantity) else PROGRAM_UNITS.get(kind, "")
    number = value.value if isinstance(value, Quantity) else value
    measures, scale = _SCALES.get(unit, (unit, 1.0))
    return measures, number * scale
