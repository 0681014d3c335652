"""XML of a robot file as a tree of elements with their places; entities and document types are refused."""

from collections.abc import Mapping
from dataclasses import field
from types import MappingProxyType
from xml.parsers import expat

from ropsim.core import SourceText, Span, frozen_dataclass
from ropsim.exchange.losses.diagnostics import NOT_XML, XML_REFUSED
from ropsim.exchange.losses.gathered import shown
from ropsim.exchange.losses.notes import Notes

MOST_CHARACTERS = 20_000_000
"""Of one file."""
MOST_ELEMENTS = 30_000
"""Of one file, including the results of its macros."""
MOST_DEPTH = 200
"""Elements in each other; a body of MJCF stands in the one that carries it."""
MOST_ATTRIBUTES = 1_000
"""Of one element; of MJCF, the largest has some sixty."""
MOST_ATTRIBUTE = 20_000
"""Characters of an attribute."""


@frozen_dataclass
class Element:
    """An element of a file.

    Attributes:
        name: with its prefix, such as `xacro:macro`.
        attributes: texts by name.
        children: elements in it.
        span: its opening tag.
        text: the characters between its tags, of all children put together; empty for blanks alone.
    """

    name: str
    attributes: Mapping[str, str]
    children: tuple["Element", ...]
    span: Span
    text: str = field(default="")

    def all(self, name: str) -> tuple["Element", ...]:
        """Return the children of a name."""
        return tuple(one for one in self.children if one.name == name)

    def first(self, name: str) -> "Element | None":
        """Return the first child of a name."""
        return next((one for one in self.children if one.name == name), None)


class _RefusedError(Exception):
    """The file is not read any further."""


class _Open:
    """An element whose end has not come."""

    def __init__(self, name: str, attributes: Mapping[str, str], span: Span) -> None:
        self.name, self.attributes, self.span = name, attributes, span
        self.children: list[Element] = []
        self.words: list[str] = []

    def closed(self) -> Element:
        text = "".join(self.words).strip()
        return Element(self.name, MappingProxyType(self.attributes), tuple(self.children), self.span, text)


class _Builder:
    """Callbacks of the parser."""

    def __init__(self, source: SourceText, notes: Notes) -> None:
        self._source, self._notes = source, notes
        self._stack: list[_Open] = []
        self._count = 0
        self.root: Element | None = None
        self.parser = parser = expat.ParserCreate("utf-8")
        parser.buffer_text = True
        parser.StartDoctypeDeclHandler = lambda *_: self._refuse("has a document type")
        parser.EntityDeclHandler = lambda *_: self._refuse("defines an entity")
        parser.StartElementHandler = self._start
        parser.EndElementHandler = self._end
        parser.CharacterDataHandler = self._words

    def place(self, length: int = 1) -> Span:
        return self._source.span(self.parser.CurrentLineNumber, self.parser.CurrentColumnNumber + 1, length)

    def _refuse(self, why: str, hint: str = "take it out: a robot needs none") -> None:
        self._notes.add(XML_REFUSED, self.place(), f"the file {why}", hint)
        raise _RefusedError

    def _start(self, name: str, attributes: dict[str, str]) -> None:
        self._count += 1
        if self._count > MOST_ELEMENTS:
            self._refuse(f"has more than {MOST_ELEMENTS} elements", "cut it down to the robot")
        if len(self._stack) >= MOST_DEPTH:
            self._refuse(f"has elements more than {MOST_DEPTH} deep", "allowed are fewer in each other")
        if len(attributes) > MOST_ATTRIBUTES:
            self._refuse(f"has an element with more than {MOST_ATTRIBUTES} attributes", "cut it down")
        long = next((key for key, value in attributes.items() if len(value) > MOST_ATTRIBUTE), None)
        if long is not None:
            self._refuse(
                f"has the attribute `{shown(long)}` with more than {MOST_ATTRIBUTE} characters", "cut it down"
            )
        self._stack.append(_Open(name, attributes, self.place(len(name) + 1)))

    def _end(self, _name: str) -> None:
        made = self._stack.pop().closed()
        if self._stack:
            self._stack[-1].children.append(made)
        else:
            self.root = made

    def _words(self, text: str) -> None:
        if self._stack:
            self._stack[-1].words.append(text)


def read_xml(source: SourceText, notes: Notes) -> Element | None:
    """Return the outermost element of a file; nothing where it is not XML or is refused (noted).

    Time and memory are linear in the length of the file (expat; its document types are never read).
    """
    if len(source.text) > MOST_CHARACTERS:
        hint = "cut it down to the robot"
        notes.add(XML_REFUSED, source.span(1), f"the file has more than {MOST_CHARACTERS} characters", hint)
        return None
    builder = _Builder(source, notes)
    try:
        builder.parser.Parse(source.text.encode("utf-8", "surrogatepass"), True)  # noqa: FBT003  the last part
    except expat.ExpatError as error:
        words = expat.ErrorString(error.code) or "damaged"
        span = source.span(max(error.lineno, 1), error.offset + 1)
        notes.add(NOT_XML, span, f"the file is not XML from here on: {words}", "close what is open before it")
        return None
    except _RefusedError:
        return None
    return builder.root
