"""A text of the project: the content of its file, the content of the page, and whether they agree."""

import hashlib
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath
from typing import Literal

from ropsim.core import Diagnostic, LeadsOutError, outside_project
from ropsim.studio.diagnostics import NOT_EDITABLE, NOT_SAVED
from ropsim.studio.texts.line_ends import plain_lines, restored
from ropsim.studio.wire.messages import DocumentState
from ropsim.userfiles import Draft

LARGEST = 5_000_000
"""Longest text [bytes], as for every reader of projects."""

MOST_SAVES = 16
"""Saves that an edit may be overtaken by on its way from the page."""

BOM = b"\xef\xbb\xbf"

_LANGUAGES: dict[str, Literal["task", "toml", "icr", "prolog"]] = {
    ".toml": "toml",
    ".icr": "icr",
    ".pl": "prolog",
}


@dataclass(slots=True)
class Document:
    """One text.

    The base decides about conflicts: it names the content of the file on which the text was written. It
    changes only where the text is written to the file or taken from it, and the journal keeps it.

    Attributes:
        name: path inside the project.
        path: of its file.
        text: newest text, with line feeds only.
        disk: content of the file when it was read last, None where there is none.
        base: SHA-256 of the content on which the text was written, empty for no file.
        version: of the editing tab, 0 for the text of the file.
        homeless: the project folder was removed, so that there is no file to be in conflict with.
        recovered: the text comes from the journal.
        refusal: why the file is not shown, None where it is.
    """

    name: str
    path: Path
    disk: bytes | None
    text: str = field(init=False)
    base: str = field(init=False)
    version: int = 0
    homeless: bool = False
    recovered: bool = False
    refusal: Diagnostic | None = None
    _saved: str | None = field(init=False)
    _on_disk: str = field(init=False)
    _form: bytes = field(init=False, default=b"")
    _written_over: tuple[str, ...] = field(init=False, default=())

    def __post_init__(self) -> None:
        self.take_file(self.disk)

    @property
    def unsaved(self) -> bool:
        """Return whether the text differs from the file."""
        return self.text != self._saved

    @property
    def conflict(self) -> bool:
        """Return whether the file has another content than that on which the unsaved text was written."""
        return self.unsaved and not self.homeless and self.base != self._on_disk

    @property
    def problem(self) -> Diagnostic | None:
        """Return why this text cannot be edited, None where it can."""
        if self.refusal is not None or self.disk is None:
            return self.refusal
        if len(self.disk) > LARGEST:
            return not_editable(f"`{self.name}` has more than {LARGEST / 1e6:.0f} MB")
        if "�" in self.text and not _is_utf8(self.disk):
            return not_editable(f"`{self.name}` is no UTF-8 text")
        return None

    @property
    def draft(self) -> Draft:
        """Return the text for the journal."""
        return Draft(self.text, self.base)

    def take_file(self, content: bytes | None) -> None:
        """Hold the file's text and no other."""
        self._read(content)
        self.text = self._saved or ""
        self.base = self._on_disk
        self.version, self.recovered = 0, False
        self._written_over = ()

    def meet_file(self, content: bytes | None) -> None:
        """Note that the file has another content now, or none. A text that the file does not have stays."""
        if content is not None and not self.unsaved:
            self.take_file(content)
            return
        self._read(content)
        self.homeless = False
        self._settle()

    def lose_file(self) -> None:
        """Note that the whole project folder was removed: the text stays, and belongs to no file any more."""
        self._read(None)
        self.homeless = True

    def recover(self, draft: Draft) -> None:
        """Take unsaved text from the journal."""
        self.text, self.base = draft.text, draft.base
        self.recovered = True
        self._settle()

    def edit(self, text: str, version: int, base: str | None) -> None:
        """Take a new text from the page.

        Args:
            text: all of it.
            version: of the tab.
            base: on which the page has written it; None for that of this document.
        """
        self.text = plain_lines(text)
        self.version = version
        self.recovered = False
        # an edit on its way while the text before it was saved was based on the content before that save
        if base is not None and base not in self._written_over:
            self.base = base
        self._settle()

    def content(self) -> bytes:
        """Return the bytes to write: line ends and byte order mark as the file has them, or had them last."""
        mark = BOM if self._form.startswith(BOM) else b""
        return mark + restored(self.text, _decoded(self._form)).encode()

    def saved(self, content: bytes) -> None:
        """Note that the text was written as `content`."""
        self._written_over = (*self._written_over, self.base)[-MOST_SAVES:]
        self._read(content)
        self.base = self._on_disk
        self.homeless, self.recovered = False, False

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
            self.base,
        )

    def _read(self, content: bytes | None) -> None:
        self.disk = content
        self._on_disk = "" if content is None else hashlib.sha256(content).hexdigest()
        self._saved = plain_lines(_decoded(content)) if content is not None else None
        self._form = self._form if content is None else content

    def _settle(self) -> None:
        """Stand on the file where that has the very text."""
        if not self.unsaved:
            self.base = self._on_disk


def not_editable(message: str) -> Diagnostic:
    """Return the finding that a text of the project is not edited."""
    return NOT_EDITABLE.at(None, message, hint="mend the file outside of the studio")


def _decoded(content: bytes) -> str:
    return content[:LARGEST].decode("utf-8-sig", "replace")


def _is_utf8(content: bytes) -> bool:
    try:
        content.decode("utf-8")
    except UnicodeDecodeError:
        return False
    return True


def unread(name: str, error: OSError) -> Diagnostic:
    """Return the finding that the file of a text cannot be read."""
    if isinstance(error, LeadsOutError):
        return outside_project(name, error)
    return not_editable(f"`{name}` cannot be read: {error.strerror or error}")


def unwritten(name: str, error: OSError) -> Diagnostic:
    """Return the finding that the file of a text cannot be written."""
    if isinstance(error, LeadsOutError):
        return outside_project(name, error)
    message = f"`{name}` cannot be written: {error.strerror or error}"
    return NOT_SAVED.at(None, message, hint="the text is kept here and in the journal")


def too_long(name: str) -> Diagnostic:
    """Return the finding that a text is longer than its file may be."""
    message = f"`{name}` would have more than {LARGEST / 1e6:.0f} MB"
    return NOT_SAVED.at(None, message, hint="is this a program?")
