"""Pictures as PNG files (ISO/IEC 15948): eight bits for each of red, green, blue and opacity."""

import struct
import zlib
from collections.abc import Mapping

import numpy as np
import numpy.typing as npt

SIGNATURE = b"\x89PNG\r\n\x1a\n"
_RGBA = 6


def png_bytes(pixels: npt.NDArray[np.uint8], words: Mapping[str, str]) -> bytes:
    """Return a PNG file.

    Args:
        pixels: shape (height, width, 4).
        words: texts that go with it, by keyword; Latin letters only.
    """
    height, width, _ = pixels.shape
    rows = np.zeros((height, 1 + 4 * width), np.uint8)  # each row begins with its filter, here none
    rows[:, 1:] = pixels.reshape(height, -1)
    parts = [("IHDR", struct.pack(">IIBBBBB", width, height, 8, _RGBA, 0, 0, 0))]
    parts += [("tEXt", f"{key}\0{text}".encode("latin-1")) for key, text in words.items()]
    parts += [("IDAT", zlib.compress(rows.tobytes(), 9)), ("IEND", b"")]
    return SIGNATURE + b"".join(_chunk(name.encode(), content) for name, content in parts)


def png_words(data: bytes) -> dict[str, str]:
    """Return the texts that go with a PNG file of `png_bytes`, by keyword."""
    found, at = {}, len(SIGNATURE)
    while at + 12 <= len(data):
        (length,) = struct.unpack_from(">I", data, at)
        if data[at + 4 : at + 8] == b"tEXt":
            key, _, text = data[at + 8 : at + 8 + length].decode("latin-1").partition("\0")
            found[key] = text
        at += 12 + length
    return found


def _chunk(name: bytes, content: bytes) -> bytes:
    return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))
