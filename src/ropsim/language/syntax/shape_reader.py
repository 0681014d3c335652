"""Generates the reader for lines of a shape, from one line and its statement.

Numbers and names that stand in open places are taken from the line that is read; all other offsets lie as far
from the open place before them as in the line that is known.
"""

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import fields, is_dataclass
from functools import lru_cache
from typing import Any, cast

from ropsim.core import maker
from ropsim.language.syntax.lexer import MOST_LETTERS
from ropsim.language.syntax.nodes import Name, Number
from ropsim.language.syntax.statements import Statement

MOST_DIGITS = 12
"""Characters of a number; one of no more is small enough for the language."""

_CUT = re.compile(r"(?<![\w./])([A-Za-z_]+\d\w*|\d+(?:\.\d+)?(?![\d_.eE]))", re.ASCII).split
_PLACES = ("start", "end", "opening", "closing")
_BEHIND_DIGITS = ":"
"""Stands behind all digits and before all letters."""

Reader = Callable[[Sequence[str]], Statement | None]
"""Returns the statement of a line in parts; None for a name in place of a number, or too large a number."""


def parts_of(line: str) -> list[str]:
    """Return the texts of a line before the first open place, in it, behind it, and so on.

    Open places are numbers, without their units, and words with digits, none of which has a meaning of its
    own. A line with a text has no parts, since texts are not searched.
    """
    return [] if '"' in line else _CUT(line)


def reader_of(parts: Sequence[str], statement: Statement) -> Reader | None:
    """Return a reader for lines of the shape of one; None if dependence on the open places is uncertain.

    Args:
        parts: of that line.
        statement: of that line.
    """
    writing = _Writing(parts)
    try:
        made = writing.value(statement)
    except _UnclearError:
        return None
    inside = {k for k, end in enumerate(writing.ends) if end <= statement.end}
    if inside != writing.used:
        return None
    exec("\n".join((*writing.head(), f" return {made}")), writing.known)
    return cast(Reader, writing.known["read"])


class _UnclearError(Exception):
    """A part of a statement may depend on open places in an unknown way."""


class _Writing:
    """The source of a reader.

    Attributes:
        known: makers of records, by the names of their classes.
        said: texts of the open places.
        ends: offsets behind them.
        used: open places from which numbers and names were read.
    """

    def __init__(self, parts: Sequence[str]) -> None:
        self.known: dict[str, object] = {}
        self.said = parts[1::2]
        self.used: set[int] = set()
        self.ends: list[int] = []
        self._before = [len(before) for before in parts[:-1:2]]
        self._starts: dict[int, int] = {}
        end = 0
        for k, (before, said) in enumerate(zip(self._before, self.said, strict=True)):
            self._starts[end + before] = k
            end += before + len(said)
            self.ends.append(end)

    def head(self) -> list[str]:
        """Return the lines that extract the open places: text, length and end of each."""
        lines = ["def read(parts):"]
        for k, (before, said) in enumerate(zip(self._before, self.said, strict=True)):
            lines += [f" s{k} = parts[{2 * k + 1}]", f" n{k} = len(s{k})"]
            is_other = f"s{k} < {_BEHIND_DIGITS!r} or n{k} > {MOST_LETTERS}"
            if said < _BEHIND_DIGITS:
                is_other = f"s{k} > {_BEHIND_DIGITS!r} or n{k} > {MOST_DIGITS}"
            lines.append(f" if {is_other}: return None")
            lines.append(f" e{k} = {f'e{k - 1} + ' if k else ''}{before} + n{k}")
        return lines

    def value(self, value: object) -> str:
        """Return the expression that makes a value.

        Raises:
            _UnclearError: dependence on the open places is unknown.
        """
        if value is None or isinstance(value, bool):
            return repr(value)
        if isinstance(value, str) and not any(said in value for said in self.said):
            return repr(value)
        if isinstance(value, tuple):
            return f"({''.join(f'{self.value(one)}, ' for one in value)})"
        if not is_dataclass(value):
            raise _UnclearError
        cls: type = type(value)
        name = f"{cls.__module__}.{cls.__qualname__}".replace(".", "_")
        self.known[name] = _maker(cls)
        if isinstance(value, Name | Number):
            content = self._open(value)
        else:
            content = self._fields((one.name, getattr(value, one.name)) for one in fields(value))
        return f"{name}({', '.join(content)})"

    def _fields(self, values: Iterable[tuple[str, Any]]) -> list[str]:
        return [self._place(one) if name in _PLACES else self.value(one) for name, one in values]

    def _open(self, record: Name | Number) -> list[str]:
        """Return the content of a name or a number, which may stand in an open place."""
        places = [self._place(record.start), self._place(record.end)]
        k = self._starts.get(record.start)
        if isinstance(record, Name):
            if k is None:
                return [self.value(record.text), *places]
            is_clear, content = record.text == self.said[k], [f"s{k}"]
        else:
            unit = repr(record.unit)
            if k is None:
                return [repr(record.value), repr(record.is_whole), unit, *places]
            is_clear, content = record.value == float(self.said[k]), [f"float(s{k})", f"s{k}.isdigit()", unit]
        if not is_clear:
            raise _UnclearError
        self.used.add(k)
        return [*content, *places]

    def _place(self, offset: int) -> str:
        """Return the expression of an offset."""
        before = [k for k, end in enumerate(self.ends) if end <= offset]
        return f"e{before[-1]} + {offset - self.ends[before[-1]]}" if before else str(offset)


@lru_cache(maxsize=256)
def _maker(cls: type) -> Callable[..., object]:
    return maker(cls)
