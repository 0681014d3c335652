"""The journal: unsaved texts of a project, kept outside of it through a crash."""

import hashlib
import json
import sys
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import IO

from ropsim.core import Diagnostic, read_bytes, replace_file
from ropsim.workbench.trust_diagnostics import DAMAGED_JOURNAL
from ropsim.workbench.user_folders import state_folder

VERSION = 1
MOST_SLOTS = 16
"""Sessions that may have the same project open at once, each with a journal of its own."""


@dataclass(frozen=True, slots=True)
class Draft:
    """An unsaved text.

    Attributes:
        text: the text.
        base: SHA-256 of the file on which it was written, empty for no file.
    """

    text: str
    base: str


class Journal:
    """Unsaved texts of one session. The first free place among those of the project is taken and held."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder.resolve()
        key = hashlib.sha256(str(self._folder).encode("utf-8", "surrogateescape")).hexdigest()[:20]
        home = state_folder() / "journal"
        home.mkdir(parents=True, exist_ok=True, mode=0o700)
        self._lock: IO[bytes] | None = None
        for slot in range(MOST_SLOTS):
            self._place = home / f"{key}-{slot}.json"
            self._lock = _locked(home / f"{key}-{slot}.lock")
            if self._lock is not None:
                break

    def read(self) -> tuple[Mapping[str, Draft], tuple[Diagnostic, ...]]:
        """Return what an earlier session has left, by the names of the documents."""
        try:
            content = read_bytes(self._place)
        except OSError:
            return {}, ()
        drafts = _drafts(content)
        if drafts is not None:
            return drafts, ()
        aside = self._place.with_suffix(".damaged")
        self._place.replace(aside)
        message = f"unsaved texts of an earlier session cannot be read; they are now in `{aside}`"
        return {}, (DAMAGED_JOURNAL.at(None, message, hint="look at that file with a text editor"),)

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
        replace_file(self._place, json.dumps(document).encode())

    def close(self) -> None:
        """Leave the place to the next session."""
        if self._lock is not None:
            self._lock.close()


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


def _locked(place: Path) -> IO[bytes] | None:
    """Return the file with a lock that the system frees when this process ends, None where another has it."""
    stream = place.open("ab")
    try:
        if sys.platform == "win32":
            import msvcrt

            msvcrt.locking(stream.fileno(), msvcrt.LK_NBLCK, 1)
        else:
            import fcntl

            fcntl.flock(stream.fileno(), fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        stream.close()
        return None
    return stream
