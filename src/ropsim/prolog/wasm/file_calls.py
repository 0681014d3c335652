"""The system calls about files, as emscripten's programs make them, answered out of memory.

Numbers of errors and the layout of records are those of emscripten's musl (`errno.h`, `struct stat`,
`struct dirent`).
"""

import struct
from collections.abc import Callable
from enum import IntEnum
from posixpath import dirname

from ropsim.prolog.wasm.files import MemoryFiles, NoRoomError, absolute
from ropsim.prolog.wasm.memory import LinearMemory

MOST_OPEN = 256
"""Files that may be open at a time."""
PRINTED = 1 << 16
"""Bytes of what a program prints that are kept."""
ENTRY = 280
"""Bytes of an entry of a folder."""


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
    """What is open, a file, a folder or the terminal: where it is, how, and how far it has been read."""

    def __init__(self, path: str, flags: int) -> None:
        self.path = path
        self.flags = flags
        self.place = 0


class FileCalls:
    """Answers the calls of one program; memory is given once the program has been made."""

    memory: LinearMemory

    def __init__(self, files: MemoryFiles) -> None:
        self.files = files
        self.folder = "/kb"
        self.printed = bytearray()
        self._open = {number: Opening("", flags) for number, flags in enumerate((0, 1, 1))}

    def table(self) -> dict[str, Callable[..., int]]:
        """Return the function of each call by the name of its import."""
        calls: dict[str, Callable[..., int]] = {
            "openat": self._openat,
            "stat64": self._stat,
            "lstat64": self._stat,
            "newfstatat": lambda _folder, path, buffer, _flags: self._stat(path, buffer),
            "fstat64": self._fstat,
            "faccessat": lambda _folder, path, _mode, _flags: self._access(path),
            "getcwd": self._getcwd,
            "chdir": self._chdir,
            "fcntl64": self._fcntl,
            "getdents64": self._getdents,
            "unlinkat": lambda _folder, path, _flags: self._unlink(path),
            "mkdirat": lambda _folder, path, _mode: self._mkdir(path),
            "ftruncate64": self._truncate,
            "ioctl": lambda *_: -Errno.NOTTY,
            "readlinkat": lambda *_: -Errno.INVAL,
            "getuid32": lambda: 1000,
            "umask": lambda _mode: 0o22,
            "poll": lambda *_: 0,
            "poll_nonblocking": lambda *_: 0,
        }
        refused = ("chmod", "dup3", "linkat", "renameat", "rmdir", "symlinkat", "utimensat")
        streams: dict[str, Callable[..., int]] = {
            "fd_close": self._close,
            "fd_read": self._read,
            "fd_write": self._write,
            "fd_seek": self._seek,
            "fd_fdstat_get": self._fdstat,
        }
        system = calls | {name: lambda *_: -Errno.PERM for name in refused}
        return {f"__syscall_{name}": call for name, call in system.items()} | streams

    def _path(self, address: int) -> str:
        return absolute(self.memory.string(address), self.folder)

    def _openat(self, _folder: int, address: int, flags: int, _mode: int) -> int:
        path, files = self._path(address), self.files
        creates, alone, empties, appends = (flags & bit for bit in (0o100, 0o200, 0o1000, 0o2000))
        if files.is_folder(path):
            if flags & 3:
                return -Errno.ISDIR
        elif not files.is_file(path):
            if not creates or not files.is_folder(dirname(path)):
                return -Errno.NOENT
            try:
                files.replace(path, b"")
            except NoRoomError:
                return -Errno.NOSPC
        elif creates and alone:
            return -Errno.EXIST
        elif empties:
            files.replace(path, b"")
        number = next((one for one in range(3, MOST_OPEN) if one not in self._open), None)
        if number is None:
            return -Errno.MFILE
        self._open[number] = Opening(path, flags)
        if appends and not files.is_folder(path):
            self._open[number].place = files.size(path)
        return number

    def _close(self, number: int) -> int:
        return 0 if self._open.pop(number, None) else Errno.BADF

    def _read(self, number: int, vector: int, count: int, done: int) -> int:
        one = self._open.get(number)
        if one is None:
            return Errno.BADF
        if self.files.is_folder(one.path):
            return Errno.ISDIR
        content = self.files.content(one.path) if one.path else b""
        begin = one.place
        for index in range(count):
            address, length = self.memory.unpack(vector + 8 * index, "<II")
            piece = bytes(content[one.place : one.place + length])
            self.memory.write(address, piece)
            one.place += len(piece)
            if len(piece) < length:
                break
        self.memory.pack(done, "<I", one.place - begin)
        return 0

    def _write(self, number: int, vector: int, count: int, done: int) -> int:
        one = self._open.get(number)
        if one is None or not one.flags & 3:
            return Errno.BADF
        total = 0
        for index in range(count):
            address, length = self.memory.unpack(vector + 8 * index, "<II")
            piece = self.memory.read(address, length)
            if not one.path:
                self.printed += piece[: max(PRINTED - len(self.printed), 0)]
            else:
                try:
                    self.files.write(one.path, one.place, piece)
                except NoRoomError:
                    return Errno.NOSPC
                one.place += length
            total += length
        self.memory.pack(done, "<I", total)
        return 0

    def _seek(self, number: int, offset: int, whence: int, result: int) -> int:
        one = self._open.get(number)
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
        one = self._open.get(number)
        if one is None:
            return Errno.BADF
        kind = 2 if not one.path else 3 if self.files.is_folder(one.path) else 4
        self.memory.write(buffer, struct.pack("<BxHIQQ", kind, 0, 0, 0, 0))
        return 0

    def _stat(self, address: int, buffer: int) -> int:
        return self._describe(self._path(address), buffer)

    def _fstat(self, number: int, buffer: int) -> int:
        one = self._open.get(number)
        return self._describe(one.path, buffer) if one else -Errno.BADF

    def _describe(self, path: str, buffer: int) -> int:
        """Write `struct stat` of a file, a folder or, without a path, the terminal; all are of one age."""
        if not path:
            mode, size, inode = 0o020666, 0, 0
        elif self.files.is_folder(path):
            mode, size, inode = 0o040777, 4096, self.files.number(path)
        elif self.files.is_file(path):
            mode, size, inode = 0o100666, self.files.size(path), self.files.number(path)
        else:
            return -Errno.NOENT
        blocks = (size + 4095) // 4096
        head = struct.pack("<IIIIIIqii", 1, mode, 1, 0, 0, 0, size, 4096, blocks)
        self.memory.write(buffer, head + struct.pack("<qIxxxx", 1, 0) * 3 + struct.pack("<q", inode))
        return 0

    def _access(self, address: int) -> int:
        path = self._path(address)
        return 0 if self.files.is_file(path) or self.files.is_folder(path) else -Errno.NOENT

    def _getcwd(self, buffer: int, size: int) -> int:
        name = self.folder.encode() + b"\0"
        if size < len(name):
            return -Errno.INVAL
        self.memory.write(buffer, name)
        return len(name)

    def _chdir(self, address: int) -> int:
        path = self._path(address)
        if not self.files.is_folder(path):
            return -Errno.NOTDIR
        self.folder = path
        return 0

    def _fcntl(self, number: int, command: int, _arguments: int) -> int:
        one = self._open.get(number)
        if one is None:
            return -Errno.BADF
        return one.flags if command == 3 else 0

    def _getdents(self, number: int, buffer: int, size: int) -> int:
        """Write entries of a folder from where the last call ended, as many as fit."""
        one = self._open.get(number)
        if one is None or not self.files.is_folder(one.path):
            return -Errno.NOTDIR
        names = (".", "..", *self.files.names(one.path))
        first = one.place // ENTRY
        shown = names[first : first + size // ENTRY]
        for index, name in enumerate(shown):
            path = absolute(name, one.path)
            kind = 4 if self.files.is_folder(path) else 8
            head = struct.pack("<QqHB", self.files.number(path), (first + index + 1) * ENTRY, ENTRY, kind)
            self.memory.write(buffer + index * ENTRY, head + name.encode()[:255] + b"\0")
        one.place += len(shown) * ENTRY
        return len(shown) * ENTRY

    def _unlink(self, address: int) -> int:
        path = self._path(address)
        if not self.files.is_file(path):
            return -Errno.NOENT
        self.files.remove(path)
        return 0

    def _mkdir(self, address: int) -> int:
        try:
            self.files.make_folder(self._path(address))
        except NoRoomError:
            return -Errno.NOSPC
        return 0

    def _truncate(self, number: int, length: int) -> int:
        one = self._open.get(number)
        if one is None or not one.path:
            return -Errno.BADF
        try:
            self.files.replace(one.path, bytes(self.files.content(one.path))[:length].ljust(length, b"\0"))
        except NoRoomError:
            return -Errno.NOSPC
        return 0
