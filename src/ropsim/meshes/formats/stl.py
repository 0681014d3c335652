"""STL files, binary and text."""

import re
import struct
from itertools import islice

import numpy as np

from ropsim.meshes.formats.soup import NO_TRIANGLES, Floats, Soup, check_count, damaged

_HEADER, _ROW = 84, 50  # bytes before the triangles, and of each
_TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
_VERTEX = re.compile(rb"\bvertex\s++(\S{1,40}+)\s++(\S{1,40}+)\s++(\S{1,40}+)(?=\s)", re.IGNORECASE)
_WORD = re.compile(rb"\bvertex\b", re.IGNORECASE)
_AT_ONCE = 30_000  # corners turned into numbers in one go


def read_stl(content: bytes) -> Soup:
    """Return the triangles of an STL file.

    Many binary files begin with `solid` as texts do, so the length decides first.

    Raises:
        MeshFileError: the bytes are no STL.
    """
    count = struct.unpack_from("<I", content, 80)[0] if len(content) >= _HEADER else 0
    if count and len(content) == _HEADER + _ROW * count:
        return _binary(content, count)
    if content.lstrip()[:5].lower() == b"solid":
        return _text(content)
    if len(content) < _HEADER:
        raise damaged("cannot be read as STL")
    if len(content) < _HEADER + _ROW * count:
        held = (len(content) - _HEADER) // _ROW
        raise damaged(f"promises {count:,} triangles and holds {held:,}")
    if not count:
        raise damaged(NO_TRIANGLES)
    return _binary(content, count)


def _binary(content: bytes, count: int) -> Soup:
    check_count(count)
    rows = np.frombuffer(content, _TRIANGLE, count, _HEADER)
    return Soup(rows["corners"].astype(np.float64))


def _text(content: bytes) -> Soup:
    words = sum(1 for _ in _WORD.finditer(content))
    if not words:
        raise damaged(NO_TRIANGLES)
    check_count(words // 3)
    found = _VERTEX.finditer(content)
    fields: list[Floats] = []
    while some := [match.groups() for match in islice(found, _AT_ONCE)]:
        try:
            fields.append(np.array(some, dtype="S40").astype(np.float64))
        except ValueError as error:
            raise damaged("has a corner that is not three numbers") from error
    points = np.concatenate(fields) if fields else np.empty((0, 3))
    if len(points) != words or len(points) % 3:
        raise damaged(
            f"has {words:,} corners, {len(points):,} of them of three numbers; triangles have three each"
        )
    return Soup(points.reshape(-1, 3, 3))
