"""The text of a function that calls no other one: compiled once in a process, whoever calls it.

The law of a joint controller is the same for many an arm, what moves the links of a long one for all.
"""

import math
from collections.abc import Callable
from functools import lru_cache
from typing import Any

import numpy as np

from ropsim.codegen.stages import inside_as


@lru_cache(maxsize=64)
def lone_text(name: str, text: str, signature: str, *, boundscheck: bool) -> Callable[..., None]:
    """Return a function for callers in compiled code, as `ropsim.codegen.stages.inside_as` makes it.

    Args:
        name: of the function.
        text: its `def` statement, which may use `math` and `np`.
        signature: as numba writes it.
        boundscheck: whether it looks at every index before it uses it.
    """
    scope: dict[str, Any] = {"math": math, "np": np}
    exec(compile(text, f"<generated {name}>", "exec"), scope)  # our own source
    return inside_as(signature, boundscheck=boundscheck)(scope[name])
