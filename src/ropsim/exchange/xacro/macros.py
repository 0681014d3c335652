"""Macros and their parameters."""

import re
from enum import Enum

from ropsim.core import frozen_dataclass
from ropsim.exchange.files.xml_tree import Element
from ropsim.exchange.xacro.formulas.values import XacroError

_PARAMETER = re.compile(
    r"\s*(?P<stars>\*{0,2})(?P<name>[^\s:=*'\"]+)"
    r"(?:\s*(?P<assign>:?=)\s*(?P<above>\^\|?)?"
    r"(?P<default>\$\{[^}]*\}|\$\([^)]*\)|(?:'[^']*'|\"[^\"]*\"|[^\s'\"])+)?)?(?=\s|$)"
)


class Sort(Enum):
    """Kind of argument of a parameter."""

    VALUE = "value"
    ELEMENT = "element"
    CONTENT = "content of an element"


@frozen_dataclass
class Parameter:
    """A parameter of a macro.

    Attributes:
        name: of it.
        sort: kind of argument: an attribute, an element of the call, or the contents of one with that name.
        default: text; None where there is none.
        inherits: whether it takes the value visible at the call if the call passes none.
    """

    name: str
    sort: Sort
    default: str | None = None
    inherits: bool = False


@frozen_dataclass
class Macro:
    """A macro: its parameters, and the elements and text that it stands for."""

    name: str
    parameters: tuple[Parameter, ...]
    body: tuple[Element, ...]
    text: str = ""


def macro_of(element: Element) -> Macro:
    """Return the macro that an element defines.

    Raises:
        XacroError: it has no name, or its parameters cannot be read.
    """
    name = element.attributes.get("name", "").removeprefix("xacro:")
    if not name:
        raise XacroError("a macro has no name", "write name=... into it")
    text = element.attributes.get("params", "")
    found = []
    place = 0
    while text[place:].strip():
        match = _PARAMETER.match(text, place)
        if match is None:
            raise XacroError(
                f"the parameters of macro `{name[:60]}` cannot be read from `{text[place:][:40].strip()}`"
            )
        found.append(_parameter(match))
        place = match.end()
    return Macro(name, tuple(found), element.children, element.text)


def _parameter(match: re.Match[str]) -> Parameter:
    sort = (Sort.VALUE, Sort.ELEMENT, Sort.CONTENT)[len(match.group("stars"))]
    return Parameter(match.group("name"), sort, match.group("default") or None, bool(match.group("above")))
