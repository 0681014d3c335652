"""Answers as data: rows of plain numbers and texts that refer to rows before them, and back.

Equal parts have one row, which keeps files small and lets each record be made once. Numbers keep their bits.
"""

import json
from collections.abc import Callable, Mapping
from dataclasses import fields, is_dataclass
from enum import Enum
from typing import Any

from ropsim import icr, language
from ropsim.core import Diagnostic, Label, RopsimError, Severity, Span, TextEdit, frozen_dataclass
from ropsim.program import SignalUse

Row = list[int] | str | int | float | bool | None
"""A plain value; or what a row is made of: its kind, and the rows of its parts."""

_TUPLE, _MAPPING, _SET = range(3)


@frozen_dataclass
class Translation:
    """What the compiler answers to a text, without the structured program.

    Attributes:
        icr: the executable form; None where anything found is an error.
        diagnostics: all findings in order of their place.
        tasks: how each task that can be called is called.
        variables: type of each variable in a word of the language, by task and name.
    """

    icr: icr.Program | None
    diagnostics: tuple[Diagnostic, ...]
    tasks: Mapping[str, language.TaskForm]
    variables: Mapping[str, Mapping[str, str]]


@frozen_dataclass
class Verified:
    """What the verifier finds in the code of a text."""

    diagnostics: tuple[Diagnostic, ...]


_KINDS: tuple[type, ...] = (
    Translation,
    Verified,
    Diagnostic,
    Severity,
    Span,
    Label,
    TextEdit,
    language.TaskForm,
    language.ParameterForm,
    language.Environment,
    icr.Program,
    icr.Procedure,
    icr.Variable,
    icr.Step,
    icr.Constant,
    icr.Type,
    icr.IoChannel,
    icr.LibraryText,
    icr.FrameDefinition,
    icr.ToolDefinition,
    SignalUse,
)
"""All that an answer is made of besides plain values, tuples, mappings and sets."""
_NUMBERS = {kind: number for number, kind in enumerate(_KINDS, start=_SET + 1)}
_FIELDS: dict[type, tuple[str, ...]] = {
    kind: tuple(one.name for one in fields(kind) if one.init) for kind in _KINDS if is_dataclass(kind)
}


class UnknownFormError(Exception):
    """Something in a value, or in bytes, has no form here."""


def written(value: object) -> bytes:
    """Return a value as bytes, the same in every process.

    Raises:
        UnknownFormError: it holds something of another kind.
    """
    writer = _Writer()
    writer.number(value)
    return json.dumps(writer.rows, separators=(",", ":")).encode()


def read(content: bytes) -> object:
    """Return the value that bytes were written of.

    Raises:
        UnknownFormError: they were not.
    """
    try:
        rows = json.loads(content)
        known: list[Any] = []
        for row in rows:
            known.append(_made(row, known) if type(row) is list else row)
        return known[-1]
    except (ValueError, TypeError, LookupError, AttributeError, RecursionError, RopsimError) as error:
        raise UnknownFormError from error


def _made(row: list[int], known: list[Any]) -> object:
    if min(row) < 0:
        raise UnknownFormError
    kind = row[0]
    values = map(known.__getitem__, row[1:])
    if kind == _TUPLE:
        return tuple(values)
    if kind > _SET:
        make: Callable[..., object] = _KINDS[kind - _SET - 1]
        return make(*values)
    every = [*values]
    if kind == _SET:
        return frozenset(_texts(every))
    return dict(zip(_texts(every[::2]), every[1::2], strict=True))


def _texts(values: list[Any]) -> list[str]:
    """Return what names something; other values are none, and to hash them could take any time."""
    if any(type(one) is not str for one in values):
        raise UnknownFormError
    return values


class _Writer:
    """Puts values into rows."""

    def __init__(self) -> None:
        self.rows: list[Row] = []
        self._known: dict[object, int] = {}
        self._same: dict[int, tuple[int, object]] = {}

    def number(self, value: object) -> int:
        """Return the row of a value."""
        kind = type(value)
        if kind in (str, int, bool, type(None)):
            return self._row((kind, value), value)
        if kind is float:
            return self._row((kind, repr(value)), value)
        same = self._same.get(id(value))
        if same is None:  # the value is kept, so that no other one can have its identity
            row = [self._kind(value), *map(self.number, _parts(value))]
            same = self._same[id(value)] = self._row(tuple(row), row), value
        return same[0]

    def _row(self, key: object, row: Any) -> int:  # noqa: ANN401 - a plain value or a list
        found = self._known.get(key)
        if found is None:
            found = self._known[key] = len(self.rows)
            self.rows.append(row)
        return found

    def _kind(self, value: object) -> int:
        kind = type(value)
        if kind is tuple:
            return _TUPLE
        if kind is frozenset:
            return _SET
        if isinstance(value, Mapping):
            return _MAPPING
        if kind not in _NUMBERS:
            raise UnknownFormError(kind.__name__)
        return _NUMBERS[kind]


def _parts(value: object) -> tuple[object, ...]:
    """Return what a value is made of."""
    if isinstance(value, tuple):
        return value
    if isinstance(value, Mapping):
        return tuple(part for pair in value.items() for part in pair)
    if isinstance(value, frozenset):
        return tuple(sorted(value))
    if isinstance(value, Enum):
        return (value.value,)
    return tuple(getattr(value, name) for name in _FIELDS[type(value)])
