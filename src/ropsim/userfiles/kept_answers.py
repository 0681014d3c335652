"""Answers of earlier processes in the user's cache folder: bytes under the name of what they were made of.

They can be lost, damaged or deleted at any time; then they are made again. A folder that others may write to,
or that belongs to somebody else, is not used at all, and of a file only what it was given is taken.
"""

import os
import stat
from collections.abc import Callable, Iterator
from hashlib import sha256
from pathlib import Path

from ropsim.core import cache_folder, replace_private_file

MOST = 64_000_000
"""Bytes of all answers together; beyond that those go that were not used for longest."""
LARGEST = 16_000_000
"""Bytes of one answer; a larger one is not kept."""

_OTHERS_WRITE = stat.S_IWGRP | stat.S_IWOTH
_DIGITS = 64


class KeptAnswers:
    """A folder of answers, each in a file of its own that is replaced in one step.

    Attributes:
        folder: where they lie.
    """

    def __init__(self, folder: Path, most: int = MOST) -> None:
        self.folder = folder
        self._most = most

    def find(self, key: str) -> bytes | None:
        """Return an answer as it was given; None where there is none, or not whole.

        Args:
            key: hexadecimal digits.
        """
        try:
            content = self._content(key)
        except OSError:
            return None
        if len(content) > LARGEST + _DIGITS:
            return None
        said, answer = content[:_DIGITS], content[_DIGITS:]
        return answer if said == _seal(key, answer) else None

    def keep(self, key: str, answer: bytes) -> None:
        """Keep an answer; where it cannot be written, or is too large, nothing happens."""
        if len(answer) > LARGEST:
            return
        try:
            self.folder.mkdir(parents=True, exist_ok=True, mode=0o700)
            if self._is_trusted():
                replace_private_file(self.folder / key, _seal(key, answer) + answer)
                self._make_room()
        except OSError:
            return

    def _content(self, key: str) -> bytes:
        if not self._is_trusted():
            return b""
        path = self.folder / key
        handle = os.open(path, os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0))
        with os.fdopen(handle, "rb") as stream:
            if not _is_own(os.fstat(handle), stat.S_ISREG):
                return b""
            content = stream.read(LARGEST + _DIGITS + 1)
        os.utime(path)
        return content

    def _is_trusted(self) -> bool:
        """Return whether nobody else can have written into the folder."""
        return _is_own(self.folder.lstat(), stat.S_ISDIR)

    def _make_room(self) -> None:
        """Let answers go that were not used for longest, until there is some room for new ones."""
        files = sorted(self._files())
        size = sum(one for _, one, _ in files)
        if size <= self._most:
            return
        for _, one, path in files:
            path.unlink(missing_ok=True)
            size -= one
            if size <= 0.75 * self._most:
                return

    def _files(self) -> Iterator[tuple[int, int, Path]]:
        for entry in os.scandir(self.folder):
            try:
                state = entry.stat(follow_symlinks=False)
            except FileNotFoundError:  # another process has made room
                continue
            yield state.st_mtime_ns, state.st_size, Path(entry.path)


def kept_by_user() -> KeptAnswers:
    """Return the answers in the cache folder of the user."""
    return KeptAnswers(cache_folder() / "answers")


def _seal(key: str, answer: bytes) -> bytes:
    """Return digits that only this answer under this key has: a file under another name is none of it."""
    digest = sha256(key.encode())
    digest.update(answer)
    return digest.hexdigest().encode()


def _is_own(state: os.stat_result, is_kind: Callable[[int], bool]) -> bool:
    """Return whether something is of a kind, belongs to who asks, and nobody else can write to it."""
    if not is_kind(state.st_mode):
        return False
    if not hasattr(os, "geteuid"):  # Windows: the folder lies in the user's profile
        return True
    return state.st_uid == os.geteuid() and not state.st_mode & _OTHERS_WRITE
