"""Questions of a reader to a section: the form of each key, recorded only during reading."""

from enum import StrEnum

from ropsim.core import frozen_dataclass
from ropsim.tomltext.quantity import Quantity


class Sort(StrEnum):
    """Kind of a value, in words for users."""

    VALUE = "value"
    NUMBER = "number"
    NUMBERS = "list of numbers"
    WHOLE = "whole number"
    TEXT = "text"
    TEXTS = "list of texts"
    FLAG = "`true` or `false`"
    SECTION = "section"
    SECTIONS = "list of sections"
    NAMED = "sections by name"


@frozen_dataclass
class Question:
    """A key that a reader queries.

    Attributes:
        sort: of its value.
        quantity: of its numbers, None for other values and where they differ.
        default: default value, in SI units; None if unspecified.
        choices: words that are allowed; empty for any.
        likely: some of the words that are allowed.
        names: kind of entity of the file that it names, such as `frame`; empty for none.
        count: how many items a list has; None for any.
        meaning: one sentence, of a key whose meaning depends on other keys; empty for all others.
    """

    sort: Sort
    quantity: Quantity | None = None
    default: object = None
    choices: tuple[str, ...] = ()
    likely: tuple[str, ...] = ()
    names: str = ""
    count: int | None = None
    meaning: str = ""

    @property
    def form(self) -> str:
        """Return sort, unit and range in words."""
        count = f"{self.count} numbers" if self.sort is Sort.NUMBERS and self.count else self.sort.value
        named = f"name of a {self.names}" if self.names else count
        words = f"one of {', '.join(f'`{one}`' for one in self.choices)}" if self.choices else named
        return f"{words}, {self.quantity.allowed}" if self.quantity is not None else words

    @property
    def default_words(self) -> str:
        """Return the default value, in units of the file; empty if unspecified."""
        if self.default is None or self.default in ("", ()):
            return ""
        if isinstance(self.default, bool):
            return "true" if self.default else "false"
        if isinstance(self.default, str):
            return f'"{self.default}"'
        scale = self.quantity.scale if self.quantity is not None else 1.0
        items = self.default if isinstance(self.default, tuple) else (self.default,)
        numbers = [f"{one / scale:.6g}" for one in items if isinstance(one, int | float)]
        unit = self.quantity.unit if self.quantity is not None else ""
        listed = f"[{', '.join(numbers)}]" if isinstance(self.default, tuple) else "".join(numbers)
        return f"{listed} {unit}".strip()


UNKNOWN = Question(Sort.VALUE)
