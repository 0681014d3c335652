"""Methods of texts, lists and dictionaries; none changes its owner, and no result grows without bound."""

from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType
from typing import Any

from ropsim.exchange.xacro.formulas.values import LONGEST, Value, XacroError, key_of


def _replaced(text: str, old: str, new: str, count: int = -1) -> str:
    found = text.count(old) if count < 0 else min(count, text.count(old))
    _fits(len(text) + found * len(new))
    return text.replace(old, new, count)


def _joined(text: str, parts: Sequence[str]) -> str:
    _fits(sum(len(part) + len(text) for part in parts))
    return text.join(parts)


def _widened(method: Callable[..., str]) -> Callable[..., str]:
    def made(text: str, width: int, *fill: str) -> str:
        _fits(width)
        return method(text, width, *fill)

    return made


def _fits(length: int) -> None:
    if length > LONGEST:
        raise XacroError(f"a text becomes more than {LONGEST} characters", "make it shorter")


def _of(kind: type, *names: str) -> dict[str, Callable[..., Any]]:
    return {name: getattr(kind, name) for name in names}


_TEXT = (
    _of(str, "split", "rsplit", "splitlines", "strip", "lstrip", "rstrip", "partition", "rpartition")
    | _of(str, "lower", "upper", "capitalize", "title", "swapcase", "removeprefix", "removesuffix")
    | _of(str, "startswith", "endswith", "find", "rfind", "index", "rindex", "count")
    | _of(str, "isdigit", "isdecimal", "isnumeric", "isalpha", "isalnum", "isspace", "islower", "isupper")
    | {"replace": _replaced, "join": _joined}
    | {name: _widened(getattr(str, name)) for name in ("zfill", "ljust", "rjust", "center")}
)
_LIST = _of(list, "index", "count", "copy")
_DICTIONARY: dict[str, Callable[..., Any]] = {
    "get": lambda owner, key, default=None: owner.get(key_of(key), default),
    "copy": dict.copy,
    "keys": list,
    "values": lambda owner: list(owner.values()),
    "items": lambda owner: list(owner.items()),
    "has_key": lambda owner, key: key_of(key) in owner,
}
METHODS: Mapping[type, tuple[str, Mapping[str, Callable[..., Any]]]] = MappingProxyType(
    {
        str: ("a text", MappingProxyType(_TEXT)),
        list: ("a list", MappingProxyType(_LIST)),
        tuple: ("a list", MappingProxyType(_of(tuple, "index", "count"))),
        dict: ("a dictionary", MappingProxyType(_DICTIONARY)),
    }
)
"""Methods by the type of their owner, with the noun for it."""


def method_of(owner: Value, name: str) -> Callable[..., Any]:
    """Return a method of a value.

    Raises:
        XacroError: it has no method of that name that is carried out.
    """
    noun, methods = METHODS.get(type(owner), ("that value", MappingProxyType({})))
    if name not in methods:
        hint = f"methods of {noun} are {', '.join(sorted(methods))}" if methods else "write the value itself"
        raise XacroError(f"{noun} has no method `{name[:40]}` that is carried out", hint)
    return methods[name]
