"""From generated source to a callable function: compiled and cached on disk, or plain Python."""

import math
import re
from collections.abc import Sequence
from functools import lru_cache
from typing import Any

import numpy as np

from ropsim.codegen.compiled import compiled
from ropsim.codegen.direct import Compiled
from ropsim.codegen.emit import Bounds, Form, SourceFunction
from ropsim.codegen.engine import Engine
from ropsim.codegen.signature import Signature


def load(name: str, functions: Sequence[SourceFunction], engine: Engine) -> Compiled:
    """Return the last function of a generated module.

    With numba the machine code is kept in the cache folder under a name that holds the hash of the source:
    the next process loads it from there. Sums are compiled in the order in which they are written (no
    fastmath), so that the same source gives the same bits.

    Args:
        name: Python identifier that tells what the module is about.
        functions: in order; later ones may call earlier ones.
        engine: who runs it.
    """
    return _load(name, tuple(functions), engine)


@lru_cache(maxsize=64)
def _load(name: str, functions: tuple[SourceFunction, ...], engine: Engine) -> Compiled:
    last = functions[-1]
    if engine is Engine.PYTHON:
        source = "\n\n".join(function.text for function in functions)
        function: Compiled = _run(source, name, {"math": math, "np": np})[last.name]
        return function
    signature = Signature.parse(last.signature)
    source = compiled_source(functions)

    def build() -> tuple[Any, Compiled]:
        scope = _run(source, name, {})
        return scope["entry"], scope["last"]

    return compiled(name, source, signature, build)


_HEAD = """\
import math

import numpy as np

from ropsim.codegen.lone_text import lone_text
from ropsim.codegen.stages import array_at, inside_as
from ropsim.codegen.straight_line import straight_line, straight_rows
"""


def compiled_source(functions: Sequence[SourceFunction]) -> str:
    """Return the text of a module that knows its functions as compiled ones do; `entry` calls `last`."""
    *inner, last = functions
    parts = [_HEAD, *(_inside(one, inner[:k]) for k, one in enumerate(inner))]
    if last.form is not Form.ANY:
        parts.append(_inside(last, inner))
        taken = ", ".join(f"a{k}" for k in range(len(Signature.parse(last.signature).arguments)))
        last = SourceFunction("last", last.signature, f"def last({taken}):\n    {last.name}({taken})\n")
    parts.append(_inside(last, functions))
    parts.append(Signature.parse(last.signature).entry_text(last.name))
    return "\n\n".join((*parts, f"last = {last.name}\n"))


def _inside(function: SourceFunction, before: Sequence[SourceFunction]) -> str:
    """Return the text of a function that only compiled code calls; it may call those before it."""
    if function.form is Form.STRAIGHT_LINE:
        return f'{function.name} = straight_line("""\\\n{function.text}""")\n'
    if function.form is Form.ROW_BY_ROW:
        row = before[-1]
        shared = function.text.partition("(")[2].partition(",")[0]
        made = f'straight_rows("""\\\n{row.text}""", {function.name!r}, {shared!r})'
        return f"{function.name} = {made}\n"
    options = f'"{function.signature}", boundscheck={function.bounds is Bounds.CHECKED}'
    others = (one.name for one in before if one.name != function.name)
    if any(re.search(rf"\b{name}\b", function.text) for name in others):
        return f"@inside_as({options})\n{function.text}"
    return f"{function.name} = lone_text({function.name!r}, {function.text!r}, {options})\n"


def _run(source: str, name: str, scope: dict[str, Any]) -> dict[str, Any]:
    exec(compile(source, f"<generated {name}>", "exec"), scope)  # our own source
    return scope
