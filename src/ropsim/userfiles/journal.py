"""The journal: unsaved texts of a project, kept outside of it through a crash."""

import contextlib
import errno
import hashlib
import json
from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import Any

from ropsim.core import (
    Diagnostic,
    FileLock,
    LockState,
    frozen_dataclass,
    read_bytes,
    replace_private_file,
    retried,
    state_folder,
)
from ropsim.userfiles.diagnostics import DAMAGED_JOURNAL
from ropsim.userfiles.file_marks import Mark, has_moved, marks_of, read_marks

VERSION = 1
MOST_SLOTS = 16
"""Sessions that may have the same project open at once, each with a journal of its own."""
LARGEST = 1_000_000_000
"""Bytes of a journal: far above the size of all texts that a session can have open."""

MOST_JOURNALS = 1_000
"""Maximum number of journals searched for that of a moved project."""
MOST_DAMAGED = 100
"""Journals of a place that can be set aside."""


@frozen_dataclass
class Draft:
    """An unsaved text.

    Attributes:
        text: the text.
        base: SHA-256 of the file on which it was written, empty for no file.
    """

    text: str
    base: str


class Journal:
    """Unsaved texts of one session, in a separate file among the journals of the project.

    Of the free places one is taken that an earlier session has left texts in, else the first. Places have
    their names from the path of the folder. If none has texts, those are taken over that a session has left
    of the same project at a former path; see `ropsim.userfiles.file_marks`.

    Raises:
        OSError: there can be no journal.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder.resolve()
        key = hashlib.sha256(str(self._folder).encode("utf-8", "surrogateescape")).hexdigest()[:20]
        home = state_folder() / "journal"
        home.mkdir(parents=True, exist_ok=True, mode=0o700)
        places = [home / f"{key}-{slot}.json" for slot in range(MOST_SLOTS)]
        for place in sorted(places, key=lambda one: not one.exists()):
            lock = FileLock.taken(place.with_suffix(".lock"))
            if lock is not None:
                self._place, self._lock = place, lock
                self._marks: dict[str, Mark] = {}
                self._take_over(home)
                return
        raise OSError(errno.EBUSY, f"the project is open {MOST_SLOTS} times")

    @property
    def place(self) -> Path:
        """Return the file of the journal; it is there while there are texts in it."""
        return self._place

    def read(self) -> tuple[Mapping[str, Draft], tuple[Diagnostic, ...]]:
        """Return the texts left by an earlier session, by the names of the documents.

        Raises:
            OSError: it cannot be read, and stays where it is.
        """
        try:
            content = read_bytes(self._place, LARGEST)
        except FileNotFoundError:
            return {}, ()
        document = _document(content)
        drafts = _drafts(document)
        if drafts is not None:
            self._marks = read_marks(document.get("marks"))
            return drafts, ()
        aside = self._set_aside()
        message = f"unsaved texts of an earlier session cannot be read; they are now in `{aside}`"
        return {}, (DAMAGED_JOURNAL.at(None, message, hint="look at that file with a text editor"),)

    def _take_over(self, home: Path) -> None:
        """Without a journal, take over one that was left of this project before its folder was moved here."""
        others: list[Path] = []
        with contextlib.suppress(OSError):
            others = [] if self._place.exists() else sorted(home.glob("*.json"))[:MOST_JOURNALS]
        for other in others:
            with contextlib.suppress(OSError):
                lock = FileLock.taken(other.with_suffix(".lock"))
                if lock is None:  # of a session that goes on
                    continue
                try:
                    if lock.state is LockState.HELD and self._was_elsewhere(other):
                        retried(partial(other.replace, self._place))
                        return
                finally:
                    lock.free()

    def _was_elsewhere(self, other: Path) -> bool:
        """Return whether a journal is of this project at a former path.

        Raises:
            OSError: it cannot be read.
        """
        document = _document(read_bytes(other))
        marks, before = read_marks(document.get("marks")), document.get("folder")
        return (
            _drafts(document) is not None
            and isinstance(before, str)
            and (has_moved(marks, Path(before), self._folder))
        )

    def _set_aside(self) -> Path:
        """Rename a damaged journal, and return the new name."""
        endings = (".damaged", *(f".damaged-{number}" for number in range(2, MOST_DAMAGED + 1)))
        places = [self._place.with_suffix(ending) for ending in endings]
        aside = next((one for one in places if not one.exists()), None)
        if aside is None:
            raise OSError(errno.EEXIST, f"{MOST_DAMAGED} damaged journals of this project are in its folder")
        retried(partial(self._place.replace, aside))
        return aside

    def write(self, drafts: Mapping[str, Draft]) -> None:
        """Replace the journal in one step; without drafts there is none.

        Raises:
            OSError: it cannot be written.
        """
        if not drafts:
            self._place.unlink(missing_ok=True)
            return
        entries = {name: {"text": draft.text, "base": draft.base} for name, draft in drafts.items()}
        self._marks |= marks_of(self._folder, drafts)  # marks of a removed folder stay
        document = {
            "version": VERSION,
            "folder": str(self._folder),
            "marks": self._marks,
            "documents": entries,
        }
        replace_private_file(self._place, json.dumps(document).encode())

    def close(self) -> None:
        """Leave the place to the next session."""
        self._lock.free()


def _document(content: bytes) -> dict[str, Any]:
    """Return the content of a journal, empty if it is damaged."""
    try:
        document = json.loads(content)
    except (ValueError, RecursionError):
        return {}
    return document if isinstance(document, dict) else {}


def _drafts(document: Mapping[str, Any]) -> dict[str, Draft] | None:
    """Return the texts of a journal; None where it is damaged or of another version."""
    try:
        if document["version"] != VERSION:
            return None
        drafts = {name: Draft(one["text"], one["base"]) for name, one in document["documents"].items()}
    except (TypeError, KeyError, AttributeError):
        return None
    whole = all(isinstance(one.text, str) and isinstance(one.base, str) for one in drafts.values())
    return drafts if whole else None
