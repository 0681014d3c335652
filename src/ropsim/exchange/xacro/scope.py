"""Properties, blocks and macros by name, as a place in a file sees them; a used property is evaluated."""

from typing import Protocol

from ropsim.core import near
from ropsim.exchange.files.xml_tree import Element
from ropsim.exchange.xacro.formulas.functions import CONSTANTS
from ropsim.exchange.xacro.formulas.names import FileOfNames
from ropsim.exchange.xacro.formulas.values import Value, XacroError
from ropsim.exchange.xacro.macros import Macro, Sort

MOST_ASKED = 30
"""Properties that are defined by each other in a row."""


class FileOfScopes(FileOfNames, Protocol):
    """Services of the file that is expanded for its scopes."""

    def has_argument(self, name: str) -> bool:
        """Return whether an argument has a value."""
        ...

    def evaluated(self, text: str, scope: "Scope") -> Value:
        """Return the value of a text with substitutions in it.

        Raises:
            XacroError: something in it cannot be evaluated.
        """
        ...


class Scope:
    """Names of the file, of one call of a macro, or of a file that is included with `ns`."""

    def __init__(self, file: FileOfScopes, above: "Scope | None" = None) -> None:
        self._file, self._above = file, above
        self._texts: dict[str, str] = {}
        self._values: dict[str, Value] = {}
        self._asked: list[str] = above._asked if above else []
        self._blocks: dict[tuple[Sort, str], tuple[Element, ...]] = {}
        self._macros: dict[str, Macro] = {}

    @property
    def file(self) -> FileOfScopes:
        """Return the file that is expanded."""
        return self._file

    @property
    def outermost(self) -> "Scope":
        """Return the scope of the file."""
        return self._all()[-1]

    @property
    def above(self) -> "Scope":
        """Return the scope of the caller; that of the file itself.

        From the call of a macro, scopes of included files are passed over: the caller is meant.
        """
        found = self._above
        while found is not None and isinstance(found, IncludedScope) and not isinstance(self, IncludedScope):
            found = found._above
        return found or self

    def define(self, name: str, text: str) -> None:
        """Set the text of a property, which is evaluated on request."""
        self._values.pop(name, None)
        self._texts[name] = text

    def give(self, name: str, value: Value) -> None:
        """Set the value of a property."""
        self._texts.pop(name, None)
        self._values[name] = value

    def give_block(self, name: str, sort: Sort, elements: tuple[Element, ...]) -> None:
        """Set the elements of a block: a whole element, or the contents of one."""
        self._blocks[sort, name] = elements

    def give_macro(self, macro: Macro) -> None:
        """Define a macro."""
        self._macros[macro.name] = macro

    def remove(self, name: str) -> None:
        """Remove a property from this scope and from the scopes around it."""
        for scope in self._all():
            scope._texts.pop(name, None)
            scope._values.pop(name, None)

    def has(self, name: str) -> bool:
        """Return whether a property can be seen from here."""
        return name in CONSTANTS or any(name in one._texts or name in one._values for one in self._all())

    def block(self, name: str) -> tuple[Element, ...]:
        """Return the elements of a block; contents, also of outer scopes, come before whole elements.

        Raises:
            XacroError: there is none of that name.
        """
        for sort in (Sort.CONTENT, Sort.ELEMENT):
            for scope in self._all():
                if (sort, name) in scope._blocks:
                    return scope._blocks[sort, name]
        raise XacroError(f"there is no block `{name[:60]}`", "a macro has it as *name in its params")

    def macro(self, name: str) -> "tuple[Macro, Scope]":
        """Return a macro, and the scope that it is called in: for `space.name` that of the included file.

        Raises:
            XacroError: there is none of that name.
        """
        for scope in self._all():
            if name in scope._macros:
                return scope._macros[name], self
        space, dot, rest = name.partition(".")
        inner = self.value(space) if dot and self.has(space) else None
        if isinstance(inner, IncludedScope):
            return inner.macro(rest)
        close = near(name, [one for scope in self._all() for one in scope._macros], limit=1)
        hint = f"did you mean `{close[0]}`?" if close else "define it before it is called"
        raise XacroError(f"there is no macro `{name[:60]}`", hint)

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

    def _found(self, name: str) -> Value:
        if len(self._asked) >= MOST_ASKED:
            words = f"the property `{name[:60]}` is defined by itself, or in more than {MOST_ASKED} steps"
            raise XacroError(words, 'give it a value of its own, or write lazy_eval="false"')
        self._asked.append(name)
        try:
            value = self._file.evaluated(self._texts[name], self)
        finally:
            self._asked.pop()
        self._values[name] = value
        return value

    def _all(self) -> "list[Scope]":
        found: list[Scope] = [self]
        while found[-1]._above is not None:
            found.append(found[-1]._above)
        return found


class IncludedScope(Scope):
    """Names of a file that is included with `ns`; others see them behind that name and a dot."""
