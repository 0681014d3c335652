"""The files that Prolog can see, all in memory: its library, and files written by it and its host."""

from posixpath import dirname, normpath

from ropsim.prolog.wasm.library import Library

FOLDERS = ("/", "/tmp", "/dev", "/proc", "/kb", "/ropsim")
ROOM = 32 << 20
"""Bytes that all written files may have together, their names with them."""
NAME = 256
"""Bytes that a name counts for."""


class NoRoomError(Exception):
    """Written files would have more bytes than they may."""


class MemoryFiles:
    """Files and folders by absolute path; nothing of the machine is among them.

    Attributes:
        changes: how often a file or folder was made, written or taken away.
    """

    def __init__(self, library: Library) -> None:
        self._library = library
        self._written: dict[str, bytearray] = {}
        self._names: dict[str, dict[str, None]] = {}
        self._numbers: dict[str, int] = {}
        self._last = 0
        self._bytes = 0
        self.changes = 0
        for path in FOLDERS:
            self.make_folder(path)
        for path in library:
            self._enter(path)

    def is_folder(self, path: str) -> bool:
        """Return whether there is a folder at a path."""
        return path in self._names

    def is_file(self, path: str) -> bool:
        """Return whether there is a file at a path."""
        return path not in self._names and path in self._numbers

    def names(self, folder: str) -> tuple[str, ...]:
        """Return the names in a folder, in the order in which they came."""
        return tuple(self._names[folder])

    def number(self, path: str) -> int:
        """Return the unique number of this file or folder."""
        return self._numbers[path]

    def size(self, path: str) -> int:
        """Return the bytes of a file."""
        return len(self._written[path]) if path in self._written else self._library.size(path)

    def content(self, path: str) -> bytes | bytearray:
        """Return the content of a file; it changes when the file is written."""
        return self._written[path] if path in self._written else self._library.content(path)

    def replace(self, path: str, content: bytes) -> None:
        """Write a whole file, and the folders to it.

        Raises:
            NoRoomError: there is no room for it.
        """
        self.changes += 1
        self._take_room(path, len(content) - len(self._written.get(path, b"")))
        self._enter(path)
        self._written[path] = bytearray(content)

    def write(self, path: str, place: int, content: bytes) -> None:
        """Write bytes into a file, from `place` on.

        Raises:
            NoRoomError: there is no room for them.
        """
        self.changes += 1
        if path not in self._written:
            self.replace(path, self._library.content(path))
        old = self._written[path]
        self._take_room(path, max(place + len(content) - len(old), 0))
        old.extend(bytes(max(place - len(old), 0)))
        old[place : place + len(content)] = content

    def make_folder(self, path: str) -> None:
        """Enter a folder, and those to it.

        Raises:
            NoRoomError: there is no room for it.
        """
        if path not in self._names:
            self.changes += 1
            self._enter(path)
            self._names[path] = {}

    def remove(self, path: str) -> None:
        """Take a file away."""
        self.changes += 1
        self._bytes -= len(self._written.pop(path, b""))
        self._numbers.pop(path, None)
        self._names[dirname(path)].pop(path.rpartition("/")[2], None)

    def _take_room(self, path: str, more: int) -> None:
        if self._bytes + more > ROOM:
            raise NoRoomError(path)
        self._bytes += more

    def _enter(self, path: str) -> None:
        """Assign a number to a path and enter its name in its folder."""
        if path in self._numbers:
            return
        self._take_room(path, NAME)
        self._last += 1
        self._numbers[path] = self._last
        if path != "/":
            self.make_folder(dirname(path))
            self._names[dirname(path)][path.rpartition("/")[2]] = None


def absolute(path: str, folder: str) -> str:
    """Return the absolute form of a path that is meant in a folder."""
    plain = normpath(path if path.startswith("/") else f"{folder}/{path}")
    return "/" + plain.lstrip("/")
