"""The sections of a cell file: as a list of its entities, and as folding ranges."""

from collections.abc import Iterator
from itertools import pairwise

from ropsim.cellfile import NAMED
from ropsim.lsp.cell.place import places_in
from ropsim.lsp.protocol.document import Document
from ropsim.lsp.protocol.messages import Json
from ropsim.tomltext import Path, Positions

#: Numbers of the protocol: module, object, field.
_SECTION, _THING = 2, 19


def cell_symbols(document: Document) -> list[Json]:
    """Return the sections of a cell file in order, each thing by its name; none where it is no TOML."""
    places = places_in(document)
    if places is None:
        return []
    found = []
    for _, last, path in _sections(document, places):
        selected = document.range_of(places.keys[path])
        is_thing = len(path) > 1
        found.append(
            {
                "name": _name(document, places, path),
                "detail": str(path[0]) if is_thing else "",
                "kind": _THING if is_thing else _SECTION,
                "range": {
                    "start": selected["start"],
                    "end": document.position(last, len(document.line(last))),
                },
                "selectionRange": selected,
            }
        )
    return found


def cell_folds(document: Document) -> list[Json]:
    """Return the lines of the sections of a cell file that fill more than one."""
    places = places_in(document)
    if places is None:
        return []
    return [
        {"startLine": first, "endLine": last, "kind": "region"}
        for first, last, _ in _sections(document, places)
        if first < last
    ]


def _sections(document: Document, places: Positions) -> Iterator[tuple[int, int, Path]]:
    """Yield first and last line (from 0) and path of each section; no blank lines and remarks behind it."""
    headers: dict[int, Path] = {}
    for path, span in places.keys.items():
        line = document.line(span.line - 1)
        if line[span.column - 1 :].startswith("[") and not line[: span.column - 1].strip():
            known = headers.get(span.line - 1, ())
            headers[span.line - 1] = path if len(path) >= len(known) else known
    lines = [*sorted(headers), len(document.starts)]
    for first, behind in pairwise(lines):
        last = behind - 1
        while last > first and document.line(last).lstrip()[:1] in ("", "#"):
            last -= 1
        yield first, last, headers[first]


def _name(document: Document, places: Positions, path: Path) -> str:
    """Return the name of a section: of its entity, or the name that it defines."""
    given = places.values.get((*path, "name"))
    if given is not None and path[0] not in NAMED:
        line = document.line(given.line - 1)
        return line[given.column - 1 : given.end_column - 1].strip("\"'") or str(path[0])
    return ".".join(str(one) for one in path[1:] or path)
