"""The files that SWI-Prolog brings with it; each is unpacked when it is opened for the first time."""

from collections.abc import Iterator, Mapping

from ropsim.core import frozen_dataclass
from ropsim.prolog.wasm.lz4 import unpacked

BLOCK = 2048
"""Bytes of a block before it was packed."""


@frozen_dataclass
class Packed:
    """Packed bytes, block by block.

    Attributes:
        data: all blocks.
        offsets: where each block begins in `data`.
        sizes: how many bytes of `data` it has.
        packed: 1 where it is LZ4, 0 where it is stored uncompressed.
    """

    data: bytes
    offsets: tuple[int, ...]
    sizes: tuple[int, ...]
    packed: tuple[int, ...]


class Library:
    """Files by path; unpacked files are kept, because every new engine opens the same few."""

    def __init__(self, blocks: Packed, places: Mapping[str, tuple[int, int]]) -> None:
        self._blocks = blocks
        self._places = places
        self._opened: dict[str, bytes] = {}

    def __iter__(self) -> Iterator[str]:
        return iter(self._places)

    def size(self, path: str) -> int:
        """Return the bytes of a file."""
        start, end = self._places[path]
        return end - start

    def content(self, path: str) -> bytes:
        """Return the content of a file."""
        if path not in self._opened:
            start, end = self._places[path]
            first = start // BLOCK
            whole = b"".join(self._block(number) for number in range(first, (end + BLOCK - 1) // BLOCK))
            self._opened[path] = whole[start - first * BLOCK : end - first * BLOCK]
        return self._opened[path]

    def _block(self, number: int) -> bytes:
        blocks = self._blocks
        stored = blocks.data[blocks.offsets[number] : blocks.offsets[number] + blocks.sizes[number]]
        return unpacked(stored, BLOCK) if blocks.packed[number] else stored
