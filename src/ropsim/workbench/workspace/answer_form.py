"""Answers as plain data that can be kept, and the version of the compiler that gave them."""

import json
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import fields, is_dataclass
from enum import Enum
from functools import cache, partial
from itertools import chain, starmap
from operator import sub
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

import numpy as np

from ropsim import icr, language
from ropsim.core import Category, Diagnostic, Label, RopsimError, Severity, Span, TextEdit, frozen_dataclass
from ropsim.program import SignalUse
from ropsim.version import __version__

T = TypeVar("T")
Row = tuple[int, ...]
"""Structure of a value: its kind, and the rows of its parts."""
_WIDTHS = ("<i1", "<i2", "<i4", "<i8")
"""Types of numbers in bytes, narrow ones first."""


class _Batch(NamedTuple):
    """Rows of one kind and size.

    Attributes:
        kind: of the values.
        size: how many parts each has.
        steps: the first parts of all rows, then the second ones and so on, each as the difference to the one
            before it, which mostly is small.
    """

    kind: int
    size: int
    steps: "np.ndarray[Any, np.dtype[np.signedinteger[Any]]]"


_TUPLE, _MAPPING, _SET = range(3)


@frozen_dataclass
class Translation:
    """Result of the compiler for a text, without the structured program and without procedures.

    Attributes:
        header: declarations of the executable form; None if any finding is an error.
        diagnostics: all findings in order of their place.
        tasks: how each task that can be called is called.
        variables: type of each variable in a word of the language, by task and name.
    """

    header: icr.Program | None
    diagnostics: tuple[Diagnostic, ...]
    tasks: Mapping[str, language.TaskForm]
    variables: Mapping[str, Mapping[str, str]]


@frozen_dataclass
class Verified:
    """Findings of the verifier in the code of a text."""

    diagnostics: tuple[Diagnostic, ...]


_KINDS: tuple[type, ...] = (
    Translation,
    Verified,
    Diagnostic,
    Severity,
    Category,
    Span,
    Label,
    TextEdit,
    language.TaskForm,
    language.ParameterForm,
    language.Environment,
    language.PointTable,
    icr.Program,
    icr.Procedure,
    icr.Variable,
    icr.Step,
    icr.Constant,
    icr.Type,
    icr.IoChannel,
    icr.LibraryText,
    icr.FrameDefinition,
    icr.PoseList,
    icr.ToolDefinition,
    SignalUse,
)
"""Types in answers besides plain values, tuples, mappings and sets."""
_NUMBERS = {kind: number for number, kind in enumerate(_KINDS, start=_SET + 1)}
_STEP = _NUMBERS[icr.Step]
_step = partial(tuple.__new__, icr.Step)
"""Makes an instruction of its fields in a fifth of the time of its class."""
_PLAIN = frozenset((str, int, float, bool, type(None)))
_NUMBER = frozenset((int,))
_FIELDS: dict[type, tuple[str, ...]] = {
    kind: tuple(one.name for one in fields(kind) if one.init) for kind in _KINDS if is_dataclass(kind)
}


_NO_STEPS = np.zeros(0, "<i1")


_WRONG = (ValueError, TypeError, LookupError, AttributeError, ArithmeticError, RecursionError, RopsimError)
"""Raised if bytes are no answer."""


class UnknownFormError(Exception):
    """Something in a value, or in bytes, has no form here."""


def written(value: object) -> bytes:
    """Return a value as bytes, the same in every process: a header line, and numbers.

    Raises:
        UnknownFormError: it holds something of another kind.
    """
    writer = _Writer()
    writer.number(value)
    batches = [*writer.batches()]
    heads = [[one.kind, one.size, one.steps.dtype.itemsize, len(one.steps)] for one in batches]
    head = json.dumps([writer.plain_values(), *heads], separators=(",", ":"))
    return b"".join((head.encode(), b"\n", *(one.steps.tobytes() for one in batches)))


def read(content: bytes) -> object:
    """Return the value that bytes were written of.

    Raises:
        UnknownFormError: they were not.
    """
    head, _, rest = content.partition(b"\n")
    try:
        plain, *heads = json.loads(head)
        if not _PLAIN.issuperset(map(type, plain)):
            raise UnknownFormError
        known: list[Any] = [*plain]
        for batch in _batches(heads, rest):
            known += _made(batch, known)
        return known[-1]
    except _WRONG as error:
        raise UnknownFormError from error


def _batches(heads: list[Any], rest: bytes) -> Iterator[_Batch]:
    """Yield the batches listed in a header."""
    at = 0
    for numbers in heads:
        kind, size, width, count = numbers
        if not _NUMBER.issuperset(map(type, numbers)) or min(numbers) < 0:
            raise UnknownFormError
        steps = np.frombuffer(rest, f"<i{width}", count, at) if count else _NO_STEPS
        yield _Batch(kind, size, steps)
        at += count * width
    if at != len(rest):
        raise UnknownFormError


