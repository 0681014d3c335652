"""Included files of MJCF, inside of the given folders; paths count from the folder of the main file."""

from dataclasses import replace

from ropsim.core import SourceText, Span
from ropsim.exchange.files.folder import RobotFolder
from ropsim.exchange.files.xml_tree import MOST_DEPTH, MOST_ELEMENTS, Element, read_xml
from ropsim.exchange.losses.diagnostics import ELEMENT_MISSING, XML_REFUSED
from ropsim.exchange.losses.gathered import shown
from ropsim.exchange.losses.notes import Notes

MOST_FILES = 200
"""Maximum number of included files, each once, as in MuJoCo."""


def with_included(root: Element, folder: RobotFolder, notes: Notes) -> Element | None:
    """Return a file with the contents of its included files; None if one cannot be read (noted)."""
    return _Includer(folder, notes).expanded(root, 1)


class _Includer:
    def __init__(self, folder: RobotFolder, notes: Notes) -> None:
        self._folder, self._notes = folder, notes
        self._seen: set[str] = set()
        self._count = 0

    def expanded(self, element: Element, depth: int) -> Element | None:
        """Return an element with the children of included files in the place of each `include`."""
        self._count += 1
        if self._count > MOST_ELEMENTS or depth > MOST_DEPTH:
            self._refuse(element.span, "with what it includes the file is too large or too deep")
            return None
        children: list[Element] = []
        for one in element.children:
            if one.name == "include":
                root = self._included(one)
                made = self.expanded(root, depth) if root else None
                children += made.children if made else ()
            else:
                made = self.expanded(one, depth + 1)
                children += (made,) if made else ()
            if made is None:
                return None
        return replace(element, children=tuple(children))

    def _included(self, one: Element) -> Element | None:
        name = one.attributes.get("file", "")
        path = self._folder.path(name)
        text = self._folder.text(path) if path else None
        if path is None or text is None:
            words = f"the included file `{shown(name)}` is not there, or not inside of the given folders"
            self._notes.add(ELEMENT_MISSING, one.span, words, "put it beside the robot file")
            return None
        if path in self._seen or len(self._seen) >= MOST_FILES:
            self._refuse(one.span, f"`{shown(name)}` is included twice, or after {MOST_FILES} others")
            return None
        self._seen.add(path)
        return read_xml(SourceText(self._folder.name_of(path), text), self._notes)

    def _refuse(self, span: Span, words: str) -> None:
        self._notes.add(XML_REFUSED, span, words, "cut it down to the robot")
