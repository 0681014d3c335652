"""Units of a file by their records: factor of each to kg, m and rad; including products of powers."""

from collections.abc import Mapping

from ropsim.nirox.readers.units import PREFIXES
from ropsim.part21 import Enumeration, Instance, Record, Reference, Typed, Value

Known = Mapping[int, Instance]
"""The instances of a file by their numbers."""
_BASES = {"METRE": 1.0, "GRAM": 1e-3, "RADIAN": 1.0}
_MOST_STEPS, _MOST_PARTS = 3, 8
_MOST_POWER = 10.0


def scale_of(known: Known, unit: int, steps: int = _MOST_STEPS) -> float | None:
    """Return a unit in kg, m and rad; nothing where it is not understood.

    Args:
        known: instances of the file.
        unit: number of an SI unit, one by conversion, or a derived one.
        steps: units in each other that are followed.
    """
    records = {one.keyword: one.values for one in known[unit].records} if unit in known and steps else {}
    if "SI_UNIT" in records:
        prefix, name = records["SI_UNIT"][-2:]
        power = PREFIXES.get(prefix.name.lower(), 0) if isinstance(prefix, Enumeration) else 0
        base = _BASES.get(name.name) if isinstance(name, Enumeration) else None
        return None if base is None else base * 10.0**power
    if "CONVERSION_BASED_UNIT" in records:
        measure = reference(records["CONVERSION_BASED_UNIT"][-1:], 0)
        number, of = measured(known, measure) if measure is not None else (None, None)
        inner = scale_of(known, of, steps - 1) if of is not None else None
        return None if number is None or inner is None else number * inner
    if "DERIVED_UNIT" in records:
        return _product(known, records["DERIVED_UNIT"], steps)
    return None


def _product(known: Known, values: tuple[Value, ...], steps: int) -> float | None:
    found = 1.0
    elements = references_in(values)
    if len(elements) > _MOST_PARTS:
        return None
    for element in elements:
        record = known[element].records[0] if element in known else Record("", ())
        unit, power = reference(record.values, 0), record.values[-1] if record.values else None
        scale = scale_of(known, unit, steps - 1) if unit is not None else None
        if scale is None or scale <= 0.0 or not isinstance(power, float | int) or abs(power) > _MOST_POWER:
            return None
        found *= scale**power
    return found


def measured(known: Known, number: int) -> tuple[float | None, int | None]:
    """Return the value and the unit of a measure, simple or complex; None for missing ones."""
    value: float | None = None
    unit: int | None = None
    for record in known[number].records if number in known else ():
        for one in record.values[:_MOST_PARTS]:
            inner = one.value if isinstance(one, Typed) else one
            if isinstance(inner, float | int) and value is None:
                value = float(inner)
            elif isinstance(one, Reference) and unit is None:
                unit = one.number
    return value, unit


def reference(values: tuple[Value, ...], place: int) -> int | None:
    """Return the instance that a parameter refers to."""
    one = values[place] if place < len(values) else None
    return one.number if isinstance(one, Reference) else None


def references_in(values: tuple[Value, ...]) -> list[int]:
    """Return the instances that lists among the parameters refer to, in order."""
    found: list[int] = []
    for one in values:
        inner = one.value if isinstance(one, Typed) else one
        if isinstance(inner, tuple):
            found += [other.number for other in inner if isinstance(other, Reference)]
    return found
