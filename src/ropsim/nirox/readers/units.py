"""The units of length and angle that the context of a representation declares."""

from math import isclose, pi, radians

from ropsim.core import frozen_dataclass
from ropsim.nirox.diagnostics import UNIT_UNKNOWN
from ropsim.nirox.readers.seen import Seen

PREFIXES = {
    "exa": 18, "peta": 15, "tera": 12, "giga": 9, "mega": 6, "kilo": 3, "hecto": 2, "deca": 1,
    "deci": -1, "centi": -2, "milli": -3, "micro": -6, "nano": -9, "pico": -12, "femto": -15, "atto": -18,
}  # fmt: skip
_MOST_STEPS = 4
"""Units by conversion in each other that are followed."""


@frozen_dataclass
class Unit:
    """A unit as a multiple of metre or radian; division by whole numbers rounds once.

    Attributes:
        factor: factor to SI units.
        divisor: divides it.
    """

    factor: float = 1.0
    divisor: float = 1.0

    def si(self, value: float) -> float:
        """Return a value in this unit [m | rad]."""
        if isclose(self.factor, pi / 180.0, rel_tol=1e-8):
            return radians(value)
        return value * self.factor / self.divisor


@frozen_dataclass
class Units:
    """The units of a context."""

    length: Unit = Unit()
    angle: Unit = Unit()


SI = Units()


def units_of(seen: Seen, context: int) -> Units:
    """Return the units of a context; undeclared or unknown units are noted.

    Args:
        seen: the file.
        context: number of the instance.
    """
    seen.take(context)
    if not seen.is_a(context, "global_unit_assigned_context"):
        seen.note(
            UNIT_UNKNOWN, context, "the context declares no units", "name a unit of length and one of angle"
        )
        return SI
    if seen.is_a(context, "global_uncertainty_assigned_context"):
        for number in seen.refs(context, "uncertainty"):
            seen.take(number)
    found: dict[str, Unit] = {}
    for number in seen.refs(context, "units"):
        kind = next((one for one in ("length_unit", "plane_angle_unit") if seen.is_a(number, one)), "")
        unit = _unit(seen, number, _MOST_STEPS)
        if kind and unit is None:
            seen.note(
                UNIT_UNKNOWN, number, "the unit is not understood", "use SI units, or a conversion to them"
            )
        if kind:
            found.setdefault(kind, unit or Unit())
    missing = [one for one in ("length_unit", "plane_angle_unit") if one not in found]
    if missing:
        words = f"the context declares no {' and no '.join(one.replace('_', ' ') for one in missing)}"
        seen.note(UNIT_UNKNOWN, context, words, "add the unit to its units")
    return Units(found.get("length_unit", Unit()), found.get("plane_angle_unit", Unit()))


def _unit(seen: Seen, number: int, steps: int) -> Unit | None:
    seen.take(number)
    if seen.is_a(number, "si_unit"):
        power = PREFIXES.get(seen.text(number, "prefix"), 0)
        known = seen.text(number, "name") in ("metre", "radian")
        return Unit(10.0 ** max(power, 0), 10.0 ** max(-power, 0)) if known else None
    if not steps or not seen.is_a(number, "conversion_based_unit"):
        return None
    measure = seen.ref(number, "conversion_factor")
    base = _unit(seen, seen.ref(measure, "unit_component"), steps - 1)
    seen.take(measure)
    value = seen.real(measure, "value_component")
    if base is None or not value > 1e-12:
        return None
    if seen.has(number, "dimensions"):
        seen.take(seen.ref(number, "dimensions"))
    return Unit(value * base.factor, base.divisor)
