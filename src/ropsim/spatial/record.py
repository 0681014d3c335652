"""Records: values that are compared by content, arrays included, and that have a fingerprint."""

import struct
from collections.abc import Callable, Mapping
from dataclasses import field, fields, is_dataclass
from enum import Enum, StrEnum
from functools import lru_cache
from hashlib import sha256
from math import isnan, nan
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, TypeVar, dataclass_transform
from weakref import ref

import numpy as np

from ropsim.core import frozen_without_equality

if TYPE_CHECKING:
    from hashlib import _Hash

T = TypeVar("T")

_records: set[type] = set()
_names: dict[type, tuple[str, ...]] = {}
"""Fields of the classes requested so far."""
_prints: dict[int, tuple["ref[object]", str, int, bytes]] = {}
"""Fingerprint, hash and fed bytes of live records, by identity; only of immutable ones."""


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
def record(cls: type[T]) -> type[T]:
    """Make a frozen, slotted dataclass that is equal to others by content.

    Two records are equal where they are of one class and have the same fingerprint; a class with its own
    equality keeps it. Arrays are read-only again after a record has been pickled.
    """
    is_own = "__eq__" in cls.__dict__
    made = frozen_without_equality(cls)
    methods = {"__setstate__": _restore, **({} if is_own else {"__eq__": _is_equal, "__hash__": _hash})}
    for name, method in methods.items():
        setattr(made, name, method)
    _records.add(made)
    return made


def fingerprint(value: object) -> str:
    """Return 64 hexadecimal digits that identify a value, the same in every process.

    It is the SHA-256 of class names, field names and the bits of numbers; `0.0` and `-0.0` are one number,
    all NaN are one, `1` and `1.0` are two, and a member of a `StrEnum` is its text, to which it is equal.

    Args:
        value: records, dataclasses, enums, arrays, texts, numbers, None, and tuples, lists, sets and mappings
            of them. The order of sets and mappings does not count.

    Raises:
        TypeError: something in it is no value, such as a function.
    """
    return _printed(value)[0]


def _printed(value: object) -> tuple[str, bool]:
    """Return the fingerprint of a value, and whether it is immutable."""
    if type(value) in _SCALARS:
        return _scalar_print(value), True
    known = _prints.get(id(value))
    if known and known[0]() is value:
        return known[1], True
    hasher = sha256()
    lasts = _feed(hasher, value)
    return hasher.hexdigest(), lasts


@lru_cache(maxsize=4096, typed=True)
def _scalar_print(value: object) -> str:
    return sha256(_SCALARS[type(value)](value)).hexdigest()


def _feed(hasher: "_Hash", value: object) -> bool:
    """Put a value into the hash; return whether it is immutable."""
    kind = type(value)
    entry = _SCALARS.get(kind)
    if entry:
        hasher.update(entry(value))
        return True
    if isinstance(value, np.ndarray):
        return _feed_array(hasher, value)
    if isinstance(value, StrEnum):
        hasher.update(_SCALARS[str](value.value))
        return True
    if isinstance(value, Enum):
        hasher.update(f"enum {kind.__qualname__} {value.name}\0".encode())
        return True
    if isinstance(value, Mapping):
        pairs = [(_printed(key), _printed(one)) for key, one in value.items()]
        hasher.update(f"mapping {len(pairs)}\0".encode())
        for key, one in sorted((key[0], one[0]) for key, one in pairs):
            hasher.update(f"{key}{one}".encode())
        return isinstance(value, MappingProxyType) and all(key[1] and one[1] for key, one in pairs)
    if isinstance(value, set | frozenset):
        hasher.update(f"set {len(value)}\0{''.join(sorted(fingerprint(one) for one in value))}".encode())
        return isinstance(value, frozenset)
    if isinstance(value, tuple | list):
        hasher.update(f"{kind.__name__} {len(value)}\0".encode())
        lasts = [_feed(hasher, one) for one in value]
        return all(lasts) and kind is not list
    return _feed_fields(hasher, value)


def _feed_fields(hasher: "_Hash", value: object) -> bool:
    key = id(value)
    known = _prints.get(key)
    if known and known[0]() is value:
        hasher.update(known[3])
        return True
    kind = type(value)
    parts = [f"record {kind.__qualname__}\0"]
    lasts = True
    for name in _field_names(kind):
        inner, stays = _printed(getattr(value, name))
        parts.append(f"{name}\0{inner}")
        lasts &= stays
    fed = "".join(parts).encode()
    hasher.update(fed)
    if lasts and kind in _records:
        found = sha256(fed).hexdigest()
        _prints[key] = ref(value, lambda _: _prints.pop(key, None)), found, _hash_of(found), fed
    return lasts


def _field_names(kind: type) -> tuple[str, ...]:
    known = _names.get(kind)
    if known is not None:
        return known
    if not is_dataclass(kind):
        raise TypeError(f"a {kind.__qualname__} is no value: it has no fingerprint")
    _names[kind] = names = tuple(one.name for one in fields(kind))
    return names


def _feed_array(hasher: "_Hash", array: "np.ndarray[Any, Any]") -> bool:
    if array.dtype.kind not in "biuf":
        raise TypeError(f"an array of {array.dtype} is no value: it has no fingerprint")
    hasher.update(f"array {array.dtype.str} {array.shape}\0".encode())
    if array.dtype.kind == "f":
        plain = np.where(np.isnan(array), np.nan, array + array.dtype.type(0.0))
        hasher.update(np.ascontiguousarray(plain, array.dtype).tobytes())
    else:
        hasher.update(np.ascontiguousarray(array).tobytes())
    return not array.flags.writeable


def _float(value: float) -> bytes:
    plain = nan if isnan(value) else value + 0.0
    return b"float " + struct.pack("<d", plain)


_SCALARS: dict[type, Callable[[Any], bytes]] = {
    type(None): lambda _: b"none\0",
    bool: lambda value: b"bool 1" if value else b"bool 0",
    int: lambda value: f"int {value}\0".encode(),
    float: _float,
    str: lambda value: (
        f"str {len(value.encode('utf-8', 'surrogatepass'))}\0".encode()
        + value.encode("utf-8", "surrogatepass")
    ),
    bytes: lambda value: f"bytes {len(value)}\0".encode() + value,
}


def _is_equal(self: object, other: object) -> bool:
    if self is other:
        return True
    return type(self) is type(other) and fingerprint(self) == fingerprint(other)


def _hash(self: object) -> int:
    known = _prints.get(id(self))
    return known[2] if known and known[0]() is self else _hash_of(fingerprint(self))


def _hash_of(found: str) -> int:
    return int(found[:15], 16)


def _restore(self: object, state: list[object]) -> None:
    for name, value in zip(_field_names(type(self)), state, strict=True):
        if isinstance(value, np.ndarray):
            value.flags.writeable = False
        object.__setattr__(self, name, value)
