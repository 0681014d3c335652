"""Xacro is expanded: elements with the prefix `xacro:` are carried out, texts of all others are put in."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from types import MappingProxyType

from ropsim.core import SourceText, Span
from ropsim.exchange.files.folder import ReadOptions
from ropsim.exchange.files.xml_tree import Element, read_xml
from ropsim.exchange.losses.diagnostics import XACRO
from ropsim.exchange.losses.notes import Notes, shown
from ropsim.exchange.xacro.macros import Macro, Parameter, Sort, macro_of
from ropsim.exchange.xacro.scope import Scope
from ropsim.exchange.xacro.texts import Texts
from ropsim.exchange.xacro.values import XacroError, truth

PREFIX = "xacro:"


def uses_xacro(root: Element) -> bool:
    """Return whether a file has to be expanded."""
    return "xmlns:xacro" in root.attributes or any(one.name.startswith(PREFIX) for one in root.children)


def expanded(root: Element, options: ReadOptions, notes: Notes) -> Element | None:
    """Return a file with all macros expanded; None if one cannot be (noted)."""
    expansion = _Expansion(options, notes)
    try:
        return expansion.file(root)
    except _PlacedError as error:
        if not notes.fatal:
            notes.add(XACRO, error.span, error.message, error.hint)
        return None


class _PlacedError(Exception):
    def __init__(self, span: Span, message: str, hint: str) -> None:
        super().__init__(message)
        self.span, self.message, self.hint = span, message, hint


class _Expansion(Texts):
    def __init__(self, options: ReadOptions, notes: Notes) -> None:
        super().__init__(options)
        self._notes = notes
        self._macros: dict[str, Macro] = {}
        self._known: Mapping[str, Callable[[Element, Scope, int], list[Element]]] = {
            "arg": self._arg,
            "property": self._property,
            "macro": self._macro,
            "include": self._include,
            "if": self._if,
            "unless": self._unless,
            "insert_block": self._insert,
            "call": self._call_by_name,
        }

    def file(self, root: Element) -> Element:
        scope = Scope(self._value, self._loaded)
        if root.name.startswith(PREFIX):
            raise _PlacedError(root.span, f"the outermost element is `{root.name}`", "put it into a `robot`")
        # its attributes come last: they name arguments whose defaults stand in it
        children = tuple(self._elements(root.children, scope, 1))
        bare = Element(root.name, root.attributes, (), root.span, root.text)
        return replace(self._elements((bare,), scope, 0)[0], children=children)

    def _elements(self, elements: tuple[Element, ...], scope: Scope, depth: int) -> list[Element]:
        """Return the expansion of elements."""
        found: list[Element] = []
        for one in elements:
            try:
                self._step(depth)
                if one.name.startswith(PREFIX):
                    found += self._special(one, one.name.removeprefix(PREFIX), scope, depth)
                else:
                    found.append(self._plain(one, scope, depth))
            except XacroError as error:
                raise _PlacedError(one.span, error.message, error.hint) from None
        return found

    def _plain(self, one: Element, scope: Scope, depth: int) -> Element:
        attributes = {}
        for key, text in one.attributes.items():
            if not key.startswith("xmlns"):
                attributes[key] = self._text(text, scope)
                self._spend(len(attributes[key]))
        self._make()
        children = tuple(self._elements(one.children, scope, depth + 1))
        return Element(one.name, MappingProxyType(attributes), children, one.span, one.text)

    def _special(self, one: Element, name: str, scope: Scope, depth: int) -> list[Element]:
        known = self._known.get(name)
        return known(one, scope, depth) if known else self._call(name, one, scope, depth)

    def _arg(self, one: Element, scope: Scope, _depth: int) -> list[Element]:
        name = self._need(one, "name", scope)
        if name not in self._given and "default" in one.attributes and name not in self._arguments:
            self._arguments[name] = self._text(one.attributes["default"], scope)
        return []

    def _property(self, one: Element, scope: Scope, _depth: int) -> list[Element]:
        name = self._need(one, "name", scope)
        where = {"parent": scope.above, "global": scope.outermost}.get(one.attributes.get("scope", ""), scope)
        if "default" in one.attributes and scope.has(name):
            return []
        text = one.attributes.get("value", one.attributes.get("default"))
        if text is None:
            where.blocks[name] = one.children
        elif where is scope:
            where.define(name, text)
        else:
            where.give(name, self._value(text, scope))
        return []

    def _macro(self, one: Element, _scope: Scope, _depth: int) -> list[Element]:
        macro = macro_of(one)
        self._macros[macro.name] = macro
        return []

    def _if(self, one: Element, scope: Scope, depth: int) -> list[Element]:
        return self._elements(one.children, scope, depth + 1) if self._holds(one, scope) else []

    def _unless(self, one: Element, scope: Scope, depth: int) -> list[Element]:
        return [] if self._holds(one, scope) else self._elements(one.children, scope, depth + 1)

    def _holds(self, one: Element, scope: Scope) -> bool:
        if "value" not in one.attributes:
            raise XacroError(f"`{one.name}` has no `value`", 'write value="..." into it')
        return truth(self._value(one.attributes["value"], scope))

    def _insert(self, one: Element, scope: Scope, depth: int) -> list[Element]:
        return self._elements(scope.block(self._need(one, "name", scope)), scope, depth + 1)

    def _include(self, one: Element, scope: Scope, depth: int) -> list[Element]:
        name = self._need(one, "filename", scope)
        if "ns" in one.attributes:
            raise XacroError("files are not included into a name space", "take `ns` out of the include")
        try:
            path, text = self._text_of_file(name)
        except XacroError:
            if one.attributes.get("optional", "false") == "true":
                return []
            raise
        self._deeper()
        root = read_xml(SourceText(path, text), self._notes)
        if root is None:
            raise XacroError(f"the file `{shown(path)}` cannot be read")
        self._beside.append(path.rpartition("/")[0])
        found = self._elements(root.children, scope, depth + 1)
        self._beside.pop()
        self._calls -= 1
        return found

    def _call_by_name(self, one: Element, scope: Scope, depth: int) -> list[Element]:
        return self._call(self._need(one, "macro", scope), one, scope, depth)

    def _call(self, name: str, one: Element, scope: Scope, depth: int) -> list[Element]:
        macro = self._macros.get(name)
        if macro is None:
            raise XacroError(f"there is no macro `{name[:60]}`", "define it before it is called")
        self._deeper()
        inner = Scope(self._value, self._loaded, scope)
        given = [parameter.name for parameter in macro.parameters if parameter.sort is Sort.VALUE]
        for key in one.attributes:
            if key not in given and not (key == "macro" and one.name == "xacro:call"):
                raise XacroError(
                    f"macro `{name[:60]}` has no parameter `{key[:60]}`", f"it has {', '.join(given)}"
                )
        blocks = list(one.children)
        for parameter in macro.parameters:
            if parameter.sort is Sort.VALUE:
                self._give(parameter, one, scope, inner)
            else:
                inner.blocks[parameter.name] = self._block(parameter, blocks, scope, depth)
        found = self._elements(macro.body, inner, depth + 1)
        self._calls -= 1
        return found

    def _give(self, parameter: Parameter, one: Element, scope: Scope, inner: Scope) -> None:
        text = one.attributes.get(parameter.name)
        if text is None and parameter.inherits and scope.has(parameter.name):
            inner.give(parameter.name, scope.value(parameter.name))
            return
        if text is None:
            text = parameter.default
        if text is None:
            raise XacroError(f"the call lacks the parameter `{parameter.name}`", "give it as an attribute")
        inner.give(parameter.name, self._value(text, scope))

    def _block(
        self, parameter: Parameter, blocks: list[Element], scope: Scope, depth: int
    ) -> tuple[Element, ...]:
        """Return the elements passed for a block: the next one, or the contents of the one with its name."""
        for place, one in enumerate(blocks):
            if parameter.sort is Sort.ELEMENT or one.name == parameter.name:
                del blocks[place]
                whole = (one,) if parameter.sort is Sort.ELEMENT else one.children
                return tuple(self._elements(whole, scope, depth + 1))
        raise XacroError(f"the call lacks the block `{parameter.name}`", "put the element into the call")
