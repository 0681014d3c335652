"""The module of SWI-Prolog as machine code; it is compiled once and kept in the user's cache folder."""

from contextlib import suppress
from hashlib import sha256
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING

from ropsim.core import cache_folder, read_own_bytes, replace_private_file

if TYPE_CHECKING:
    from wasmtime import Engine, Module


def compiled(engine: "Engine", code: bytes) -> "Module":
    """Return the module of some code, from the cache or compiled now.

    Machine code from a file that somebody else could have written is never run: it is compiled anew.
    """
    from wasmtime import Module, WasmtimeError

    path = _path(code)
    with suppress(OSError, ValueError, WasmtimeError):
        return Module.deserialize(engine, kept_code(path))
    module = Module(engine, code)
    kept = bytes(module.serialize())
    with suppress(OSError):
        replace_private_file(path, sha256(kept).digest() + kept)
    return module


def _path(code: bytes) -> Path:
    """Return the file that holds the machine code of this code, made by this compiler."""
    digest = sha256(f"{version('wasmtime')} epochs exceptions ".encode() + code).hexdigest()
    return cache_folder() / "prolog" / f"{digest[:32]}.module"


def kept_code(path: Path) -> bytes:
    """Return the machine code of a file.

    Raises:
        OSError: it cannot be read, or others can write it.
        ValueError: it is damaged.
    """
    content = read_own_bytes(path)
    if sha256(content[32:]).digest() != content[:32]:
        raise ValueError(f"{path} is damaged")
    return content[32:]
