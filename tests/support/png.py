"""Reads the pictures that a browser takes of its pages."""

import struct
import zlib

import numpy as np
import numpy.typing as npt

from ropsim.spatial import Array

Bytes = npt.NDArray[np.uint8]
SIGNATURE = b"\x89PNG\r\n\x1a\n"
CHANNELS = {2: 3, 6: 4}
"""Bytes of a pixel by colour type: RGB and RGBA."""


def read_png(content: bytes) -> Array:
    """Return a picture with 8 bits per channel as red, green and blue, shape (height, width, 3)."""
    assert content.startswith(SIGNATURE)
    chunks = _chunks(content)
    width, height, bits, kind, _, _, interlaced = struct.unpack(">IIBBBBB", chunks[b"IHDR"])
    assert (bits, interlaced) == (8, 0)
    step = CHANNELS[kind]
    rows = np.frombuffer(zlib.decompress(chunks[b"IDAT"]), np.uint8).reshape(height, 1 + width * step)
    picture: Bytes = np.zeros((height, width, step), np.uint8)
    above: Bytes = np.zeros((width, step), np.uint8)
    for at, row in enumerate(rows):
        above = picture[at] = _unfiltered(int(row[0]), row[1:].reshape(width, step), above)
    return picture[:, :, :3].astype(np.float64)


def _chunks(content: bytes) -> dict[bytes, bytes]:
    """Return what stands under each name; parts under one name are joined."""
    found: dict[bytes, bytes] = {}
    at = len(SIGNATURE)
    while at < len(content):
        (length,) = struct.unpack_from(">I", content, at)
        name = content[at + 4 : at + 8]
        found[name] = found.get(name, b"") + content[at + 8 : at + 8 + length]
        at += 12 + length
    return found


def _unfiltered(kind: int, row: Bytes, above: Bytes) -> Bytes:
    """Return a row of pixels from its differences to its neighbours at the left and above."""
    if kind == 0:
        return row
    if kind == 1:
        return np.cumsum(row, axis=0, dtype=np.uint8)
    if kind == 2:
        return row + above
    guess = _average if kind == 3 else _paeth
    pixels = []
    left, corner = [0] * row.shape[1], [0] * row.shape[1]
    for differences, over in zip(row.tolist(), above.tolist(), strict=True):
        left = [
            (d + guess(a, b, c)) & 255 for d, a, b, c in zip(differences, left, over, corner, strict=True)
        ]
        corner = over
        pixels.append(left)
    return np.array(pixels, np.uint8)


def _average(left: int, above: int, corner: int) -> int:
    return (left + above) // 2


def _paeth(left: int, above: int, corner: int) -> int:
    """Return the neighbour that is nearest to `left + above - corner`."""
    by_left, by_above, by_corner = abs(above - corner), abs(left - corner), abs(left + above - 2 * corner)
    if by_left <= by_above and by_left <= by_corner:
        return left
    return above if by_above <= by_corner else corner
