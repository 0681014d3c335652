"""The modules of ropsim as syntax trees, read once in each process."""

import ast
from functools import cache
from pathlib import Path

import ropsim

SOURCE = Path(ropsim.__file__).parent


@cache
def trees() -> dict[str, ast.Module]:
    """Return the syntax tree of every module by its path in the package."""
    return {
        path.relative_to(SOURCE).as_posix(): ast.parse(path.read_text("utf-8"))
        for path in SOURCE.rglob("*.py")
    }
