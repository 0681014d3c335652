"""The modules of ropsim as syntax trees, read once in each process."""

import ast
import gc
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import TypeVar

import ropsim
from ropsim.core import without_collection

SOURCE = Path(ropsim.__file__).parent

N = TypeVar("N", bound=ast.AST)


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


def nodes(tree: ast.AST, kind: type[N]) -> Iterator[N]:
    """Yield the nodes of a class in a tree, in the order of `ast.walk`; each tree is walked once."""
    for node_class, found in _by_class(tree).items():
        if issubclass(node_class, kind):
            yield from found  # type: ignore[misc]  # all of them are of `node_class`


@cache
def _by_class(tree: ast.AST) -> dict[type[ast.AST], list[ast.AST]]:
    found: dict[type[ast.AST], list[ast.AST]] = {}
    for node in ast.walk(tree):
        found.setdefault(type(node), []).append(node)
    return found
