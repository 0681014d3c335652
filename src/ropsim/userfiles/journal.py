"""The journal: unsaved texts of a project, kept outside of it through a crash."""

import errno
import hashlib
import json
from collections.abc import Mapping
from pathlib import Path

from ropsim.core import Diagnostic, frozen_dataclass, read_bytes, replace_private_file, state_folder
from ropsim.userfiles.diagnostics import DAMAGED_JOURNAL
from ropsim.userfiles.file_lock import FileLock

VERSION = 1
MOST_SLOTS = 16
"""Sessions that may have the same project open at once, each with a journal of its own."""
LARGEST = 1_000_000_000
"""Bytes of a journal: far above those of all texts that a session can have open."""

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
    """Unsaved texts of one session, in a place of its own among those of the project.

    Of the free places one is taken that an earlier session has left texts in, else the first.

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
                return
        raise OSError(errno.EBUSY, f"the project is open {MOST_SLOTS} times")

    @property
    def place(self) -> Path:
        """Return the file of the journal; it is there while there are texts in it."""
        return self._place

    def read(self) -> tuple[Mapping[str, Draft], tuple[Diagnostic, ...]]:
        """Return what an earlier session has left, by the names of the documents.

        Raises:
            OSError: it cannot be read, and stays where it is.
        """
        try:
            content = read_bytes(self._place, LARGEST)
        except FileNotFoundError:
            return {}, ()
        drafts = _drafts(content)
        if drafts is not None:
            return drafts, ()
        aside = self._set_aside()
        message = f"unsaved texts of an earlier session cannot be read; they are now in `{aside}`"
        return {}, (DAMAGED_JOURNAL.at(None, message, hint="look at that file with a text editor"),)

    def _set_aside(self) -> Path:
        """Give a damaged journal a name of its own, and return that."""
        endings = (".damaged", *(f".damaged-{number}" for number in range(2, MOST_DAMAGED + 1)))
        places = [self._place.with_suffix(ending) for ending in endings]
        aside = next((one for one in places if not one.exists()), None)
        if aside is None:
            raise OSError(errno.EEXIST, f"{MOST_DAMAGED} damaged journals of this project are in its folder")
        self._place.replace(aside)
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
        document = {"version": VERSION, "folder": str(self._folder), "documents": entries}
        replace_private_file(self._place, json.dumps(document).encode())

    def close(self) -> None:
        """Leave the place to the next session."""
        self._lock.free()


def _drafts(content: bytes) -> dict[str, Draft] | None:
    try:
        document = json.loads(content)
        if document["version"] != VERSION:
            return None
        drafts = {name: Draft(one["text"], one["base"]) for name, one in document["documents"].items()}
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError):
        return None
    whole = all(isinstance(one.text, str) and isinstance(one.base, str) for one in drafts.values())
    return drafts if whole else None
