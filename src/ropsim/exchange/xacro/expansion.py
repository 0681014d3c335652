"""Xacro is expanded: elements with the prefix `xacro:` are carried out, texts of all others are put in."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from types import MappingProxyType

from ropsim.core import SourceText, Span, near
from ropsim.exchange.files.folder import ReadOptions
from ropsim.exchange.files.xml_tree import Element, read_xml
from ropsim.exchange.losses.diagnostics import XACRO
from ropsim.exchange.losses.gathered import listed, shown
from ropsim.exchange.losses.notes import Notes
from ropsim.exchange.xacro.calls import Calls
from ropsim.exchange.xacro.formulas.values import XacroError, literal, truth, unquoted
from ropsim.exchange.xacro.macros import Sort
from ropsim.exchange.xacro.scope import IncludedScope, Scope
from ropsim.model import REQUEST

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
            notes.add(XACRO, error.span, error.message, error.hint, error.data)
        return None


def refuse_arguments(options: ReadOptions, source: SourceText, notes: Notes) -> None:
    """Note that arguments are given for a file that is no xacro file: they would have no effect."""
    if options.arguments:
        words = f"the file takes no arguments, given are {listed(options.arguments)}"
        asked = {REQUEST: ("arg",)}
        notes.add(XACRO, source.span(1), words, "leave `--arg` out, in a cell file `arg`", asked)


class _PlacedError(Exception):
    def __init__(self, span: Span, message: str, hint: str, data: Mapping[str, object] | None = None) -> None:
        super().__init__(message)
        self.span, self.message, self.hint, self.data = span, message, hint, data


class _Expansion(Calls):
    def __init__(self, options: ReadOptions, notes: Notes) -> None:
        super().__init__(options, notes)
        self._open: list[dict[str, str]] = []  # attributes of the elements around
        self._known: Mapping[str, Callable[[Element, Scope, int], list[Element]]] = {
            "arg": self._arg,
            "property": self._property,
            "macro": self._macro,
            "include": self._include,
            "if": self._if,
            "unless": self._unless,
            "insert_block": self._insert,
            "call": self._call_by_name,
            "element": self._named_element,
            "attribute": self._attribute,
        }

    def file(self, root: Element) -> Element:
        scope = Scope(self)
        if root.name.startswith(PREFIX):
            raise _PlacedError(root.span, f"the outermost element is `{root.name}`", "put it into a `robot`")
        # its attributes come last: they name arguments whose defaults stand in it
        self._open.append({})
        children = tuple(self._elements(root.children, scope, 1))
        added = self._open.pop()
        bare = Element(root.name, root.attributes, (), root.span, root.text)
        made = self._elements((bare,), scope, 0)[0]
        self._check_given(root.span)
        return replace(made, attributes=MappingProxyType({**made.attributes, **added}), children=children)

    def _check_given(self, span: Span) -> None:
        """Refuse arguments that the file does not have: they would have no effect."""
        for name in self._given:
            if name not in self._asked:
                close = near(name, self._asked, limit=1)
                known = listed(sorted(self._asked)) or "none"
                hint = f"did you mean `{close[0]}`?" if close else f"arguments of the file: {known}"
                words = f"the file has no argument `{shown(name)}`"
                raise _PlacedError(span, words, hint, {REQUEST: ("arg", name)})

    def _elements(self, elements: tuple[Element, ...], scope: Scope, depth: int) -> list[Element]:
        """Return the expansion of elements."""
        found: list[Element] = []
        for one in elements:
            try:
                self._step(depth, one)
                if one.name.startswith(PREFIX):
                    found += self._special(one, one.name.removeprefix(PREFIX), scope, depth)
                else:
                    found.append(self._plain(one, one.name, scope, depth))
            except XacroError as error:
                raise _PlacedError(one.span, error.message, error.hint) from None
        return found

    def _plain(self, one: Element, name: str, scope: Scope, depth: int) -> Element:
        attributes = {}
        for key, text in one.attributes.items():
            if not key.startswith(("xmlns", PREFIX)):
                attributes[key] = self._text(text, scope)
                self.spend(len(attributes[key]))
        self._make()
        self._open.append(attributes)
        children = tuple(self._elements(one.children, scope, depth + 1))
        self._open.pop()
        self._texts_of(one.text, scope)
        return Element(name, MappingProxyType(attributes), children, one.span, one.text)

    def _special(self, one: Element, name: str, scope: Scope, depth: int) -> list[Element]:
        known = self._known.get(name)
        return known(one, scope, depth) if known else self._call(name, one, scope, depth)

    def _named_element(self, one: Element, scope: Scope, depth: int) -> list[Element]:
        """Return an element whose name is computed; it may be one of xacro."""
        name = self._need(one, "xacro:name", scope)
        if not name:
            raise XacroError("`xacro:element` has an empty name", "write the name of an element")
        rest = {key: text for key, text in one.attributes.items() if key != "xacro:name"}
        named = replace(one, name=name, attributes=MappingProxyType(rest))
        return self._elements((named,), scope, depth + 1)

    def _attribute(self, one: Element, scope: Scope, _depth: int) -> list[Element]:
        """Set an attribute with a computed name on the element around it."""
        name, value = (self._need(one, key, scope) for key in ("name", "value"))
        if not name:
            raise XacroError("`xacro:attribute` has an empty name", "write the name of an attribute")
        self._open[-1][name] = value
        self.spend(len(value))
        return []

    def _arg(self, one: Element, scope: Scope, _depth: int) -> list[Element]:
        name = self._need(one, "name", scope)
        self._asked.add(name)
        if "default" in one.attributes and name not in self._arguments:
            self._arguments[name] = self._text(one.attributes["default"], scope)
        return []

    def _property(self, one: Element, scope: Scope, _depth: int) -> list[Element]:
        name = self._need(one, "name", scope)
        removed = self._flag(one, "remove", scope, default="false")
        if removed + ("value" in one.attributes) + ("default" in one.attributes) > 1:
            words = f"the property `{name[:60]}` has more than one of `value`, `default` and `remove`"
            raise XacroError(words, "write one of them")
        if removed:
            scope.remove(name)
            return []
        if "default" in one.attributes and scope.has(name):
            return []
        others = {"parent": scope.above, "global": scope.outermost}
        where = others.get(one.attributes.get("scope", ""))
        text = one.attributes.get("value", one.attributes.get("default"))
        if text is None:
            (where or scope).give_block(name, Sort.CONTENT, one.children)
        elif where is None and self._flag(one, "lazy_eval", scope, default="true"):
            scope.define(name, unquoted(text))
        else:
            (where or scope).give(name, self.evaluated(text, scope))
        return []

    def _flag(self, one: Element, key: str, scope: Scope, default: str) -> bool:
        return truth(self._text(one.attributes.get(key, default), scope))

    def _if(self, one: Element, scope: Scope, depth: int) -> list[Element]:
        return self._contents(one, scope, depth) if self._holds(one, scope) else []

    def _unless(self, one: Element, scope: Scope, depth: int) -> list[Element]:
        return [] if self._holds(one, scope) else self._contents(one, scope, depth)

    def _contents(self, one: Element, scope: Scope, depth: int) -> list[Element]:
        found = self._elements(one.children, scope, depth + 1)
        self._texts_of(one.text, scope)
        return found

    def _holds(self, one: Element, scope: Scope) -> bool:
        if "value" not in one.attributes:
            raise XacroError(f"`{one.name}` has no `value`", 'write value="..." into it')
        return truth(self.evaluated(one.attributes["value"], scope))

    def _insert(self, one: Element, scope: Scope, depth: int) -> list[Element]:
        return self._elements(scope.block(self._need(one, "name", scope)), scope, depth + 1)

    def _include(self, one: Element, scope: Scope, depth: int) -> list[Element]:
        name = self._need(one, "filename", scope)
        if any(sign in name for sign in "*?["):
            words = f"the file `{shown(name)}` is a pattern of several files, which are not looked for"
            raise XacroError(words, "include each file by its name")
        inner = scope
        if one.attributes.get("ns"):
            inner = IncludedScope(self, scope)
            scope.give(self._need(one, "ns", scope), inner)
        try:
            path, text = self._text_of_file(name)
        except XacroError:
            if literal(one.attributes.get("optional", "")) is True:
                return []
            raise
        with self._deeper():
            root = read_xml(SourceText(self._folder.name_of(path), text), self._notes)
            if root is None:
                raise XacroError(f"the file `{shown(path)}` cannot be read")
            self._beside.append(path.rpartition("/")[0])
            found = self._contents(root, inner, depth)
            self._beside.pop()
        return found
