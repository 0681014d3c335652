"""The other programs of the project of a document: open ones, and files on the disk."""

from collections.abc import Iterator, Mapping
from pathlib import Path

from ropsim.lsp.analysis.workshop import Workshop
from ropsim.lsp.protocol.document import Document
from ropsim.userfiles import read_project_text

#: A folder with more programs is not searched to its end.
MOST = 500


def is_program(document: Document) -> bool:
    """Return whether a document is a text of the task language."""
    return document.is_program


def programs_of(
    document: Document, documents: Mapping[str, Document], workshop: Workshop
) -> Iterator[Document]:
    """Yield the programs of the project of a document, open ones with their text in the editor."""
    folder = workshop.surroundings(document, documents).folder
    if folder is None:
        yield from (document,) if is_program(document) else ()
        return
    opened = {one.path: one for one in documents.values()}
    found = {place: opened[place] for place in opened if place is not None and _is_in(place, folder)}
    yield from (one for one in found.values() if is_program(one))
    for place in _files(folder):
        if place not in found:
            text, _ = read_project_text(folder, f"programs/{place.name}", str(place))
            if text is not None:
                yield Document(place.absolute().as_uri(), 0, text.text, document.encoding)


def _is_in(place: Path, folder: Path) -> bool:
    return place.parent == folder / "programs" or place.parent == folder


def _files(folder: Path) -> tuple[Path, ...]:
    try:
        return tuple(sorted((folder / "programs").glob("*.task"))[:MOST])
    except OSError:
        return ()
