"""TOML values in the words of messages."""

import math


def float_of(value: float) -> float:
    """Return a number as float; whole numbers beyond its range become infinite."""
    try:
        return float(value)
    except OverflowError:
        return math.inf if value > 0 else -math.inf


def sort_of(value: object) -> str:
    """Return the kind of a TOML value."""
    for sort, words in (
        (bool, "true or false"),
        (int, "a whole number"),
        (float, "a number"),
        (str, "text"),
        (list, "a list"),
        (dict, "a section"),
    ):
        if isinstance(value, sort):
            return words
    return "a date or time"


def cut(text: str) -> str:
    """Return a text of the user, shortened where it would fill the message."""
    return text if len(text) <= 60 else f"{text[:57]}..."
