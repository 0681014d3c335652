"""The system calls about files, as emscripten's programs make them, answered out of memory.

Numbers of errors and the layout of records as in emscripten's musl (`errno.h`, `struct stat`, `struct
dirent`).
"""

import struct
from collections.abc import Callable
from posixpath import dirname

from ropsim.prolog.wasm.files import NoRoomError, absolute
from ropsim.prolog.wasm.memory import LinearMemory
from ropsim.prolog.wasm.stream_calls import Errno, StreamCalls

ENTRY = 280
"""Bytes of an entry of a folder."""


class FileCalls:
    """Answers the calls of one program; memory is given once the program has been made."""

    memory: LinearMemory

    def __init__(self, streams: StreamCalls) -> None:
        self.files = streams.files
        self.folder = "/kb"
        self._streams = streams

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
        system = calls | {name: lambda *_: -Errno.PERM for name in refused}
        return {f"__syscall_{name}": call for name, call in system.items()}

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
        number = self._streams.open(path, flags)
        if number > 0 and appends and not files.is_folder(path):
            self._streams.opened[number].place = files.size(path)
        return number

    def _stat(self, address: int, buffer: int) -> int:
        return self._describe(self._path(address), buffer)

    def _fstat(self, number: int, buffer: int) -> int:
        one = self._streams.opened.get(number)
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
        one = self._streams.opened.get(number)
        if one is None:
            return -Errno.BADF
        return one.flags if command == 3 else 0

    def _getdents(self, number: int, buffer: int, size: int) -> int:
        """Write entries of a folder from where the last call ended, as many as fit."""
        one = self._streams.opened.get(number)
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
        one = self._streams.opened.get(number)
        if one is None or not one.path:
            return -Errno.BADF
        try:
            self.files.replace(one.path, bytes(self.files.content(one.path))[:length].ljust(length, b"\0"))
        except NoRoomError:
            return -Errno.NOSPC
        return 0
