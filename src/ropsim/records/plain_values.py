"""Plain values for JSON: mappings of figures, including numbers that are not finite.

JSON has no NaN and no infinity. For people and other programs they become the texts `NaN`,
`Infinity` and `-Infinity`; in files that ropsim reads again, the mapping `{"$number": "NaN"}`.
"""

import math
from collections.abc import Callable, Mapping
from dataclasses import fields, is_dataclass
from enum import Enum

import numpy as np

TAG = "$number"
"""Key of the mapping that stands for a number that is not finite."""

DEPTH = 50
"""Values nested deeper than this are refused."""

Spelling = Callable[[str], object]
Keys = tuple[str | int, ...]
Fallback = Callable[[object, Keys], object]
Rules = tuple[Spelling, Fallback]

_WORDS = {"NaN": math.nan, "Infinity": math.inf, "-Infinity": -math.inf}


class NotPlainError(TypeError):
    """A value has no plain form; the message names its place and type."""


def readable(value: object) -> object:
    """Return a plain form of any value for strict JSON, for people and other programs.

    Numbers that are not finite become texts, arrays lists, enums their values, records mappings of their
    fields and of those properties that are single values, and anything unknown its `str`.
    """
    return _plain(value, (), _READABLE)


def tagged(value: object) -> object:
    """Return a plain form for strict JSON from which `untagged` makes the value again.

    Sequences and arrays become lists.

    Raises:
        NotPlainError: the value, or one inside it, has no plain form.
    """
    return _plain(value, (), _TAGGED)


def numeric(value: object) -> object:
    """Return a plain form as `readable` does, with null for every number that is not finite."""
    return _plain(value, (), _NULLED)


def untagged(value: object) -> object:
    """Return the value of which `tagged` made a plain form."""
    if isinstance(value, list):
        return [untagged(entry) for entry in value]
    if isinstance(value, dict):
        word = value.get(TAG)
        if len(value) == 1 and isinstance(word, str) and word in _WORDS:
            return _WORDS[word]
        return {key: untagged(entry) for key, entry in value.items()}
    return value


def word_of(number: float) -> str:
    """Return the word for a number that is not finite."""
    if math.isnan(number):
        return "NaN"
    return "Infinity" if number > 0.0 else "-Infinity"


def _plain(value: object, keys: Keys, rules: Rules) -> object:
    if value is None or isinstance(value, (str, bool)):
        return value
    if isinstance(value, (float, int)):
        return value if math.isfinite(value) else rules[0](word_of(value))
    if isinstance(value, (list, tuple)) and len(keys) <= DEPTH:
        return [_plain(entry, (*keys, index), rules) for index, entry in enumerate(value)]
    if isinstance(value, dict) and len(keys) <= DEPTH and all(isinstance(key, str) for key in value):
        return {key: _plain(entry, (*keys, key), rules) for key, entry in value.items()}
    if isinstance(value, (np.ndarray, np.generic)) and value.dtype.kind in "biufU":
        return _plain(value.tolist(), keys, rules)
    if isinstance(value, Mapping) and not isinstance(value, dict):
        return _plain(dict(value), keys, rules)
    return rules[1](value, keys)


def _refuse(value: object, keys: Keys) -> object:
    place = "".join(f"[{key!r}]" for key in keys)
    raise NotPlainError(f"value{place} is a `{type(value).__name__}`")


def _record_or_text(value: object, keys: Keys) -> object:
    if isinstance(value, Enum):
        return _plain(value.value, keys, _READABLE)
    if len(keys) > DEPTH:
        return str(value)
    if isinstance(value, Mapping):
        return _plain({str(key): entry for key, entry in value.items()}, keys, _READABLE)
    if not is_dataclass(value) or isinstance(value, type):
        return str(value)
    names = [field.name for field in fields(value)]
    properties = {
        name: getattr(value, name)
        for name, member in vars(type(value)).items()
        if isinstance(member, property)
    }
    single = {name: entry for name, entry in properties.items() if isinstance(entry, (bool, int, float, str))}
    return _plain({**{name: getattr(value, name) for name in names}, **single}, keys, _READABLE)


def _tag(word: str) -> object:
    return {TAG: word}


def _null(word: str) -> object:
    del word
    return None


def _word(word: str) -> object:
    return word


_READABLE: Rules = (_word, _record_or_text)
_TAGGED: Rules = (_tag, _refuse)
_NULLED: Rules = (_null, _record_or_text)
