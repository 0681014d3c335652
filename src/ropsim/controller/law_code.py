"""The source of a compiled law as code: its arguments, and rows that it names."""

import ast
import math
from collections.abc import Callable, Mapping
from functools import lru_cache
from typing import Any

import numpy as np

from ropsim.codegen import Bounds, SourceFunction
from ropsim.controller.law import CompiledLaw
from ropsim.core import frozen_dataclass
from ropsim.spatial import Array

ARGUMENTS = {
    "par": "f8[:,::1]",
    "state": "f8[:,::1]",
    "ref": "f8[:,::1]",
    "meas": "f8[:,::1]",
    "sensed": "f8[:,::1]",
    "drive": "f8[:,::1]",
    "model": "f8[::1]",
    "work": "f8[:,::1]",
    "load": "f8[::1]",
    "aux": "f8[::1]",
    "out": "f8[::1]",
}
"""Arguments that a law may have, in any order, and their types."""
CLASSIC = ("par", "state", "ref", "meas", "load", "aux", "out")
"""Arguments of a law that has them under other names, by their places."""


@frozen_dataclass
class LawCode:
    """A law as code.

    Attributes:
        arguments: names of the arguments of `law`, in its order.
        text: its source, with numbers in place of names of rows.
        unknown: arguments that no law has.
    """

    arguments: tuple[str, ...]
    text: str
    unknown: tuple[str, ...] = ()

    @property
    def function(self) -> SourceFunction:
        """Return the function `law` of a generated module."""
        signature = f"void({', '.join(ARGUMENTS[name] for name in self.arguments)})"
        return SourceFunction("law", signature, self.text, Bounds.CHECKED)


def law_code(law: CompiledLaw) -> LawCode:
    """Return the code of a law; a source that is no Python, or has no `law`, stays as it is."""
    names = {
        "par": law.parameter_names,
        "state": law.traits.state_names,
        "sensed": law.traits.sensed,
        "drive": law.model.drive_names if law.model else (),
        "work": law.work_names,
    }
    return _read(law.source, tuple(names.items()))


def law_functions(law: CompiledLaw) -> tuple[SourceFunction, ...]:
    """Return the functions that the source of a law may call."""
    return (*law.functions, *(law.model.functions(law.source) if law.model else ()))


def in_python(law: CompiledLaw) -> Callable[[Mapping[str, Array]], None]:
    """Return a law as a function of its arrays by name, `out` among them, in plain Python.

    Raises:
        KeyError: the source defines no `law`.
        Exception: whatever its source raises.
    """
    scope: dict[str, Any] = {"math": math, "np": np}
    for one in law_functions(law):
        exec(one.text, scope)
    code = law_code(law)
    exec(compile(code.text, f"<law {law.name}>", "exec"), scope)  # its author runs this process
    function = scope["law"]

    def call(arrays: Mapping[str, Array]) -> None:
        function(*(arrays[name] for name in code.arguments))

    return call


def law_arrays(law: CompiledLaw, n: int) -> dict[str, Array]:
    """Return the arguments of a law for an arm of n axes: its parameters and model, and zeros."""
    rows = {"state": len(law.traits.state_names), "ref": 3, "meas": 3}
    rows |= {"sensed": len(law.traits.sensed), "work": len(law.work_names)}
    return {
        **{name: np.zeros((count, n)) for name, count in rows.items()},
        "par": np.array(law.parameters),
        "drive": np.array(law.model.drives) if law.model else np.zeros((0, n)),
        "model": np.array(law.model.numbers) if law.model else np.zeros(0),
        "load": np.zeros(10),
        "aux": np.zeros(len(law.traits.aux)),
        "out": np.zeros(n),
    }


@lru_cache(maxsize=64)
def _read(source: str, rows: tuple[tuple[str, tuple[str, ...]], ...]) -> LawCode:
    plain = LawCode(CLASSIC, source)
    try:
        tree = ast.parse(source)
    except (SyntaxError, ValueError, RecursionError):
        return plain
    laws = [one for one in tree.body if isinstance(one, ast.FunctionDef) and one.name == "law"]
    if not laws:
        return plain
    given = tuple(one.arg for one in (*laws[-1].args.posonlyargs, *laws[-1].args.args))
    unknown = tuple(name for name in given if name not in ARGUMENTS)
    if unknown and len(given) == len(CLASSIC):
        return plain
    if unknown:
        return LawCode(CLASSIC, source, unknown)
    return LawCode(given, _numbered(source, laws[-1], dict(rows)))


def _numbered(source: str, law: ast.FunctionDef, rows: Mapping[str, tuple[str, ...]]) -> str:
    """Return a source with `par[kp, j]` as `par[0, j]`, unless the name is counted in the function."""
    counted = [one.target for one in ast.walk(law) if isinstance(one, ast.For | ast.AugAssign)]
    stored = [one for target in counted for one in ast.walk(target) if isinstance(one, ast.Name)]
    own = {one.id for one in stored if isinstance(one.ctx, ast.Store)}
    found = []
    for one in ast.walk(law):
        if not (isinstance(one, ast.Subscript) and isinstance(one.value, ast.Name)):
            continue
        first = one.slice.elts[0] if isinstance(one.slice, ast.Tuple) and one.slice.elts else one.slice
        names = rows.get(one.value.id, ())
        if isinstance(first, ast.Name) and first.id in names and first.id not in own:
            found.append((first.lineno - 1, first.col_offset, first.end_col_offset, names.index(first.id)))
    lines = source.encode().split(b"\n")
    for line, begin, end, number in sorted(found, reverse=True):
        lines[line] = lines[line][:begin] + str(number).encode() + lines[line][end:]
    return b"\n".join(lines).decode()
