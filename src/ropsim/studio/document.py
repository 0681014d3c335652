"""A text of the project: what its file has, what the page has, and whether they agree."""

import hashlib
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath
from typing import Literal

from ropsim.studio.line_ends import plain_lines, restored
from ropsim.studio.messages import DocumentState
from ropsim.userfiles import Draft

LARGEST = 5_000_000
"""Longest text [bytes], as for every reader of projects."""

BOM = b"\xef\xbb\xbf"

_LANGUAGES: dict[str, Literal["task", "toml", "icr", "prolog"]] = {
    ".toml": "toml",
    ".icr": "icr",
    ".pl": "prolog",
}


@dataclass(slots=True)
class Document:
    """One text.

    Attributes:
        name: path inside the project.
        path: of its file.
        text: newest text, with line feeds only.
        disk: content of the file when it was read last, None where there is none.
        version: of the editing tab, 0 for the text of the file.
        conflict: the file has changed while there was unsaved text.
        recovered: the text comes from the journal.
        unreadable: the file is there but the system does not let it be read.
    """

    name: str
    path: Path
    disk: bytes | None
    text: str = field(init=False)
    version: int = 0
    conflict: bool = False
    recovered: bool = False
    unreadable: bool = False
    _saved: str | None = field(init=False)

    def __post_init__(self) -> None:
        self.text = ""
        self.take_file(self.disk)

    @property
    def unsaved(self) -> bool:
        """Return whether the text differs from the file."""
        return self.text != self._saved

    @property
    def problem(self) -> str:
        """Return in words why this text cannot be edited, empty where it can."""
        if self.unreadable:
            return f"`{self.name}` may not be read"
        if self.disk is not None and len(self.disk) > LARGEST:
            return f"`{self.name}` has more than {LARGEST / 1e6:.0f} MB"
        if self.disk is not None and "�" in self.text and not _is_utf8(self.disk):
            return f"`{self.name}` is no UTF-8 text"
        return ""

    @property
    def draft(self) -> Draft:
        """Return the text for the journal."""
        return Draft(self.text, hashlib.sha256(self.disk).hexdigest() if self.disk is not None else "")

    def take_file(self, content: bytes | None) -> None:
        """Hold the file's text and no other."""
        self._read(content)
        self.text = self._saved or ""
        self.version, self.conflict, self.recovered = 0, False, False

    def meet_file(self, content: bytes | None) -> None:
        """Learn that the file has another content now, or none; unsaved text stays, in conflict with it."""
        if not self.unsaved:
            self.take_file(content)
            return
        self._read(content)
        self.conflict = self.unsaved

    def lose_file(self) -> None:
        """Learn that the whole project folder is gone: the text stays, and belongs to no file any more."""
        self._read(None)
        self.conflict = False

    def recover(self, draft: Draft) -> None:
        """Take unsaved text from the journal."""
        self.conflict = draft.base != self.draft.base
        self.text = draft.text
        self.recovered = True

    def edit(self, text: str, version: int) -> None:
        """Take a new text from the page."""
        self.text = plain_lines(text)
        self.version = version
        self.recovered = False
        self.conflict = self.conflict and self.unsaved

    def content(self) -> bytes:
        """Return the bytes to write: line ends and byte order mark as the file had them."""
        if self.disk is None:
            return self.text.encode()
        mark = BOM if self.disk.startswith(BOM) else b""
        return mark + restored(self.text, _decoded(self.disk)).encode()

    def saved(self, content: bytes) -> None:
        """Learn that the text was written as `content`."""
        self._read(content)
        self.conflict, self.recovered = False, False

    def state(self, text: str | None) -> DocumentState:
        """Return the state as pages see it, with the given text or none."""
        language = _LANGUAGES.get(PurePosixPath(self.name).suffix, "task")
        return DocumentState(
            self.name,
            self.path.as_uri(),
            language,
            text,
            self.version,
            self.unsaved,
            self.conflict,
            self.recovered,
        )

    def _read(self, content: bytes | None) -> None:
        self.disk = content
        self._saved = plain_lines(_decoded(content)) if content is not None else None


def _decoded(content: bytes) -> str:
    return content[:LARGEST].decode("utf-8-sig", "replace")


def _is_utf8(content: bytes) -> bool:
    try:
        content.decode("utf-8")
    except UnicodeDecodeError:
        return False
    return True
