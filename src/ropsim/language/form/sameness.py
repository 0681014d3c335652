"""Whether two statements are the same wherever they stand in their lines, and the names in them."""

from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from typing import Any

from ropsim.language.syntax.nodes import Name

_PLACES = frozenset(("start", "end", "opening", "closing"))


def shape(node: object) -> object:
    """Return a statement or a part of it without its places: equal shapes mean the same."""
    if isinstance(node, tuple):
        return tuple(map(shape, node))
    kind: type[Any] = type(node)
    parts = _parts(kind)
    return node if parts is None else (kind, *[shape(getattr(node, name)) for name in parts])


def names_in(node: object) -> Iterator[tuple[int, str]]:
    """Yield where the names in a statement begin, and the names, whose letters may not change their case."""
    if isinstance(node, Name):
        yield node.start, node.text
    elif isinstance(node, tuple):
        for one in node:
            yield from names_in(one)
    else:
        for name in _parts(type(node)) or ():
            yield from names_in(getattr(node, name))


_parts_of: dict[type[Any], tuple[str, ...] | None] = {}


def _parts(kind: type[Any]) -> tuple[str, ...] | None:
    """Return the fields of a node that are no places; None for other types."""
    if kind not in _parts_of:
        _parts_of[kind] = (
            tuple(one.name for one in fields(kind) if one.name not in _PLACES) if is_dataclass(kind) else None
        )
    return _parts_of[kind]
