"""What a reader asks a section for: the form of each key, noted while it is read and written nowhere else."""

from enum import StrEnum

from ropsim.core import frozen_dataclass
from ropsim.tomltext.quantity import Quantity


class Sort(StrEnum):
    """What a value is, in the words that the user reads."""

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
    """A key that a reader asks for.

    Attributes:
        sort: of its value.
        quantity: of its numbers, None for other values and where they differ.
        default: what holds without it, in SI units; None where nobody says.
        choices: words that are allowed; empty for any.
        likely: some of the words that are allowed.
        names: what sort of thing of the file it names, such as `frame`; empty for none.
        count: how many items a list has; None for any.
    """

    sort: Sort
    quantity: Quantity | None = None
    default: object = None
    choices: tuple[str, ...] = ()
    likely: tuple[str, ...] = ()
    names: str = ""
    count: int | None = None

    @property
    def form(self) -> str:
        """Return sort, unit and range in words."""
        count = f"{self.count} numbers" if self.sort is Sort.NUMBERS and self.count else self.sort.value
        named = f"name of a {self.names}" if self.names else count
        words = f"one of {', '.join(f'`{one}`' for one in self.choices)}" if self.choices else named
        return f"{words}, {self.quantity.allowed}" if self.quantity is not None else words

    @property
    def default_words(self) -> str:
        """Return what holds without the key, in units of the file; empty where nobody says."""
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
