"""The texts of the lists of points of a project, and the lists that its programs can use."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import field
from pathlib import Path

from ropsim.core import Diagnostic, SourceText, frozen_dataclass
from ropsim.language import NO_LIST_NAMES, PointTable
from ropsim.model import Cell

POINTS, LIST_ENDING = "points", ".csv"
"""Name of the folder in a project, and the ending of lists in it."""


@frozen_dataclass
class PointTexts:
    """Texts of lists of points.

    Attributes:
        texts: by the name of the list, in their order.
        findings: errors in the folder.
        unread: names of the texts that cannot be read, by the name of the list.
    """

    texts: Mapping[str, SourceText]
    findings: tuple[Diagnostic, ...] = ()
    unread: Mapping[str, str] = field(default_factory=dict)


NO_POINTS = PointTexts({})


@frozen_dataclass
class ReadTable:
    """Result of reading a list: its points, None if programs cannot name it, and the findings."""

    table: PointTable | None
    diagnostics: tuple[Diagnostic, ...]


def read_point_texts(folder: Path, named: Callable[[str], str] = lambda place: place) -> PointTexts:
    """Return the texts of the lists of a project.

    Args:
        folder: of the project.
        named: the name that spans are to use, by the place in the project.
    """
    if not any((folder / POINTS).glob(f"*{LIST_ENDING}")):
        return NO_POINTS
    from ropsim.tasks import point_files, point_text_of  # its engine takes a tenth of a start

    texts: dict[str, SourceText] = {}
    findings: list[Diagnostic] = []
    unread: dict[str, str] = {}
    for path in point_files(folder):
        text, found = point_text_of(folder, path, label := named(f"{POINTS}/{path.name}"))
        findings += found
        if text is None:
            unread[path.stem] = label
        else:
            texts[path.stem] = text
    return PointTexts(texts, tuple(findings), unread)


def read_table(text: SourceText, name: str) -> ReadTable:
    """Return a list of points for programs."""
    from ropsim.tasks import POINT_LIST_NAME, point_table, points_of

    found, findings = points_of(text, name)
    if not name.isidentifier() or not name.isascii() or name.lower() in NO_LIST_NAMES:
        message = f"programs cannot name the list `{name[:80]}`"
        hint = "name the file with letters, digits and `_`, and no word of the language"
        return ReadTable(None, (*findings, POINT_LIST_NAME.at(text.span(1), message, hint=hint)))
    if found is None or any(one.is_error for one in findings):
        return ReadTable(PointTable((), source=text.name), findings)
    return ReadTable(point_table(found, text.name), findings)


def taken_names(texts: Mapping[str, SourceText], cell: Cell) -> Iterator[Diagnostic]:
    """Yield a finding for each list whose name something of the cell has: programs mean that."""
    from ropsim.tasks import POINT_LIST_NAME

    tables = (
        ("a frame", cell.frames),
        ("a tool", cell.tools),
        ("a location", cell.locations),
        ("a signal", cell.signals),
    )
    for name, text in texts.items():
        what = next((what for what, table in tables if name in table), "")
        if what:
            message = f"`{name}` is {what} of the cell: programs cannot name the list"
            yield POINT_LIST_NAME.at(text.span(1), message, hint="give the file another name")
