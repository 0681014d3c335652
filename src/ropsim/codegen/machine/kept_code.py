"""Machine code in the cache folder, under names that hold a digest of all its inputs."""

import sys
from functools import cache
from hashlib import sha256
from importlib.util import find_spec
from pathlib import Path

from ropsim.codegen.machine.object_code import MachineCode, MissingNameError, host, load, packed, unpacked
from ropsim.core import KeptFiles, read_bytes
from ropsim.version import __version__

GENERATED = KeptFiles("generated", most=256_000_000, largest=16_000_000)
"""Several thousand functions: of each version of ropsim and each robot some dozens."""


def kept_address(name: str) -> int | None:
    """Return the address of a kept function; None if there is none that this process can run.

    Args:
        name: of the entry; it holds `digest_of` the source.
    """
    content = GENERATED.find(name)
    if content is None:
        return None
    try:
        return load(unpacked(content))
    except (ValueError, MissingNameError):
        return None


def keep_code(name: str, code: MachineCode) -> None:
    """Keep a function for other processes, if the cache folder can be written."""
    GENERATED.keep(name, packed(code))


def digest_of(source: str) -> str:
    """Return the digest of a source and of the tools that make its machine code on this machine."""
    made_by = f"{__version__} {_numba_version()} {sys.version_info[:3]} {host()} {compiler_digest()}"
    return sha256(f"{made_by}\n{source}".encode()).hexdigest()[:24]


@cache
def compiler_digest() -> str:
    """Return the digest of the texts of this package: they decide about the code of a source."""
    texts = sorted(Path(__file__).parents[1].rglob("*.py"))
    return sha256(b"".join(read_bytes(path) for path in texts)).hexdigest()[:24]


def _numba_version() -> str:
    """Return the text of numba's version file, which is read much faster than numba is imported."""
    found = find_spec("numba")
    place = found.origin if found else None
    if place is None:
        return "none"
    return Path(place).with_name("_version.py").read_text(encoding="utf-8", errors="replace")
