"""From Python functions to one that Python calls: machine code by way of the cache folder, or a slower way.

1. LLVM's text comes from the archive of `prepared`, or numba writes it; llvmlite makes an object file of it,
   and the cache folder keeps that.
2. If that is not possible, for example with a version of numba whose stages are others, numba compiles the
   same functions by its public interface, anew in each process.
3. If numba cannot be imported, Python runs them.
"""

import os
from importlib import import_module
from warnings import warn

from ropsim.codegen.machine.compiler import Bounds, Build
from ropsim.codegen.machine.compiling import begin_compiling
from ropsim.codegen.machine.door import Call, Compiled, machine_code_at
from ropsim.codegen.machine.kept_code import GENERATED, digest_of, keep_code, kept_address
from ropsim.codegen.machine.object_code import (
    ENTRY,
    MachineCode,
    MissingNameError,
    NoObjectCodeError,
    emit_object,
    load,
    with_entry,
)
from ropsim.codegen.machine.prepared import prepared_name, prepared_text
from ropsim.codegen.machine.signature import Signature
from ropsim.core import without_collection

BOUNDS = "ROPSIM_BOUNDS"
"""Variable of the environment: with 1 all compiled code checks every index, and none is kept."""


_warned: set[str] = set()


class CompilingWarning(RuntimeWarning):
    """Code runs in a slower way than usual."""


def compiled(name: str, source: str, signature: Signature, build: Build, plain: Compiled) -> Compiled:
    """Return a compiled function; numba is imported only if the cache folder does not hold it.

    A cache that is damaged or cannot be written costs time only.

    Args:
        name: Python identifier that names the function.
        source: the text that decides about the machine code.
        signature: of the function.
        build: makes the functions with a compiler.
        plain: the function in Python.
    """
    if os.environ.get(BOUNDS) == "1":
        return _made_by_numba(signature, build, Bounds.CHECKED)
    digest = digest_of(source)
    entry = f"{name}_{digest}.code"
    address = kept_address(entry)
    if address is None:
        with GENERATED.turn(int(digest, 16)), without_collection():
            address = kept_address(entry)  # made by another process meanwhile
            if address is None:
                begin_compiling()
                prepared = _from_prepared(prepared_name(name, source))
                if prepared is None:
                    return _made(entry, signature, build, plain)
                address, code = prepared
                keep_code(entry, code)
    return Call(machine_code_at(address), signature.kinds)


def _from_prepared(name: str) -> tuple[int, MachineCode] | None:
    """Return address and machine code of a text that came with the wheel; None if numba is needed.

    Args:
        name: as `prepared_name` returns it.
    """
    text = prepared_text(name)
    if text is None:
        return None
    try:
        code = emit_object(text, ENTRY)
        return load(code), code
    except (RuntimeError, NoObjectCodeError, MissingNameError):  # an older LLVM may not read the text
        return None


def _made(name: str, signature: Signature, build: Build, plain: Compiled) -> Compiled:
    """Return a function that is compiled now, and keep it if it stands alone."""
    try:
        import_module("numba")
    except ImportError as error:
        _warn("numba cannot be imported, Python runs all code itself", error)
        return plain
    try:
        code = _object_code(build)
        address = load(code)
    except (NoObjectCodeError, MissingNameError):
        return _made_by_numba(signature, build, Bounds.TRUSTED)
    except Exception as error:
        try:
            made = _made_by_numba(signature, build, Bounds.TRUSTED)
        except Exception:  # a mistake in the source
            raise error from None
        _warn("numba is used by its public interface, each process compiles all code anew", error)
        return made
    keep_code(name, code)
    return Call(machine_code_at(address), signature.kinds)


def _object_code(build: Build) -> MachineCode:
    from ropsim.codegen.machine.numba_stages import STAGES

    return emit_object(with_entry(*STAGES.llvm_text(build(STAGES))), ENTRY)


def _made_by_numba(signature: Signature, build: Build, bounds: Bounds) -> Compiled:
    from ropsim.codegen.machine.numba_calls import numba_calls

    numba = numba_calls(bounds)
    return Call(numba.entry(build(numba)), signature.kinds)


def _warn(text: str, error: Exception) -> None:
    """Warn once in a process."""
    if text not in _warned:
        _warned.add(text)
        warn(f"{text}: {error!r:.300}", CompilingWarning, stacklevel=2)
