"""Macros that are called: their parameters take values, elements and the contents of elements."""

from abc import ABC, abstractmethod

from ropsim.exchange.files.xml_tree import Element
from ropsim.exchange.xacro.formulas.values import XacroError
from ropsim.exchange.xacro.macros import Macro, Parameter, Sort, macro_of
from ropsim.exchange.xacro.scope import Scope
from ropsim.exchange.xacro.texts import Texts


class Calls(Texts, ABC):
    """Definitions and calls of macros."""

    @abstractmethod
    def _elements(self, elements: tuple[Element, ...], scope: Scope, depth: int) -> list[Element]:
        """Return the expansion of elements."""

    def _macro(self, one: Element, scope: Scope, _depth: int) -> list[Element]:
        scope.give_macro(macro_of(one))
        return []

    def _call_by_name(self, one: Element, scope: Scope, depth: int) -> list[Element]:
        return self._call(self._need(one, "macro", scope), one, scope, depth)

    def _call(self, name: str, one: Element, scope: Scope, depth: int) -> list[Element]:
        macro, outer = scope.macro(name)
        with self._deeper():
            return self._expanded_call(macro, one, outer, depth)

    def _expanded_call(self, macro: Macro, one: Element, outer: Scope, depth: int) -> list[Element]:
        """Return the elements that a call of a macro expands to."""
        inner = Scope(self, outer)
        self._check(macro, one)
        values = [parameter for parameter in macro.parameters if parameter.sort is Sort.VALUE]
        for parameter in values:
            if parameter.name in one.attributes:
                inner.give(parameter.name, self.evaluated(one.attributes[parameter.name], outer))
        self._give_blocks(macro, self._elements(one.children, outer, depth + 1), inner)
        for parameter in values:
            if parameter.name not in one.attributes:
                self._give_default(parameter, outer, inner)
        found = self._elements(macro.body, inner, depth + 1)
        self._texts_of(macro.text, inner)
        return found

    def _check(self, macro: Macro, one: Element) -> None:
        """Raise `XacroError` if a call passes a parameter that the macro does not have."""
        known = [parameter.name for parameter in macro.parameters if parameter.sort is Sort.VALUE]
        for key in one.attributes:
            if (
                key not in known
                and not key.startswith("xmlns")
                and (key, one.name) != ("macro", "xacro:call")
            ):
                hint = f"it has {', '.join(known)}" if known else "it has none"
                raise XacroError(f"macro `{macro.name[:60]}` has no parameter `{key[:60]}`", hint)

    def _give_blocks(self, macro: Macro, elements: list[Element], inner: Scope) -> None:
        """Pass the elements of a call to the blocks of a macro in order, each whole or as its children."""
        wanted = [parameter for parameter in macro.parameters if parameter.sort is not Sort.VALUE]
        for parameter, element in zip(wanted, elements, strict=False):
            whole = parameter.sort is Sort.ELEMENT
            passed = (element,) if whole else element.children
            inner.give_block(parameter.name, parameter.sort, passed)
        if len(elements) < len(wanted):
            missing = wanted[len(elements)].name
            raise XacroError(f"the call lacks the block `{missing}`", "put the element into the call")
        if len(elements) > len(wanted):
            extra = elements[len(wanted)].name
            words = f"macro `{macro.name[:60]}` takes {len(wanted)} blocks, the call has `{extra[:60]}` too"
            raise XacroError(words, "take the element out of the call")

    def _give_default(self, parameter: Parameter, outer: Scope, inner: Scope) -> None:
        if parameter.inherits and outer.has(parameter.name):
            inner.give(parameter.name, outer.value(parameter.name))
            return
        if parameter.default is None:
            raise XacroError(f"the call lacks the parameter `{parameter.name}`", "give it as an attribute")
        inner.give(parameter.name, self.evaluated(parameter.default, outer))

    def _texts_of(self, text: str, scope: Scope) -> None:
        """Evaluate the text of an element for its messages and refusals; no robot is read from it."""
        if "$" in text:
            self._text(text, scope)
