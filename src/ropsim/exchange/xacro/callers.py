"""A file that only defines macros, opened in place of one that calls them: its macros, and who calls them."""

import re
from collections.abc import Sequence

from ropsim.core import near
from ropsim.exchange.files.folder import RobotFolder
from ropsim.exchange.files.xml_tree import Element
from ropsim.exchange.losses.diagnostics import ELEMENT_MISSING
from ropsim.exchange.losses.gathered import listed
from ropsim.exchange.losses.notes import Notes

MOST_FILES = 100
"""Most files in the folder of a robot file that are searched."""
_ENDING = ".xacro"


def macros_of(root: Element) -> tuple[str, ...]:
    """Return the names of the macros that a file defines itself."""
    names = (one.attributes.get("name", "") for one in root.children if one.name == "xacro:macro")
    return tuple(name.removeprefix("xacro:") for name in names if name)


def note_macros(root: Element, folder: RobotFolder, notes: Notes) -> None:
    """Note that a file without links only defines macros, with the files in its folder that call them.

    Args:
        root: the file before expansion, with macros.
        folder: in which it is.
        notes: for the error.
    """
    macros = macros_of(root)
    words = f"the file only defines macros, {listed(macros)}: a robot is made where they are called"
    own = root.span.source.replace("\\", "/").rpartition("/")[2]
    files = _callers(macros, own, folder)
    best = near(own, files, limit=1) or files[:1]
    hint = f"open {listed([*best, *files], 3)}" if files else "open the file that calls them"
    if files:
        hint += ", which calls them" if len(files) == 1 else ", which call them"
    notes.add(ELEMENT_MISSING, root.span, words, hint, {"macros": macros, "callers": files})


def _callers(macros: Sequence[str], own: str, folder: RobotFolder) -> tuple[str, ...]:
    """Return the names of other files in the folder of the robot file that call one of some macros."""
    called = re.compile(rf"<xacro:(?:{'|'.join(map(re.escape, macros))})[\s/>]")
    found = []
    for name in folder.names_beside(_ENDING)[:MOST_FILES]:
        path = folder.path(name) if name != own else None
        text = folder.text(path) if path else None
        if text is not None and called.search(text):
            found.append(name)
    return tuple(found)
