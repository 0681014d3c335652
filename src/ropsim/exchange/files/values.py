"""Numbers and names out of the attributes of an element; errors in them are noted."""

import re
from math import sqrt

from ropsim.exchange.files.xml_tree import Element
from ropsim.exchange.losses.diagnostics import BAD_NUMBER, ELEMENT_MISSING
from ropsim.exchange.losses.gathered import shown
from ropsim.exchange.losses.notes import Notes

LARGEST = 1e12
"""Greatest number of a robot, in any unit; squares and products of numbers up to it stay finite."""

_NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?", re.ASCII)


def finite(text: str) -> float | None:
    """Return the number that a text stands for; nothing where it is none, is not finite or is too large."""
    if not _NUMBER.fullmatch(text):
        return None
    value = float(text)
    return value if abs(value) <= LARGEST else None


def name_of(element: Element, notes: Notes, key: str = "name") -> str | None:
    """Return a text that an element needs; nothing where it is absent or empty (noted)."""
    value = element.attributes.get(key, "").strip()
    if value:
        return value
    notes.add(
        ELEMENT_MISSING, element.span, f"`{element.name}` has no `{key}`", f"write {key}=... into the element"
    )
    return None


def number_of(element: Element, key: str, notes: Notes, default: float = 0.0) -> float:
    """Return a number of an element.

    Args:
        element: with the attribute `key`, or without it.
        key: of the attribute.
        notes: for a number that is none; the default stands in its place.
        default: if the attribute is missing.
    """
    return numbers_of(element, key, notes, (default,))[0]


def numbers_of(
    element: Element, key: str, notes: Notes, default: tuple[float, ...], least: int | None = None
) -> tuple[float, ...]:
    """Return numbers of an element, as many as the default has.

    Args:
        element: with the attribute `key`, or without it.
        key: of the attribute.
        notes: for values that are no number, and for a wrong count; the default replaces them.
        default: if the attribute is missing.
        least: minimum count; further ones have the default.
    """
    text = element.attributes.get(key)
    if text is None:
        return default
    words = text.split(maxsplit=len(default))
    values = tuple(value for word in words if (value := finite(word)) is not None)
    if len(values) == len(words) and (least or len(default)) <= len(values) <= len(default):
        return (*values, *default[len(values) :])
    wanted = "a finite number" if len(default) == 1 else f"{len(default)} finite numbers"
    notes.add(
        BAD_NUMBER,
        element.span,
        f'`{element.name}` has {key}="{shown(text)}", allowed is {wanted}',
        "write decimal numbers with blanks between them",
        {"found": shown(text)},
    )
    return default


def direction_of(
    element: Element, key: str, notes: Notes, default: tuple[float, float, float]
) -> tuple[float, float, float]:
    """Return a unit vector of an element, shape (3,); a vector of length zero is noted."""
    x, y, z = numbers_of(element, key, notes, default)
    length = sqrt(x * x + y * y + z * z)
    if length < 1e-9:
        notes.add(
            BAD_NUMBER,
            element.span,
            f'`{element.name}` has {key}="{x:g} {y:g} {z:g}", which has no direction',
            "write a unit vector such as 0 0 1",
        )
        return default
    if abs(length - 1.0) < 4e-16:
        return (x, y, z)
    return (x / length, y / length, z / length)
