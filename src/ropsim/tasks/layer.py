"""Whose tasks there are: a task of one layer takes the place of one of that name in the layers behind it."""

from enum import Enum


class Layer(Enum):
    """Where the text of a task lies, the layer that counts first at the top; the value is its first number.

    Prolog knows texts by their numbers (`layer/2` of kb.pl).
    """

    PROJECT = 0
    USER = -1_000_000
    LIBRARY = -2_000_000

    @classmethod
    def of_text(cls, number: int) -> "Layer":
        """Return the layer of a text by its number."""
        return next(layer for layer in cls if number >= layer.value)
