"""Whether two values are the same to whoever reads them: stricter than `==`."""

from collections.abc import Hashable, Mapping
from dataclasses import fields, is_dataclass
from functools import cache
from itertools import compress, starmap
from math import copysign, isnan
from operator import is_not
from typing import Any, cast

_PLAIN = (str, int, bool, bytes, type(None))


def is_same(one: object, other: object) -> bool:
    """Return whether no reader can tell two values apart.

    `1`, `1.0` and `True` are three values, `0.0` and `-0.0` are two; the order of a mapping counts, since
    whoever goes through it sees it. Records are compared field by field, also fields that `==` leaves out.
    """
    if one is other:
        return True
    kind = type(one)
    if kind is not type(other):
        return False
    if kind in _PLAIN:
        return one == other
    if isinstance(one, float) and isinstance(other, float):
        return (one == other and copysign(1.0, one) == copysign(1.0, other)) or (isnan(one) and isnan(other))
    if isinstance(one, tuple | list) and isinstance(other, tuple | list):
        if len(one) != len(other):
            return False
        apart = compress(zip(one, other, strict=True), map(is_not, one, other))  # mostly few of many
        return all(starmap(is_same, apart))
    if isinstance(one, Mapping) and isinstance(other, Mapping):
        return is_same(tuple(one.items()), tuple(other.items()))
    if hasattr(one, "tobytes"):  # arrays: their numbers, and how they lie
        return _array(one) == _array(other)
    if is_dataclass(one) and not isinstance(one, type):
        return all(is_same(getattr(one, name), getattr(other, name)) for name in _names(cast(Hashable, kind)))
    return bool(one == other)


@cache
def _names(kind: Hashable) -> tuple[str, ...]:
    return tuple(one.name for one in fields(cast(Any, kind)))


def _array(one: Any) -> tuple[object, ...]:  # noqa: ANN401 - arrays of any library
    return one.dtype, one.shape, one.tobytes()
