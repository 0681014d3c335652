"""From what numba compiles to a function that Python calls, by way of the cache folder."""

from collections.abc import Callable
from types import FunctionType

from ropsim.codegen.code_digest import digest_of
from ropsim.codegen.compiling import begin_compiling
from ropsim.codegen.direct import Compiled
from ropsim.codegen.kept_code import GENERATED, keep_code, kept_address
from ropsim.codegen.machine_code import MissingNameError, emit_object, load
from ropsim.codegen.signature import Signature
from ropsim.core import without_collection

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
    digest = digest_of(source)
    entry = f"{name}_{digest}.code"
    address = kept_address(entry)
    if address is None:
        with GENERATED.turn(int(digest, 16)), without_collection():
            address = kept_address(entry)  # made by another process meanwhile
            if address is None:
                return _made(entry, signature, build)
    return signature.caller(address)


def _made(name: str, signature: Signature, build: _Build) -> Compiled:
    """Return a function that has been compiled just now and is kept, if it stands alone."""
    begin_compiling()
    entry, function = build()
    from ropsim.codegen.stages import outside, written

    try:
        code = emit_object(*written(entry))
        address = load(code)
    except (ValueError, MissingNameError):
        return outside(function)
    keep_code(name, code)
    return signature.caller(address)
