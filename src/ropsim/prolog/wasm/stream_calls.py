"""The calls on open files, as emscripten's programs make them: reading, writing, seeking.

Numbers of errors as in emscripten's musl (`errno.h`).
"""

import struct
from collections.abc import Callable
from enum import IntEnum

from ropsim.prolog.wasm.files import MemoryFiles, NoRoomError
from ropsim.prolog.wasm.image import Opened
from ropsim.prolog.wasm.memory import LinearMemory

MOST_OPEN = 256
"""Files that may be open at a time."""
PRINTED = 1 << 16
"""Number of bytes of output that are kept."""


class Errno(IntEnum):
    """Why a call failed."""

    BADF = 8
    EXIST = 20
    INVAL = 28
    ISDIR = 31
    MFILE = 33
    NOENT = 44
    NOSPC = 51
    NOTDIR = 54
    NOTTY = 59
    PERM = 63
    SPIPE = 70


class Opening:
    """An open file, folder or terminal: place, mode, and reading position."""

    def __init__(self, path: str, flags: int) -> None:
        self.path = path
        self.flags = flags
        self.place = 0


class StreamCalls:
    """Answers the calls of one program; memory is given once the program has been made."""

    memory: LinearMemory

    def __init__(self, files: MemoryFiles) -> None:
        self.files = files
        self.printed = bytearray()
        self.opened = {number: Opening("", flags) for number, flags in enumerate((0, 1, 1))}

    def table(self) -> dict[str, Callable[..., int]]:
        """Return the function of each call by the name of its import."""
        return {
            "fd_close": self._close,
            "fd_read": self._read,
            "fd_write": self._write,
            "fd_seek": self._seek,
            "fd_fdstat_get": self._fdstat,
        }

    def open(self, path: str, flags: int) -> int:
        """Open a file or a folder that is there; return its number, or why that cannot be."""
        number = next((one for one in range(3, MOST_OPEN) if one not in self.opened), None)
        if number is None:
            return -Errno.MFILE
        self.opened[number] = Opening(path, flags)
        return number

    def state(self) -> tuple[Opened, ...]:
        """Return the open files."""
        return tuple((number, one.path, one.flags, one.place) for number, one in self.opened.items())

    def go_on_from(self, opened: tuple[Opened, ...]) -> None:
        """Restore open files of an image."""
        self.opened = {}
        for number, path, flags, place in opened:
            self.opened[number] = Opening(path, flags)
            self.opened[number].place = place

    def _close(self, number: int) -> int:
        return 0 if self.opened.pop(number, None) else Errno.BADF

    def _read(self, number: int, vector: int, count: int, done: int) -> int:
        one = self.opened.get(number)
        if one is None:
            return Errno.BADF
        if self.files.is_folder(one.path):
            return Errno.ISDIR
        content = self.files.content(one.path) if one.path else b""
        begin = one.place
        for index in range(count):
            address, length = self.memory.unpack(vector + 8 * index, "<II")
            chunk = bytes(content[one.place : one.place + length])
            self.memory.write(address, chunk)
            one.place += len(chunk)
            if len(chunk) < length:
                break
        self.memory.pack(done, "<I", one.place - begin)
        return 0

    def _write(self, number: int, vector: int, count: int, done: int) -> int:
        one = self.opened.get(number)
        if one is None or not one.flags & 3:
            return Errno.BADF
        total = 0
        for index in range(count):
            address, length = self.memory.unpack(vector + 8 * index, "<II")
            chunk = self.memory.read(address, length)
            if not one.path:
                self.printed += chunk[: max(PRINTED - len(self.printed), 0)]
            else:
                try:
                    self.files.write(one.path, one.place, chunk)
                except NoRoomError:
                    return Errno.NOSPC
                one.place += length
            total += length
        self.memory.pack(done, "<I", total)
        return 0

    def _seek(self, number: int, offset: int, whence: int, result: int) -> int:
        one = self.opened.get(number)
        if one is None or not one.path:
            return Errno.SPIPE
        size = 0 if self.files.is_folder(one.path) else self.files.size(one.path)
        place = offset + (0, one.place, size)[whence] if whence in (0, 1, 2) else -1
        if place < 0:
            return Errno.INVAL
        one.place = place
        self.memory.pack(result, "<q", place)
        return 0

    def _fdstat(self, number: int, buffer: int) -> int:
        one = self.opened.get(number)
        if one is None:
            return Errno.BADF
        kind = 2 if not one.path else 3 if self.files.is_folder(one.path) else 4
        self.memory.write(buffer, struct.pack("<BxHIQQ", kind, 0, 0, 0, 0))
        return 0
