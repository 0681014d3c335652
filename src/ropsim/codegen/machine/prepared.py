"""LLVM's texts of kernels, written while the wheel was made: machine code of them needs no numba.

numba's stages take two thirds of the time of a first run and end with the same text on every system. The
texts are in one archive under names that hold a digest of the source. A checkout has no archive, a kernel of
another source is not found in it, and an LLVM older than the writer's may not read it: then numba compiles.
"""

import struct
import zlib
from functools import cache
from hashlib import sha256
from pathlib import Path
from zipfile import ZIP_DEFLATED, BadZipFile, ZipFile, ZipInfo

from ropsim.codegen.machine.kept_code import compiler_digest
from ropsim.version import __version__

ARCHIVE = Path(__file__).parents[1] / "prepared.zip"

_DAMAGED = (
    OSError,
    BadZipFile,
    NotImplementedError,
    RuntimeError,
    EOFError,
    LookupError,
    ValueError,
    struct.error,
    zlib.error,
)
"""Errors of reading a damaged archive."""


def prepared_name(name: str, source: str) -> str:
    """Return the name of a text: the same on every system and for every version of numba.

    Args:
        name: Python identifier of the function.
        source: the text that decides about it.
    """
    digest = sha256(f"{__version__} {compiler_digest()}\n{source}".encode()).hexdigest()[:24]
    return f"{name}_{digest}.ll"


def prepared_text(name: str) -> str | None:
    """Return a text of the archive; None if it has none of that name.

    Args:
        name: as `prepared_name` returns it.
    """
    if name not in _names():
        return None
    try:
        with ZipFile(ARCHIVE) as archive:
            return archive.read(name).decode()
    except _DAMAGED:
        return None


def write_prepared(texts: dict[str, str], path: Path) -> None:
    """Write an archive; the same texts give the same bytes.

    Args:
        texts: by name.
        path: of the archive.
    """
    with ZipFile(path, "w", ZIP_DEFLATED, compresslevel=9) as archive:
        for name, text in sorted(texts.items()):
            archive.writestr(ZipInfo(name), text, ZIP_DEFLATED, 9)


def names_in(path: Path) -> frozenset[str]:
    """Return the names of all texts of an archive; none if it cannot be read."""
    try:
        with ZipFile(path) as archive:
            return frozenset(archive.namelist())
    except _DAMAGED:
        return frozenset()


@cache
def _names() -> frozenset[str]:
    return names_in(ARCHIVE)
