"""Key that identifies a value among others of its kind, to the bit, and is quick to make."""

from collections.abc import Callable, Hashable, Mapping
from dataclasses import fields, is_dataclass
from enum import Enum
from operator import attrgetter
from typing import Any

import numpy as np


def _itself(value: Hashable) -> Hashable:
    return value


def _typed(value: Hashable) -> Hashable:
    return type(value), value


_makers: dict[type, Callable[[Any], Hashable]] = {
    type(None): _itself,
    str: _itself,
    bytes: _itself,
    float: _itself,
    int: _typed,
    bool: _typed,
}


def bits_of(value: object) -> Hashable:
    """Return a key that two values share only where they are the same.

    It costs a tenth of a fingerprint and means nothing beyond its process. True, 1 and 1.0 are three values.
    In arrays -0.0 is another number than 0.0.

    Args:
        value: records, dataclasses, enums, arrays, texts, numbers, None; tuples, lists, mappings of them.

    Raises:
        TypeError: something in it is no value, such as a function.
    """
    return (_makers.get(type(value)) or _maker(type(value)))(value)


def bits_without(kind: type, *left_out: str) -> Callable[[Any], Hashable]:
    """Return the function that makes the key of dataclasses of a kind without some of their fields.

    Args:
        kind: the class.
        left_out: names of fields that do not count.
    """
    return _of_fields(kind, tuple(one.name for one in fields(kind) if one.name not in left_out))


def _maker(kind: type) -> Callable[[Any], Hashable]:
    """Return the function that makes the key of a value of a class, and keep it."""
    if issubclass(kind, np.ndarray):
        made: Callable[[Any], Hashable] = _of_array
    elif issubclass(kind, tuple | list):
        made = _of_sequence
    elif issubclass(kind, Mapping):
        made = _of_mapping
    elif is_dataclass(kind):
        made = _of_fields(kind, tuple(one.name for one in fields(kind)))
    elif issubclass(kind, Enum):
        made = _itself
    else:
        raise TypeError(f"a {kind.__qualname__} is no value: it has no key")
    _makers[kind] = made
    return made


def _of_array(array: "np.ndarray[Any, Any]") -> Hashable:
    return array.dtype.char, array.shape, array.tobytes()


def _of_sequence(values: tuple[object, ...] | list[object]) -> Hashable:
    return tuple([bits_of(one) for one in values])


def _of_mapping(values: Mapping[Hashable, object]) -> Hashable:
    return tuple([(key, bits_of(one)) for key, one in values.items()])


def _of_fields(kind: type, names: tuple[str, ...]) -> Callable[[Any], Hashable]:
    if len(names) < 2:
        return lambda value: (kind, *[bits_of(getattr(value, name)) for name in names])
    read, makers = attrgetter(*names), _makers

    def made(value: object) -> Hashable:
        return kind, *[(makers.get(type(one)) or _maker(type(one)))(one) for one in read(value)]

    return made
