"""Typed records as plain values for strict JSON, and back: the types of their fields are the only rule.

A record becomes a mapping of its fields, a tuple a list, an enum its value. Reading is strict: entries that
are missing without a default, or of another type, are named. Unknown entries are passed over.
"""

from collections.abc import Callable, Mapping
from dataclasses import MISSING, Field, fields, is_dataclass
from enum import Enum
from types import NoneType, UnionType
from typing import Any, TypeVar, get_args, get_origin, get_type_hints

from ropsim.core import frozen_dataclass
from ropsim.records.plain_values import tagged, untagged

T = TypeVar("T")


class DocumentError(ValueError):
    """An entry is missing or of the wrong type; the message names it."""


@frozen_dataclass
class _Form:
    """How values of one type are written and read; `read` also takes the name of the entry."""

    write: Callable[[Any], object]
    read: Callable[[object, str], Any]


def plain_record(value: object) -> dict[str, object]:
    """Return a record as plain values.

    Raises:
        TypeError: a field has a type that has no plain form.
    """
    forms = _field_forms(type(value))
    return {name: form.write(getattr(value, name)) for name, (_, form) in forms.items()}


def record_from(kind: type[T], plain: object, name: str) -> T:
    """Return the record that plain values describe.

    Args:
        kind: class of the record.
        plain: as `plain_record` makes it, from anywhere.
        name: of the entry, for messages.

    Raises:
        DocumentError: an entry is missing or of the wrong type.
    """
    entry = _typed(plain, dict, name)
    found = {}
    for key, (field, form) in _field_forms(kind).items():
        if key in entry:
            found[key] = form.read(entry[key], key)
        elif field.default is MISSING and field.default_factory is MISSING:
            raise DocumentError(f"`{key}` of `{name}` is missing")
    return kind(**found)


_known: dict[type, Mapping[str, tuple["Field[Any]", _Form]]] = {}


def _field_forms(kind: type[Any]) -> Mapping[str, tuple["Field[Any]", _Form]]:
    """Return field and form of each field of a record."""
    if kind not in _known:
        hints = get_type_hints(kind)
        _known[kind] = {field.name: (field, _form(hints[field.name])) for field in fields(kind)}
    return _known[kind]


def _form(hint: Any) -> _Form:  # noqa: ANN401 - a type or type expression, such as `int | None`
    """Return the form of the values of a type."""
    if hint in _SCALARS:
        return _SCALARS[hint]
    if isinstance(hint, UnionType):
        return _one_of(get_args(hint))
    if get_origin(hint) is tuple and get_args(hint)[1:] == (...,):
        return _sequence(_form(get_args(hint)[0]))
    if isinstance(hint, type) and issubclass(hint, Enum):
        return _Form(lambda value: value.value, lambda plain, name: _enum(hint, plain, name))
    if isinstance(hint, type) and is_dataclass(hint):
        return _Form(plain_record, lambda plain, name: record_from(hint, plain, name))
    raise TypeError(f"values of {hint} have no plain form")


def _one_of(kinds: tuple[Any, ...]) -> _Form:
    """Return the form of a union: of numbers, or of one type and None."""
    own = [kind for kind in kinds if kind is not NoneType]
    if len(own) == 1:
        form = _form(own[0])
        return _Form(
            lambda value: None if value is None else form.write(value),
            lambda plain, name: None if plain is None else form.read(plain, name),
        )

    if not set(own) <= {bool, int, float}:
        raise TypeError(f"values of {kinds} have no plain form")

    def read(plain: object, name: str) -> object:
        kind = next((kind for kind in (bool, int) if kind in own and type(plain) is kind), own[-1])
        return _form(kind).read(plain, name)

    return _Form(tagged, read)


def _sequence(form: _Form) -> _Form:
    return _Form(
        lambda values: [form.write(value) for value in values],
        lambda plain, name: tuple(form.read(value, name) for value in _typed(plain, list, name)),
    )


def number(plain: object, name: str) -> float:
    """Return a plain number as a float.

    Raises:
        DocumentError: it is none, or too large.
    """
    value = untagged(plain)
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise DocumentError(f"`{name}` is not a number")
    try:
        return float(value)
    except OverflowError as error:
        raise DocumentError(f"`{name}` is too large a number") from error


def _typed(plain: object, kind: type[T], name: str) -> T:
    if not isinstance(plain, kind) or (kind is int and isinstance(plain, bool)):
        raise DocumentError(f"`{name}` is a `{type(plain).__name__}`, not a `{kind.__name__}`")
    return plain


def _enum(kind: type[Enum], plain: object, name: str) -> Enum:
    found = next((one for one in kind if one.value == plain), None)
    if found is None or isinstance(plain, bool):
        known = ", ".join(f"`{one.value}`" for one in kind)
        raise DocumentError(f"`{name}` is `{str(plain)[:40]}`, known are {known}")
    return found


_SCALARS = {
    bool: _Form(bool, lambda plain, name: _typed(plain, bool, name)),
    int: _Form(int, lambda plain, name: _typed(plain, int, name)),
    float: _Form(lambda value: tagged(float(value)), number),
    str: _Form(str, lambda plain, name: _typed(plain, str, name)),
}
