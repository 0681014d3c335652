"""The memory of a WebAssembly program, read and written in terms of C."""

import re
import struct
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from wasmtime import Memory, Store

PAGE = 65536
"""Bytes by which memory grows."""


_NO_MEMORY = re.compile(r"[Cc]annot allocate memory|\(os error (?:12|8|14|1455)\)")
"""How the system says it on Linux and macOS; 8, 14 and 1455 are numbers of Windows."""


class NoAddressError(Exception):
    """A program gave an address that its memory does not have."""


class LinearMemory:
    """Bytes, 32-bit numbers and strings at addresses; those outside of the memory raise NoAddressError."""

    def __init__(self, memory: "Memory", store: "Store") -> None:
        self._memory = memory
        self._store = store

    @property
    def size(self) -> int:
        """Return the bytes that the memory has now."""
        return self._memory.data_len(self._store)

    def read(self, address: int, length: int) -> bytes:
        """Return `length` bytes."""
        if address < 0 or length < 0 or address + length > self.size:
            raise NoAddressError(f"{length} bytes at {address} of {self.size}")
        return bytes(self._memory.read(self._store, address, address + length)) if length else b""

    def write(self, address: int, content: bytes) -> None:
        """Write bytes."""
        if address < 0 or address + len(content) > self.size:
            raise NoAddressError(f"{len(content)} bytes at {address} of {self.size}")
        if content:
            self._memory.write(self._store, content, address)

    def pack(self, address: int, form: str, *values: int) -> None:
        """Write numbers in the form that `struct` names."""
        self.write(address, struct.pack(form, *values))

    def unpack(self, address: int, form: str) -> tuple[int, ...]:
        """Return numbers of the form that `struct` names."""
        return struct.unpack(form, self.read(address, struct.calcsize(form)))

    def string(self, address: int) -> str:
        """Return the string that ends with a zero byte; invalid UTF-8 is replaced."""
        content = b""
        while b"\0" not in content:
            chunk = self.read(address + len(content), min(64, self.size - address - len(content)))
            if not chunk:
                raise NoAddressError(f"the string at {address} has no end")
            content += chunk
        return content[: content.index(b"\0")].decode(errors="replace")

    def used_pages(self) -> list[int]:
        """Return the numbers of the pages that hold more than zeros."""
        nothing, count = bytes(PAGE), self.size // PAGE
        return [number for number in range(count) if self.read(PAGE * number, PAGE) != nothing]

    def grow(self, size: int) -> bool:
        """Let the memory have at least `size` bytes; return whether it may."""
        from wasmtime import WasmtimeError

        missing = size - self.size
        if missing <= 0:
            return True
        try:
            self._memory.grow(self._store, (missing + PAGE - 1) // PAGE)
        except WasmtimeError:
            return False
        return True


@contextmanager
def memory_needed() -> Iterator[None]:
    """Let a program be made.

    Raises:
        MemoryError: the system has no memory, or no addresses, left for it.
    """
    from wasmtime import WasmtimeError

    try:
        yield
    except WasmtimeError as error:
        if _NO_MEMORY.search(str(error)):
            raise MemoryError("the system has no room left for SWI-Prolog") from error
        raise
