"""Defaults of MJCF: attributes that the classes of a file add to its elements."""

from collections.abc import Mapping
from types import MappingProxyType

from ropsim.core import frozen_dataclass
from ropsim.exchange.files.xml_tree import Element
from ropsim.exchange.losses.diagnostics import SAME_ENTITY
from ropsim.exchange.losses.notes import Notes
from ropsim.exchange.mjcf.attributes import ACTUATORS, GENERAL, KNOWN

MAIN = "main"
"""The default class."""
_TURNS = ("quat", "axisangle", "xyaxes", "zaxis", "euler")
"""Attributes that say an orientation, each another way: one's own replaces that of the defaults."""
_ROWS = ("size", "gear", "damping", "stiffness")
"""Attributes of up to so many numbers: one's own replace the first ones of the defaults."""
_LONGEST_ROW = 7  # one more than any of these has, so that too many numbers are still seen
_NONE: Mapping[str, str] = MappingProxyType({})


@frozen_dataclass
class DefaultClass:
    """A class of defaults; what it does not change is that of the class above, and not copied.

    Attributes:
        own: by kind of element, the attributes of those that it changes, inherited ones included.
        above: class in which it stands; None for the outermost.
    """

    own: Mapping[str, Mapping[str, str]]
    above: "DefaultClass | None" = None

    def of(self, kind: str) -> Mapping[str, str]:
        """Return the attributes that the class gives to elements of a kind (`kind_of`)."""
        found: DefaultClass | None = self
        while found is not None:
            if kind in found.own:
                return found.own[kind]
            found = found.above
        return _NONE


Defaults = Mapping[str, DefaultClass]
"""Classes by name, with the main one."""


def kind_of(element: Element) -> str:
    """Return the name under which an element has its defaults: all actuators those of `general`."""
    return GENERAL if element.name in ACTUATORS else element.name


def merged(inherited: Mapping[str, str], own: Mapping[str, str]) -> dict[str, str]:
    """Return attributes with the inherited ones that they leave in force, as MuJoCo takes them over."""
    turned = any(key in own for key in _TURNS)
    kept = {key: text for key, text in inherited.items() if not (turned and key in _TURNS)}
    rows = {key: _laid_over(own[key], kept[key]) for key in _ROWS if key in own and key in kept}
    return {**kept, **own, **rows}


def _laid_over(own: str, inherited: str) -> str:
    """Return a row of numbers, and behind them those of a longer one."""
    count = len(own.split(maxsplit=_LONGEST_ROW)[:_LONGEST_ROW])
    rest = inherited.split(maxsplit=_LONGEST_ROW)[count:_LONGEST_ROW]
    return " ".join([own, *rest]) if rest else own


def defaults_of(root: Element, notes: Notes) -> Defaults:
    """Return the classes of a file, with the attributes that are read.

    A class takes over what stands in the one around it, before or after it; further outermost defaults extend
    the main class for the classes that come after them.
    """
    found = {MAIN: DefaultClass({})}
    waiting = [(one, MAIN) for one in reversed(root.all("default"))]
    while waiting:
        element, around = waiting.pop()
        name = element.attributes.get("class", MAIN)
        if name == MAIN:
            main = found[MAIN]
            found[MAIN] = DefaultClass({**main.own, **_changes(element, main)})
        else:
            if name in found:
                words = f"two classes have the name `{name}`"
                notes.add(SAME_ENTITY, element.span, words, "give each its own name")
            found[name] = DefaultClass(_changes(element, found[around]), found[around])
        waiting += [(one, name) for one in reversed(element.all("default"))]
    return found


def _changes(element: Element, above: DefaultClass) -> dict[str, Mapping[str, str]]:
    """Return by kind the attributes of elements that a class changes, inherited ones included."""
    found: dict[str, Mapping[str, str]] = {}
    for one in element.children:
        kind = kind_of(one)
        known = KNOWN.get(kind, frozenset())
        if known:
            read = {key: text for key, text in one.attributes.items() if key in known}
            found[kind] = MappingProxyType(merged(found.get(kind) or above.of(kind), read))
    return found
