"""The modules of ropsim as syntax trees, read once in each process."""

import ast
import gc
from functools import cache
from pathlib import Path

import ropsim
from ropsim.core import without_collection

SOURCE = Path(ropsim.__file__).parent


@cache
def trees() -> dict[str, ast.Module]:
    """Return the syntax tree of every module by its path in the package.

    A million objects that stay: whoever looks for garbage need not look through them.
    """
    gc.collect()
    with without_collection():
        read = {
            path.relative_to(SOURCE).as_posix(): ast.parse(path.read_text("utf-8"))
            for path in SOURCE.rglob("*.py")
        }
        gc.freeze()
    return read
