"""The module of SWI-Prolog as machine code; it is compiled once and kept in the user's cache folder."""

from contextlib import suppress
from hashlib import sha256
from importlib.metadata import version
from typing import TYPE_CHECKING

from ropsim.core import KeptFiles

if TYPE_CHECKING:
    from wasmtime import Engine, Module

KEPT = KeptFiles("prolog", most=128_000_000, largest=64_000_000)
"""Machine code has 6 MB, an image some."""


def compiled(engine: "Engine", settings: str, code: bytes) -> "Module":
    """Return the module of some code, from the cache or compiled now.

    Args:
        engine: that runs it.
        settings: words that identify its configuration.
        code: in the form of WebAssembly.
    """
    from wasmtime import Module, WasmtimeError

    name = _name(settings, code)
    kept = KEPT.find(name)
    if kept is not None:
        with suppress(WasmtimeError):
            return Module.deserialize(engine, kept)
    module = Module(engine, code)
    KEPT.keep(name, bytes(module.serialize()))
    return module


def _name(settings: str, code: bytes) -> str:
    """Return the name of the machine code of this code, made by this compiler."""
    digest = sha256(f"{version('wasmtime')} {settings} ".encode() + code).hexdigest()
    return f"{digest[:32]}.module"
