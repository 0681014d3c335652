"""Values of part parameters in words, as lists and pages show them: millimetres, kilograms, seconds."""

from collections.abc import Mapping
from types import MappingProxyType

from ropsim.parts.part_kind import Fact, Measure, Parameter, PartKind, Values

UNITS: Mapping[Measure, tuple[float, str]] = MappingProxyType(
    {
        Measure.LENGTH: (1e3, "mm"),
        Measure.MASS: (1.0, "kg"),
        Measure.TIME: (1.0, "s"),
        Measure.COUNT: (1.0, ""),
    }
)
"""Shown unit of a quantity: units in one SI unit, and name."""


def value_words(parameter: Parameter, value: float | None) -> str:
    """Return a value with its unit; `–` for one that follows from the others."""
    if value is None:
        return "–"
    scale, unit = UNITS[parameter.measure]
    return f"{scale * value:g} {unit}".rstrip()


def range_words(parameter: Parameter) -> str:
    """Return the range of a parameter with its unit."""
    scale, unit = UNITS[parameter.measure]
    return f"{scale * parameter.low:g} to {scale * parameter.high:g} {unit}".rstrip()


def values_words(kind: PartKind, values: Values) -> str:
    """Return several values in the order of the parameters, such as `stroke 80 mm, mass 0.7 kg`."""
    known = (one for one in kind.parameters if one.name in values)
    return ", ".join(f"{one.name} {value_words(one, values[one.name])}" for one in known)


def fact_words(fact: Fact) -> str:
    """Return a further figure of a product, such as `grip force 15 to 50 N`."""
    joint = " to " if len(fact.values) == 2 else " x "
    return f"{fact.name} {joint.join(f'{value:g}' for value in fact.values)} {fact.unit}"
