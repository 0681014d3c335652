"""Attributes of MJCF that are `true`, `false` or, some of them, `auto`; and flags that enable and disable."""

from enum import Enum

from ropsim.exchange.files.xml_tree import Element
from ropsim.exchange.losses.diagnostics import BAD_NUMBER
from ropsim.exchange.losses.gathered import listed, shown
from ropsim.exchange.losses.notes import Notes


class Keyword(Enum):
    """Value of an attribute or a flag; with `auto`, other data of the file decide."""

    TRUE = "true"
    FALSE = "false"
    AUTO = "auto"
    ENABLE = "enable"
    DISABLE = "disable"


_TRUTH = (Keyword.TRUE, Keyword.FALSE)
_SWITCHES = (Keyword.ENABLE, Keyword.DISABLE)


def keyword_of(element: Element, key: str, notes: Notes) -> Keyword:
    """Return the value of an attribute that may be `auto`; it is `auto` if missing or wrong (noted)."""
    return _keyword_of(element, key, notes, (*_TRUTH, Keyword.AUTO), Keyword.AUTO)


def says(element: Element, key: str, notes: Notes, default: Keyword = Keyword.FALSE) -> bool:
    """Return whether an attribute is `true`, which no other may decide.

    Args:
        element: with the attribute `key`, or without it.
        key: of the attribute.
        notes: for a word that is none of both; the default stands in its place.
        default: if the attribute is missing.
    """
    return _keyword_of(element, key, notes, _TRUTH, default) is Keyword.TRUE


def switch_of(flag: Element, key: str, notes: Notes, before: Keyword) -> Keyword:
    """Return the value of a flag of `option`; `before` if it is missing or wrong (noted)."""
    return _keyword_of(flag, key, notes, _SWITCHES, before)


def _keyword_of(
    element: Element, key: str, notes: Notes, allowed: tuple[Keyword, ...], default: Keyword
) -> Keyword:
    text = element.attributes.get(key)
    if text is None:
        return default
    words = {one.value: one for one in allowed}
    if text not in words:
        message = f'`{element.name}` has {key}="{shown(text)}", allowed are {listed(words)}'
        notes.add(BAD_NUMBER, element.span, message, "write one of these words")
    return words.get(text, default)
