"""From what numba compiles to a function that Python calls, by way of the cache folder."""

import contextlib
from collections.abc import Callable
from pathlib import Path
from types import FunctionType

from ropsim.codegen.code_digest import digest_of
from ropsim.codegen.direct import Compiled
from ropsim.codegen.machine_code import MissingNameError, emit_object, keep, load, read
from ropsim.codegen.signature import Signature
from ropsim.core import cache_folder, turn, without_collection

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
    folder, digest = cache_folder() / "generated", digest_of(source)
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
