"""Circles: no module needs itself over others, also not over fronts, over imports in functions or for types.

The contract of import-linter compares neighbours in a folder; a front and the modules behind it are no
neighbours, so they are looked at here.
"""

import ast
from graphlib import CycleError, TopologicalSorter

import pytest

from support.sources import nodes, trees


def modules() -> dict[str, ast.Module]:
    """Return the trees of all modules by their full names; a front has the name of its package."""
    named = {}
    for path, tree in trees().items():
        parts = ("ropsim", *path.removesuffix(".py").split("/"))
        named[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = tree
    return named


def imported(tree: ast.Module, known: frozenset[str]) -> set[str]:
    """Return which of the known modules a module imports, wherever in its text."""
    found = set()
    for node in nodes(tree, ast.Import):
        found |= {alias.name for alias in node.names}
    for one in nodes(tree, ast.ImportFrom):
        if one.module and not one.level:
            wanted = [f"{one.module}.{alias.name}" for alias in one.names]
            found |= {full if full in known else one.module for full in wanted}
    return found & known


def circle(graph: dict[str, set[str]]) -> list[str]:
    """Return the modules of a circle, the first one twice, or nothing."""
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        return list(error.args[1])
    return []


@pytest.mark.parametrize(
    "line",
    ["from ropsim.a import thing", "import ropsim.a", "def f() -> None:\n    from ropsim.a import thing"],
)
def test_a_circle_over_a_front_is_found(line: str) -> None:
    texts = {"ropsim.a": "from ropsim.a.b import thing as thing", "ropsim.a.b": line}
    graph = {name: imported(ast.parse(text), frozenset(texts)) for name, text in texts.items()}
    assert circle(graph)


def test_no_module_of_ropsim_needs_itself_over_others() -> None:
    named = modules()
    known = frozenset(named)
    graph = {name: imported(tree, known) - {name} for name, tree in named.items()}
    assert sum(len(others) for others in graph.values()) > 1000
    assert circle(graph) == []
