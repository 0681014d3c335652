"""Completions worth a list: items that change the text, and none inside a number or its unit.

Editors open a list at every letter, and many let Enter accept from it. A list that only repeats the word at
the cursor costs the writer that Enter.
"""

import re
from collections.abc import Sequence
from enum import Enum

from ropsim.language import UNIT_WORDS
from ropsim.lsp.protocol.messages import Json

_NUMBER = r"(?<![\w.])\d+(?:\.\d*)?(?:e[+-]?\d*)?"
_IN_NUMBER = re.compile(rf"{_NUMBER}$", re.IGNORECASE | re.ASCII)
_IN_QUANTITY = re.compile(rf"{_NUMBER}[ \t]*([A-Za-z%][\w/%]*)$", re.IGNORECASE | re.ASCII)
_BEGINS_WORD = re.compile(r"\w", re.ASCII)


class Numbers(Enum):
    """How numbers are written in a text.

    Attributes:
        PLAIN: without units.
        WITH_UNITS: with an optional unit, a blank between or none.
    """

    PLAIN = "plain"
    WITH_UNITS = "with units"


def in_number(before: str, numbers: Numbers) -> bool:
    """Return whether a place is inside or at the end of a number or of its unit.

    Args:
        before: the line up to the place.
        numbers: how numbers are written in the text.
    """
    if _IN_NUMBER.search(before):
        return True
    found = _IN_QUANTITY.search(before) if numbers is Numbers.WITH_UNITS else None
    return found is not None and any(unit.startswith(found[1]) for unit in UNIT_WORDS)


def continues(before: str, behind: str, items: Sequence[Json]) -> bool:
    """Return whether a list has an item that differs from the text at the place.

    A word that is written in full leaves only longer words that begin with it.

    Args:
        before: the line up to the place.
        behind: the line from the place on.
        items: completions at the place.
    """
    labels = [str(one["label"]).lower() for one in items]
    rest = re.match(r"\w*", behind, re.ASCII)
    wholes = {(before + (rest[0] if rest else "")).lower(), before.lower()}
    standing = {label for label in labels for whole in wholes if _ends_with(whole, label)}
    if not standing:
        return bool(labels)
    word = max(standing, key=len)
    return any(label.startswith(word) and label not in standing for label in labels)


def _ends_with(text: str, label: str) -> bool:
    """Return whether a text ends with a label, which is no end of a longer word."""
    if not text.endswith(label):
        return False
    before = text[: len(text) - len(label)]
    return not (before and _BEGINS_WORD.match(label) and _BEGINS_WORD.match(before[-1]))
