"""NPZ archives that can be trusted: no pickles, bounded memory, the same bytes for the same arrays.

The archives have the form of `numpy.savez_compressed`, so `numpy.load` reads them. Reading is done here with
every size checked before memory is taken, because a file may come from anywhere.
"""

import ast
import io
import struct
import zipfile
import zlib
from collections.abc import Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

Bytes = npt.NDArray[np.uint8]
AnyArray = npt.NDArray[np.float64] | Bytes

LIMIT = 4 << 30
"""Largest sum of the unpacked sizes of all entries [bytes]."""

LEVEL = 1
"""Deflate level: higher ones take several times as long on sampled motion and save little."""

EPOCH = (1980, 1, 1, 0, 0, 0)
"""Time stamp of every entry, so that equal recordings are equal files."""

_METHODS = {zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED}
_DTYPES = {np.dtype("<f8"), np.dtype("u1")}
_PROPERTIES = 0o600 << 16

_BROKEN = (
    zipfile.BadZipFile,
    zlib.error,
    struct.error,
    ValueError,
    EOFError,
    OSError,
    LookupError,
    OverflowError,
    SyntaxError,
    RuntimeError,
    MemoryError,
)
"""Exceptions of the ZIP reader of the standard library on damaged archives, as found by fuzzing."""


class ForeignFileError(ValueError):
    """The bytes are no ZIP archive."""


class DamagedFileError(ValueError):
    """The archive is damaged; the message says where."""


class TooLargeError(ValueError):
    """The archive unpacks to more than `LIMIT` bytes."""


def pack(arrays: Mapping[str, AnyArray]) -> bytes:
    """Return an archive of arrays by name, in their order."""
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w") as archive:
        for name, array in arrays.items():
            entry = zipfile.ZipInfo(f"{name}.npy", EPOCH)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.create_system = 3
            entry.external_attr = _PROPERTIES
            content = io.BytesIO()
            np.lib.format.write_array(
                content, np.ascontiguousarray(array), version=(1, 0), allow_pickle=False
            )
            archive.writestr(entry, content.getvalue(), compresslevel=LEVEL)
    return stream.getvalue()


def unpack(content: bytes) -> dict[str, AnyArray]:
    """Return the arrays of an archive by name.

    Raises:
        ForeignFileError: the bytes are no ZIP archive.
        TooLargeError: the archive announces more than `LIMIT` bytes.
        DamagedFileError: an entry is damaged, packed in another way, or no array of float64 or bytes.
    """
    if not zipfile.is_zipfile(io.BytesIO(content)):
        raise ForeignFileError("no ZIP archive")
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            entries = archive.infolist()
            _check_size(entries)
            return {entry.filename.removesuffix(".npy"): _array(archive, entry) for entry in entries}
    except (TooLargeError, DamagedFileError):
        raise
    except _BROKEN as error:
        raise DamagedFileError("the archive cannot be unpacked") from error


def _check_size(entries: list[zipfile.ZipInfo]) -> None:
    if sum(entry.file_size for entry in entries) > LIMIT:
        raise TooLargeError("too much data")


def _array(archive: zipfile.ZipFile, entry: zipfile.ZipInfo) -> AnyArray:
    if entry.compress_type not in _METHODS:
        raise DamagedFileError(f"entry `{entry.filename}` is packed in an unknown way")
    with archive.open(entry) as packed:
        content = packed.read(entry.file_size + 1)
    shape, fortran, dtype, body = _parts(content, entry.filename)
    size = dtype.itemsize
    for length in shape:
        size *= length
    if dtype not in _DTYPES or (fortran and len(shape) > 1) or min(shape, default=0) < 0 or size != len(body):
        raise DamagedFileError(f"entry `{entry.filename}` is no array of numbers of its size")
    return np.frombuffer(body, dtype).reshape(shape)


def _parts(content: bytes, name: str) -> tuple[tuple[int, ...], bool, np.dtype[Any], bytes]:
    """Return shape, order, type and numbers of an entry of format 1.0.

    Numpy's own reader of the header repairs damage with a second parser, which has other warnings and
    exceptions.
    """
    magic = np.lib.format.magic(1, 0)
    if not content.startswith(magic) or len(content) < len(magic) + 2:
        raise DamagedFileError(f"entry `{name}` is no array of format 1.0")
    start = len(magic) + 2
    end = start + int.from_bytes(content[len(magic) : start], "little")
    try:
        header = ast.literal_eval(content[start:end].decode("latin-1").strip())
        shape, fortran, descr = header["shape"], header["fortran_order"], header["descr"]
        whole = all(isinstance(length, int) for length in shape) and isinstance(descr, str)
        if whole and isinstance(shape, tuple):
            return shape, bool(fortran), np.dtype(descr), content[end:]
    except (ValueError, TypeError, SyntaxError, LookupError, MemoryError, RecursionError) as error:
        raise DamagedFileError(f"entry `{name}` has a damaged header") from error
    raise DamagedFileError(f"entry `{name}` has a damaged header")
