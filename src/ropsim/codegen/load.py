"""From generated source to a callable function: compiled and cached on disk, or plain Python."""

import math
import re
from collections.abc import Sequence
from enum import Enum
from functools import lru_cache
from types import FunctionType
from typing import Any

import numpy as np

from ropsim.codegen.formulas.emit import Form, SourceFunction
from ropsim.codegen.kernel import entry_of, numba_available
from ropsim.codegen.machine.compiled import compiled
from ropsim.codegen.machine.compiler import Bounds, Compiler
from ropsim.codegen.machine.door import Compiled
from ropsim.codegen.machine.signature import Signature


class Engine(Enum):
    """The way in which a generated module is executed.

    Both run the same source; results agree to rounding of the elementary functions.
    """

    NUMBA = "numba"
    PYTHON = "python"


def default_engine() -> Engine:
    """Return NUMBA if it is installed, else PYTHON."""
    return Engine.NUMBA if numba_available() else Engine.PYTHON


def load(name: str, functions: Sequence[SourceFunction], engine: Engine) -> Compiled:
    """Return the last function of a generated module.

    With numba the machine code is kept in the cache folder under a name that holds the hash of the source:
    the next process loads it from there. Sums are compiled in the order in which they are written (no
    fastmath), so that the same source yields the same bits.

    Args:
        name: Python identifier that names the module.
        functions: in order; later ones may call earlier ones.
        engine: the way to execute them.
    """
    return _load(name, tuple(functions), engine)


@lru_cache(maxsize=64)
def _load(name: str, functions: tuple[SourceFunction, ...], engine: Engine) -> Compiled:
    last = functions[-1]
    source = "\n\n".join(function.text for function in functions)
    plain: Compiled = _run(source, name, {"math": math, "np": np})[last.name]
    if engine is Engine.PYTHON:
        return plain
    signature = Signature.parse(last.signature)
    kinds = "".join(f"# {one.name}: {one.signature} {one.form} {one.bounds}\n" for one in functions)

    def build(compiler: Compiler) -> FunctionType:
        return entry_of(compiled_functions(functions, compiler)[last.name], signature, compiler)

    return compiled(name, kinds + source, signature, build, plain)


def compiled_functions(functions: Sequence[SourceFunction], compiler: Compiler) -> dict[str, Any]:
    """Return the functions of a module for callers in compiled code, by name."""
    scope: dict[str, Any] = {"math": math, "np": np}
    for k, one in enumerate(functions):
        scope[one.name] = _inside(one, functions[:k], compiler, scope)
    return scope


def _inside(
    function: SourceFunction, before: Sequence[SourceFunction], compiler: Compiler, scope: dict[str, Any]
) -> Compiled:
    """Return a function for callers in compiled code; it may call earlier ones, which are in the scope."""
    if compiler.writes_instructions and function.form is not Form.ANY:
        from ropsim.codegen.vector.straight_line import straight_line, straight_rows

        if function.form is Form.STRAIGHT_LINE:
            return straight_line(function.text)
        shared = function.text.partition("(")[2].partition(",")[0]
        return straight_rows(before[-1].text, function.name, shared)
    others = (one.name for one in before if one.name != function.name)
    if any(re.search(rf"\b{name}\b", function.text) for name in others):
        made = _run(function.text, function.name, scope)[function.name]
        return compiler.inside_as(made, function.signature, function.bounds)
    return _lone(compiler, function.name, function.text, function.signature, function.bounds)


@lru_cache(maxsize=64)
def _lone(compiler: Compiler, name: str, text: str, signature: str, bounds: Bounds) -> Compiled:
    """Return a function that calls no other one: compiled once in a process for all modules.

    The law of a joint controller is the same for many arms, and the functions for links of long arms are the
    same for all.
    """
    function = _run(text, name, {"math": math, "np": np})[name]
    return compiler.inside_as(function, signature, bounds)


def _run(source: str, name: str, scope: dict[str, Any]) -> dict[str, Any]:
    exec(compile(source, f"<generated {name}>", "exec"), scope)  # our own source
    return scope
