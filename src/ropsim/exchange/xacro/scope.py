"""Properties by name, as they can be seen from a place in a file; they are evaluated when they are used."""

from collections.abc import Callable

from ropsim.core import near
from ropsim.exchange.files.xml_tree import Element
from ropsim.exchange.xacro.operators import CONSTANTS
from ropsim.exchange.xacro.values import Value, XacroError

MOST_ASKED = 30
"""Properties that are defined by each other in a row."""

Evaluate = Callable[[str, "Scope"], Value]
"""The value of a text with substitutions in it."""


Load = Callable[[str], Value]
"""The value of a parameter file by its path."""


class Scope:
    """Properties and blocks of the file, or of one call of a macro."""

    def __init__(self, evaluate: Evaluate, load: Load, above: "Scope | None" = None) -> None:
        self._evaluate, self._load, self._above = evaluate, load, above
        self._texts: dict[str, str] = {}
        self._values: dict[str, Value] = {}
        self._asked: list[str] = above._asked if above else []
        self.blocks: dict[str, tuple[Element, ...]] = {}

    @property
    def outermost(self) -> "Scope":
        """Return the scope of the file."""
        scope = self
        while scope._above is not None:
            scope = scope._above
        return scope

    @property
    def above(self) -> "Scope":
        """Return the scope around this one; that of the file itself."""
        return self._above or self

    def define(self, name: str, text: str) -> None:
        """Set the text of a property, which is evaluated on request."""
        self._values.pop(name, None)
        self._texts[name] = text

    def give(self, name: str, value: Value) -> None:
        """Set the value of a property."""
        self._texts.pop(name, None)
        self._values[name] = value

    def has(self, name: str) -> bool:
        """Return whether a property can be seen from here."""
        return any(name in scope._texts or name in scope._values for scope in self._all())

    def block(self, name: str) -> tuple[Element, ...]:
        """Return the elements of a block.

        Raises:
            XacroError: there is none of that name.
        """
        for scope in self._all():
            if name in scope.blocks:
                return scope.blocks[name]
        raise XacroError(f"there is no block `{name[:60]}`", "a macro has it as *name in its params")

    def value(self, name: str) -> Value:
        """Return the value of a property.

        Raises:
            XacroError: it has no value, or depends on itself.
        """
        for scope in self._all():
            if name in scope._values:
                return scope._values[name]
            if name in scope._texts:
                return scope._found(name)
        if name in CONSTANTS:
            return CONSTANTS[name]
        known = [one for scope in self._all() for one in (*scope._texts, *scope._values)]
        close = near(name, known, limit=1)
        hint = f"did you mean `{close[0]}`?" if close else "define it by xacro:property or as a parameter"
        raise XacroError(f"nobody has defined `{name[:60]}`", hint)

    def loaded(self, path: str) -> Value:
        """Return the value of a parameter file.

        Raises:
            XacroError: it cannot be had.
        """
        return self._load(path)

    def _found(self, name: str) -> Value:
        if len(self._asked) >= MOST_ASKED:
            words = f"the property `{name[:60]}` is defined by itself, or in more than {MOST_ASKED} steps"
            raise XacroError(words, "give it a value of its own")
        self._asked.append(name)
        try:
            value = self._evaluate(self._texts[name], self)
        finally:
            self._asked.pop()
        self._values[name] = value
        return value

    def _all(self) -> "list[Scope]":
        found: list[Scope] = [self]
        while found[-1]._above is not None:
            found.append(found[-1]._above)
        return found
