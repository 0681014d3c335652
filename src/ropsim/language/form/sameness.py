"""Whether two statements are the same wherever they stand in their lines."""

from dataclasses import fields, is_dataclass
from functools import cache
from typing import Any

_PLACES = frozenset(("start", "end"))


def shape(node: object) -> object:
    """Return a statement or a part of it without its places: equal shapes mean the same."""
    if isinstance(node, tuple):
        return tuple(map(shape, node))
    kind: type[Any] = type(node)
    if not is_dataclass(kind):
        return node
    return (kind, *(shape(getattr(node, name)) for name in _parts(kind)))


@cache
def _parts(kind: type[Any]) -> tuple[str, ...]:
    """Return the fields of a node that are no places."""
    return tuple(one.name for one in fields(kind) if one.name not in _PLACES)
