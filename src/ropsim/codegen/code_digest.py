"""What tells machine code from all other: its source, and all that takes part in making it."""

import sys
from functools import cache
from hashlib import sha256
from importlib.util import find_spec
from pathlib import Path

from ropsim.codegen.machine_code import host
from ropsim.core import read_bytes
from ropsim.version import __version__


def digest_of(source: str) -> str:
    """Return the digest of a source and of what makes its machine code on this machine."""
    made_by = f"{__version__} {_numba_version()} {sys.version_info[:3]} {host()} {_compiler()}"
    return sha256(f"{made_by}\n{source}".encode()).hexdigest()[:24]


@cache
def _compiler() -> str:
    """Return the digest of the texts of this package: they decide what becomes of a source."""
    texts = sorted(Path(__file__).parent.glob("*.py"))
    return sha256(b"".join(read_bytes(path) for path in texts)).hexdigest()[:24]


def _numba_version() -> str:
    """Return the text of numba's version file, which is read much faster than numba is imported."""
    found = find_spec("numba")
    place = found.origin if found else None
    if place is None:
        return "none"
    return Path(place).with_name("_version.py").read_text(encoding="utf-8", errors="replace")