def _narrow(steps: Sequence[int]) -> "np.ndarray[Any, np.dtype[np.signedinteger[Any]]]":
    """Return numbers in an array of the least width that holds them."""
    made = np.array(steps, "<i8")
    least, most = int(made.min(initial=0)), int(made.max(initial=0))
    kinds = (np.iinfo(one) for one in _WIDTHS)
    return made.astype(next(one.dtype for one in kinds if one.min <= least and most <= one.max))


def read_as(kind: type[T], content: bytes | None) -> T | None:
    """Return the value of a kind that bytes were written of; None where they were not, or there are none."""
    try:
        found = read(content) if content is not None else None
    except UnknownFormError:
        return None
    return found if isinstance(found, kind) else None


def _made(batch: _Batch, known: list[Any]) -> Iterable[object]:
    """Return the values of a batch."""
    kind, size, steps = batch
    places = np.cumsum(steps, dtype=np.int64)
    count, rest = divmod(len(places), size) if size else (1, len(places))
    if rest or not count or places.min(initial=0) < 0:
        raise UnknownFormError
    parts = tuple(map(known.__getitem__, places.tolist()))
    if count == 1:
        rows: Iterable[tuple[Any, ...]] = (parts,)
    else:
        rows = zip(*(parts[at : at + count] for at in range(0, len(parts), count)), strict=True)
    if kind == _TUPLE:
        return rows
    if kind == _STEP and size == len(icr.Step._fields):
        return map(_step, rows)
    if kind > _SET:
        make: Callable[..., object] = _KINDS[kind - _SET - 1]
        return starmap(make, rows)
    if kind == _SET:
        return (frozenset(_texts(row)) for row in rows)
    return (dict(zip(_texts(row[::2]), row[1::2], strict=True)) for row in rows)


def _texts(values: Sequence[Any]) -> Sequence[str]:
    """Return the texts that are names; hashing other values could take any time."""
    if any(type(one) is not str for one in values):
        raise UnknownFormError
    return values


class _Writer:
    """Puts values into rows; compound values are numbered behind their parts."""

    def __init__(self) -> None:
        self._plain: dict[object, int] = {}
        self._values: list[object] = []
        self._rows: dict[Row, int] = {}
        self._same: dict[int, tuple[int, object]] = {}

    def number(self, value: object) -> int:
        """Return the number of a value: plain ones count down from -1, rows up from 0."""
        kind = type(value)
        if kind in _PLAIN:
            key = (kind, repr(value) if kind is float else value)
            found = self._plain.get(key)
            if found is None:
                self._values.append(value)
                found = self._plain[key] = -len(self._values)
            return found
        same = self._same.get(id(value))
        if same is None:  # the value is kept, so that no other one can have its identity
            row = (self._kind(value), *map(self.number, _parts(value)))
            same = self._same[id(value)] = self._rows.setdefault(row, len(self._rows)), value
        return same[0]

    def plain_values(self) -> list[object]:
        """Return all plain values."""
        return self._values

    def batches(self) -> Iterator[_Batch]:
        """Yield the rows in batches; the last row is that of the requested value."""
        depths: list[int] = [0] * len(self._rows)
        depths += [0] * len(self._values)  # depths of plain values, which are found from behind
        batches: dict[tuple[int, int, int], list[Row]] = {}
        for number, row in enumerate(self._rows):
            depths[number] = 1 + max(map(depths.__getitem__, row[1:]), default=0)
            batches.setdefault((depths[number], row[0], len(row) - 1), []).append(row)
        ordered = [batches[key] for key in sorted(batches)]
        numbers = [0] * len(self._rows)
        for place, row in enumerate(chain.from_iterable(ordered), len(self._values)):
            numbers[self._rows[row]] = place
        numbers += range(len(self._values) - 1, -1, -1)
        for rows in ordered:
            kinds, *columns = zip(*rows, strict=True)
            parts = [numbers[part] for column in columns for part in column]
            yield _Batch(kinds[0], len(columns), _narrow([*map(sub, parts, (0, *parts[:-1]))]))

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
    """Return the parts of a value."""
    if isinstance(value, tuple):
        return value
    if isinstance(value, Mapping):
        return tuple(part for pair in value.items() for part in pair)
    if isinstance(value, frozenset):
        return tuple(sorted(value))
    if isinstance(value, Enum):
        return (value.value,)
    return tuple(getattr(value, name) for name in _FIELDS[type(value)])


_PACKAGES = ("core", "flow", "icr", "language", "program", "prolog", "query", "spatial", "tasks", "workbench")
_ENDINGS = (".py", ".pl")
"""Of whose files an answer is made, and how their names end."""


@cache
def compiler_version() -> tuple[object, ...]:
    """Return the version of ropsim, and size and date of each module of the compiler.

    So an answer is made anew after every change of the compiler, also in a folder in which one works on it.
    """
    root = Path(__file__).parents[2]
    found = []
    for package in _PACKAGES:
        for path in sorted(one for one in (root / package).rglob("*") if one.suffix in _ENDINGS):
            state = path.stat()
            found.append((path.relative_to(root).as_posix(), state.st_size, state.st_mtime_ns))
    return __version__, *found
