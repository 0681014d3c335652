"""Values of part parameters in words, as lists and pages show them: millimetres, kilograms, seconds."""

from collections.abc import Mapping, Sequence
from types import MappingProxyType

from ropsim.parts.part_kind import Fact, Measure, Parameter, PartKind, Product, UpperBound, Values

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


def bound_words(bound: UpperBound) -> str:
    """Return a bound, such as `drum_diameter` is at most `diameter`."""
    counts = " or ".join(f"`{name}`" for name in bound.of_several)
    return f"`{bound.small}` is at most `{bound.large}`" + (f" where {counts} is above 1" if counts else "")


def beyond_words(kind: str, parameter: Parameter, value: float) -> str:
    """Return what is wrong with a value [SI] that its parameter does not allow."""
    whole = "a whole number from " if parameter.measure is Measure.COUNT else ""
    found, low, high = (f"{number:g}" for number in (value, parameter.low, parameter.high))
    return f"`{parameter.name}` of `{kind}` is {found}, allowed is {whole}{low} to {high}, in SI units"


def conflict_words(name: str, conflict: tuple[Parameter, Parameter], shown: Sequence[str]) -> tuple[str, str]:
    """Return message and hint for a parameter above another one.

    Args:
        name: of the first one, as the message calls it.
        conflict: both, as `PartKind.conflict` returns them.
        shown: their values with units.
    """
    small, large = conflict
    return (
        f"`{name}` is {shown[0]}, above `{large.name}`, which is {shown[1]}",
        f"write a smaller `{small.name}` or a larger `{large.name}`",
    )


def tcp_words(kind: PartKind, product: Product | None, distance: float) -> str:
    """Return where the TCP of a tool is and how that is known, such as `TCP at 103.4 mm (published)`."""
    return f"TCP at {1e3 * distance:.4g} mm ({kind.tcp_origin(product).value})"
