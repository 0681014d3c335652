"""Strict comparison of values: stricter than `==`."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import fields, is_dataclass
from itertools import compress, starmap
from math import copysign, isnan
from operator import eq, is_not
from typing import Any

_PLAIN = (str, int, bool, bytes, type(None))
_FEW = 12
"""Rows of at most this many values are compared in a loop; most of them contain distinct objects."""


def is_same(one: object, other: object) -> bool:
    """Return whether two values are indistinguishable.

    `1`, `1.0` and `True` are three values, `0.0` and `-0.0` are two; the order of a mapping counts. Records
    are compared by all their init fields, including fields that `==` ignores; cached values are ignored.
    """
    if one is other:
        return True
    kind = type(one)
    return kind is type(other) and _BY_TYPE[kind](one, other)


class _ByType(dict[type[Any], Callable[[Any, Any], bool]]):
    """Comparison function of each type, determined once per type because thousands of values are compared."""

    def __missing__(self, kind: type[Any]) -> Callable[[Any, Any], bool]:
        found = self[kind] = _comparison(kind)
        return found


_BY_TYPE = _ByType()


def _comparison(kind: type[Any]) -> Callable[[Any, Any], bool]:
    if kind in _PLAIN:
        return eq
    if issubclass(kind, float):
        return _are_same_numbers
    if issubclass(kind, tuple | list):
        return _are_same_rows
    if issubclass(kind, Mapping):
        return lambda one, other: _are_same_rows(tuple(one.items()), tuple(other.items()))
    if hasattr(kind, "tobytes"):  # arrays: their numbers, and how they lie
        return lambda one, other: _array(one) == _array(other)
    if is_dataclass(kind):
        return _of_record(tuple(field.name for field in fields(kind) if field.init))
    return lambda one, other: bool(one == other)


def _of_record(names: tuple[str, ...]) -> Callable[[Any, Any], bool]:
    """Return a generated function that compares two records of a type field by field."""
    lines = (
        line
        for name in names
        for line in (
            f"a, b = one.{name}, other.{name}",
            "if a is not b:",
            " kind = type(a)",
            " if kind is not type(b) or not by_type[kind](a, b): return False",
        )
    )
    known: dict[str, Any] = {"by_type": _BY_TYPE}
    exec("\n ".join(("def compare(one, other):", *lines, "return True")), known)
    made: Callable[[Any, Any], bool] = known["compare"]
    return made


def _are_same_numbers(one: float, other: float) -> bool:
    return (one == other and copysign(1.0, one) == copysign(1.0, other)) or (isnan(one) and isnan(other))


def _are_same_rows(one: Sequence[object], other: Sequence[object]) -> bool:
    if len(one) != len(other):
        return False
    if len(one) <= _FEW:
        for mine, yours in zip(one, other, strict=True):
            if mine is not yours:
                kind = type(mine)
                if kind is not type(yours) or not _BY_TYPE[kind](mine, yours):
                    return False
        return True
    apart = compress(zip(one, other, strict=True), map(is_not, one, other))  # mostly few of many
    return all(starmap(is_same, apart))


def _array(one: Any) -> tuple[object, ...]:  # noqa: ANN401 - arrays of any library
    return one.dtype, one.shape, one.tobytes()
