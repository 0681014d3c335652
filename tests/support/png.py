"""Reads the pictures that a browser takes of its pages."""

import struct
import zlib

import numpy as np
import numpy.typing as npt

from ropsim.spatial import Array

Bytes = npt.NDArray[np.uint8]
Numbers = npt.NDArray[np.int16]
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
    lines = np.frombuffer(zlib.decompress(chunks[b"IDAT"]), np.uint8).reshape(height, 1 + width * step)
    picture = _unfiltered(lines[:, 0], lines[:, 1:].reshape(height, width, step))
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


def _unfiltered(kinds: Bytes, differences: Bytes) -> Numbers:
    """Return the pixels (height, width, channels) from their differences to a guess from their neighbours.

    A pixel needs those at its left, above, and left above. All those on a line that falls from the upper
    right to the lower left, a front, have them at the same time and are made together.
    """
    height, width, channels = differences.shape
    row, column = np.indices((height, width))
    fronts = np.zeros((height + width, height, channels), np.int16)
    fronts[row + column, row] = differences
    # by front and row, behind two fronts and a row of nothing
    made = np.zeros((height + width + 2, height + 1, channels), np.int16)
    for front in range(height + width - 1):
        rows = slice(max(0, front - width + 1), min(height, front + 1))
        here = slice(rows.start + 1, rows.stop + 1)
        left, above, corner = made[front + 1, here], made[front + 1, rows], made[front, rows]
        kind = kinds[rows, None]
        guess = np.select(
            [kind == 1, kind == 2, kind == 3, kind == 4],
            [left, above, (left + above) >> 1, _paeth(left, above, corner)],
        )
        made[front + 2, here] = (fronts[front, rows] + guess) & 255
    pixels: Numbers = made[row + column + 2, row + 1]
    return pixels


def _paeth(left: Numbers, above: Numbers, corner: Numbers) -> Numbers:
    """Return the neighbours that are nearest to `left + above - corner`."""
    by_left, by_above = np.abs(above - corner), np.abs(left - corner)
    by_corner = np.abs(left + above - 2 * corner)
    other = np.where(by_above <= by_corner, above, corner)
    nearest: Numbers = np.where((by_left <= by_above) & (by_left <= by_corner), left, other)
    return nearest
