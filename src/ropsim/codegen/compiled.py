"""From what numba compiles to a function that Python calls, by way of the cache folder."""

import contextlib
import sys
from collections.abc import Callable
from functools import cache
from hashlib import sha256
from importlib.util import find_spec
from pathlib import Path
from types import FunctionType

from ropsim.codegen.caller import Compiled
from ropsim.codegen.machine_code import MissingNameError, emit_object, host, keep, load, read
from ropsim.codegen.signature import Signature
from ropsim.core import cache_folder, read_bytes, turn, without_collection
from ropsim.version import __version__

_Build = Callable[[], tuple[FunctionType, Callable[..., None]]]


def compiled(name: str, source: str, signature: Signature, build: _Build) -> Compiled:
    """Return a compiled function; numba is imported only where the cache folder does not hold it.

    A cache that is damaged or cannot be written costs time only.

    Args:
        name: Python identifier that tells what the function is about.
        source: the text that decides what the machine code is.
        signature: of the function.
        build: imports numba and returns the function `entry` of `Signature.entry_text`, and the one that it
            calls as `stages` makes it, for a system where the machine code does not stand alone.
    """
    folder, digest = cache_folder() / "generated", _digest(source)
    path = folder / f"{name}_{digest}.code"
    with contextlib.suppress(OSError, ValueError, MissingNameError):
        return signature.caller(load(read(path)))
    with turn(folder / "turns", int(digest, 16)), without_collection():
        with contextlib.suppress(OSError, ValueError, MissingNameError):
            return signature.caller(load(read(path)))  # made by another process meanwhile
        return _made(path, signature, build)


def _made(path: Path, signature: Signature, build: _Build) -> Compiled:
    """Return a function that has been compiled just now and is kept, if it stands alone."""
    entry, function = build()
    from ropsim.codegen.stages import outside, written

    try:
        code = emit_object(*written(entry))
        address = load(code)
    except (ValueError, MissingNameError):
        return outside(function)
    with contextlib.suppress(OSError):
        keep(code, path)
    return signature.caller(address)


def _digest(source: str) -> str:
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
