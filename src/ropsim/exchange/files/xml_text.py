"""XML as written: one canonical text for the same elements."""

import re
from collections.abc import Iterable

from ropsim.core import frozen_dataclass

_ILLEGAL = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
_ESCAPES = {"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "\t": "&#9;", "\n": "&#10;", "\r": "&#13;"}


@frozen_dataclass
class Tag:
    """An element to be written.

    Attributes:
        name: of the element.
        attributes: names and texts, in the order in which they are written.
        children: in their order.
        text: between the tags of an element without children.
    """

    name: str
    attributes: tuple[tuple[str, str], ...] = ()
    children: tuple["Tag", ...] = ()
    text: str = ""


def tag(name: str, attributes: Iterable[tuple[str, str]] = (), *children: Tag) -> Tag:
    """Return an element with attributes and children."""
    return Tag(name, tuple(attributes), children)


def value(name: str, text: str) -> Tag:
    """Return an element that holds a text."""
    return Tag(name, text=text)


def xml_text(root: Tag) -> str:
    """Return the text of a document: two blanks for each depth, a line for each element."""
    lines = ['<?xml version="1.0"?>']
    waiting: list[tuple[int, Tag | str]] = [(0, root)]
    while waiting:
        depth, one = waiting.pop()
        blanks = "  " * depth
        if isinstance(one, str):
            lines.append(f"{blanks}</{one}>")
            continue
        attributes = "".join(f' {key}="{escaped(value)}"' for key, value in one.attributes)
        inside = f">{escaped(one.text)}</{one.name}>" if one.text else "/>"
        lines.append(f"{blanks}<{one.name}{attributes}{'>' if one.children else inside}")
        if one.children:
            waiting.append((depth, one.name))
            waiting += [(depth + 1, child) for child in reversed(one.children)]
    return "\n".join(lines) + "\n"


def escaped(text: str) -> str:
    """Return a text in the form of an attribute; characters that XML cannot hold become underscores."""
    return "".join(_ESCAPES.get(letter, letter) for letter in _ILLEGAL.sub("_", text))


def number(value: float) -> str:
    """Return the shortest text of a number that is read back to its last bit."""
    if value == int(value) and abs(value) < 1e15:
        return str(int(value))
    return repr(float(value))


def numbers(values: Iterable[float]) -> str:
    """Return numbers with blanks between them."""
    return " ".join(number(value) for value in values)
