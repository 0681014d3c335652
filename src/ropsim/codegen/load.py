"""From generated source to callable functions: compiled and cached on disk, or plain Python."""

import contextlib
import importlib.util
import math
import sys
import tempfile
from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache
from hashlib import sha256
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from ropsim.codegen.emit import SourceFunction
from ropsim.codegen.engine import Engine
from ropsim.core import cache_folder, read_bytes, replace_file

Compiled = Callable[..., Any]

_OPTIONS = 'cache=True, error_model="numpy", nogil=True'


def load(name: str, functions: Sequence[SourceFunction], engine: Engine) -> Mapping[str, Compiled]:
    """Return the functions of a generated module by name.

    With numba the source is written to the cache folder under a name that holds its hash, and numba keeps
    the machine code beside it: the next process loads it from there. A cache that is damaged or cannot be
    written is replaced by a temporary folder; only time is lost. Sums are compiled in the order in which they
    are written (no fastmath), so that the same source gives the same bits.

    Args:
        name: Python identifier that tells what the module is about.
        functions: in order; later ones may call earlier ones.
        engine: who runs it.
    """
    return _load(name, tuple(functions), engine)


@lru_cache(maxsize=64)
def _load(name: str, functions: tuple[SourceFunction, ...], engine: Engine) -> Mapping[str, Compiled]:
    if engine is Engine.PYTHON:
        scope: dict[str, Any] = {"math": math, "np": np}
        exec(compile(_plain_source(functions), f"<generated {name}>", "exec"), scope)  # our own source
        return {function.name: scope[function.name] for function in functions}
    source = compiled_source(functions)
    module = _import_cached(f"{name}_{_digest(source)}", source.encode())
    return {function.name: getattr(module, function.name) for function in functions}


def compiled_source(functions: Sequence[SourceFunction]) -> str:
    """Return the text of a module whose functions numba compiles when it is imported."""
    parts = ['"""Generated code; delete it at will."""\nimport math\n\nimport numba\nimport numpy as np\n']
    parts += [f'@numba.njit("{function.signature}", {_OPTIONS})\n{function.text}' for function in functions]
    return "\n\n".join(parts)


def _plain_source(functions: Sequence[SourceFunction]) -> str:
    return "\n\n".join(function.text for function in functions)


def _digest(source: str) -> str:
    import numba

    versions = f"{numba.__version__} {sys.version_info[:3]}"
    return sha256(f"{versions}\n{source}".encode()).hexdigest()[:24]


def _import_cached(name: str, source: bytes) -> ModuleType:
    """Import the module from the cache folder; mend the cache or do without it where that fails.

    A damaged machine-code file shows up as almost any exception inside numba's loader, hence the broad nets;
    a mistake in the source itself fails again in the fresh folder and is raised from there.
    """
    path = cache_folder() / "generated" / f"{name}.py"
    with contextlib.suppress(Exception):
        return _import_from(path, name, source)
    with contextlib.suppress(Exception):
        for damaged in (path.parent / "__pycache__").glob(f"{name}.*"):
            damaged.unlink()
        return _import_from(path, name, source)
    with tempfile.TemporaryDirectory(prefix="ropsim-", ignore_cleanup_errors=True) as folder:
        return _import_from(Path(folder) / f"{name}.py", name, source)


def _import_from(path: Path, name: str, source: bytes) -> ModuleType:
    if not _holds(path, source):
        replace_file(path, source)
    specification = importlib.util.spec_from_file_location(name, path)
    if specification is None or specification.loader is None:
        raise ImportError(f"cannot import {path}")
    module = importlib.util.module_from_spec(specification)
    sys.modules[name] = module  # numba looks the module up when it unpickles cached functions
    specification.loader.exec_module(module)
    return module


def _holds(path: Path, content: bytes) -> bool:
    try:
        return read_bytes(path) == content
    except OSError:
        return False
