"""The XML of a COLLADA file as elements by name and identity; document types and entities are refused."""

from collections.abc import Iterator, Mapping
from xml.parsers import expat

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.meshes.formats.soup import Floats, Indices, damaged

MOST_ELEMENTS = 200_000
"""Of one file."""
MOST_DEPTH = 100
"""Elements in each other."""


@frozen_dataclass
class Element:
    """An element of a file, without name spaces.

    Attributes:
        name: of the element.
        attributes: texts by name.
        children: elements in it, in order.
        text: parts of the characters in it.
    """

    name: str
    attributes: Mapping[str, str]
    children: list["Element"]
    text: list[str]

    def all(self, name: str) -> Iterator["Element"]:
        """Yield the children of a name."""
        return (one for one in self.children if one.name == name)

    def first(self, *names: str) -> "Element | None":
        """Return the element at a path of names, the first at each step."""
        found: Element | None = self
        for name in names:
            found = next(found.all(name), None) if found else None
        return found

    @property
    def words(self) -> str:
        """Return the characters in it."""
        return "".join(self.text)

    def numbers(self) -> Floats:
        """Return the numbers in its text, shape (k,).

        Raises:
            MeshFileError: a word is no number.
        """
        try:
            return np.array(self.words.split(), np.float64)
        except (ValueError, OverflowError):
            raise damaged(f"has words in `{self.name[:40]}` that are not numbers") from None

    def places(self) -> Indices:
        """Return the whole numbers in its text, shape (k,).

        Raises:
            MeshFileError: a word is no whole number.
        """
        try:
            return np.array(self.words.split(), np.int64)
        except (ValueError, OverflowError):
            raise damaged(f"has words in `{self.name[:40]}` that are not whole numbers") from None


class Document:
    """A COLLADA file: its outermost element, and all elements that have an identity.

    Attributes:
        root: the outermost element.
    """

    def __init__(self, root: Element, by_id: Mapping[str, Element]) -> None:
        self.root, self._by_id = root, by_id

    def target(self, reference: str, name: str) -> Element | None:
        """Return the element that `#identity` refers to, if it has a name; files are not followed."""
        found = self._by_id.get(reference[1:]) if reference.startswith("#") else None
        return found if found is not None and found.name == name else None


class _Builder:
    """Callbacks of the parser."""

    def __init__(self) -> None:
        self._stack: list[Element] = []
        self._count = 0
        self.root: Element | None = None
        self.by_id: dict[str, Element] = {}
        self.parser = parser = expat.ParserCreate(namespace_separator=" ")
        parser.buffer_text = True
        parser.StartDoctypeDeclHandler = self._refuse
        parser.EntityDeclHandler = self._refuse
        parser.StartElementHandler = self._start
        parser.EndElementHandler = self._end
        parser.CharacterDataHandler = self._words

    def _refuse(self, *_: object) -> None:
        raise damaged("has a document type, which is not read")

    def _start(self, name: str, attributes: dict[str, str]) -> None:
        self._count += 1
        if self._count > MOST_ELEMENTS or len(self._stack) >= MOST_DEPTH:
            raise damaged(
                f"has more than {MOST_ELEMENTS:,} elements, or more than {MOST_DEPTH} in each other"
            )
        made = Element(name.rpartition(" ")[2], attributes, [], [])
        if self._stack:
            self._stack[-1].children.append(made)
        else:
            self.root = made
        self._stack.append(made)
        if "id" in attributes:
            self.by_id.setdefault(attributes["id"], made)

    def _end(self, _name: str) -> None:
        self._stack.pop()

    def _words(self, text: str) -> None:
        self._stack[-1].text.append(text)


def read_document(content: bytes) -> Document:
    """Return the elements of a file; time and memory are linear in its length.

    Raises:
        MeshFileError: it is not XML, not COLLADA, or too deep.
    """
    builder = _Builder()
    try:
        builder.parser.Parse(content, True)  # noqa: FBT003  the last part
    except expat.ExpatError as error:
        why = expat.ErrorString(error.code) or "damaged"
        raise damaged(f"is not XML from line {error.lineno} on: {why}") from None
    except (ValueError, LookupError) as error:  # an encoding that Python does not know
        raise damaged(f"cannot be read as XML: {str(error)[:60]}") from None
    if builder.root is None or builder.root.name != "COLLADA":
        raise damaged("is no COLLADA file")
    return Document(builder.root, builder.by_id)
