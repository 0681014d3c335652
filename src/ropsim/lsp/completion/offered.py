"""Completions at the end of a line behind a text, for command lines without an editor."""

from collections.abc import Mapping
from pathlib import Path

from ropsim.lsp.analysis.workshop import Workshop
from ropsim.lsp.completion.offers import proposed
from ropsim.lsp.protocol.document import Document
from ropsim.lsp.protocol.parameters import Position

_WORD = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_"


def incomplete_word(line: str) -> str:
    """Return the incomplete word at the end of a line."""
    return line[len(line.rstrip(_WORD)) :]


def offered(
    text: str, line: str, place: Path, workshop: Workshop, unsaved: Mapping[Path, str] | None = None
) -> tuple[str, ...]:
    """Return the words that can end a line, as far as they begin like the word there, in their order.

    Args:
        text: text before the line.
        line: up to the place where one types.
        place: file that the text would have; the project around it supplies names.
        workshop: results for the texts there.
        unsaved: texts that count instead of files.
    """
    whole = f"{text}\n{line}"
    document = Document(place.absolute().as_uri(), 0, whole)
    documents = {
        uri: Document(uri, 0, content)
        for uri, content in ((path.absolute().as_uri(), content) for path, content in (unsaved or {}).items())
    }
    at = Position(whole.count("\n"), len(line.rpartition("\n")[2].encode("utf-16-le")) // 2)
    word = incomplete_word(line).lower()
    labels = sorted({str(one["label"]) for one in proposed(document, at, documents, workshop)})
    return tuple(label for label in labels if label.lower().startswith(word))
