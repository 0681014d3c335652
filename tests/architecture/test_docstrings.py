"""Docstrings name arguments and identifiers that exist: a renamed one is renamed in them too."""

import ast
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from support.sources import SOURCE, nodes, trees

ROOT = Path(__file__).parents[2]
NAME = re.compile(r"`([A-Za-z_]\w*(?:\.[A-Za-z_]\w*)*)`")
SECTION = re.compile(r"\nArgs:\n((?: {4}.*\n?|\n)+)")
ARGUMENT = re.compile(r"^ {4}\*{0,2}(\w+)[:,]", re.MULTILINE)
TEXTS = ("*.pl", "*.toml", "*.ts", "*.tsx", "*.md", "*.task", "*.exp", "Makefile")
"""Files whose words are names too: knowledge base, tables, pages, the manual."""

OUTSIDE = {
    "Authorization",  # a header of HTTP
    "LockFileEx",
    "flock",
    "invoke_viii",  # a function that the Prolog system imports
    "moments_of_inertia_representation",  # an entity of ISO 10303-41
    "savez_compressed",
}
"""Names of other systems, and of examples."""

Documented = ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef


def documented(tree: ast.Module) -> Iterator[tuple[Documented, str]]:
    """Yield the classes and functions of a module that have a docstring, with it."""
    kinds: tuple[type[Documented], ...] = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)
    for kind in kinds:
        for node in nodes(tree, kind):
            if text := ast.get_docstring(node):
                yield node, text


def parameters(node: Documented) -> set[str] | None:
    """Return the parameters of a function, or of the constructor of a class; None if it is inherited."""
    if isinstance(node, ast.ClassDef):
        own = [one for one in node.body if isinstance(one, ast.FunctionDef) and one.name == "__init__"]
        return parameters(own[0]) if own else None
    all_of = node.args
    every = [*all_of.posonlyargs, *all_of.args, *all_of.kwonlyargs]
    return {one.arg for one in (*every, all_of.vararg, all_of.kwarg) if one is not None}


def absent_arguments(tree: ast.Module) -> Iterator[str]:
    """Yield each argument that a docstring describes and its function does not have."""
    for node, text in documented(tree):
        known, section = parameters(node), SECTION.search(text + "\n")
        if known is not None and section is not None:
            described = ARGUMENT.findall(section[1])
            yield from (f"{node.lineno}: {node.name}: {one}" for one in described if one not in known)


@cache
def words() -> frozenset[str]:
    """Return all names of the source, and the words of its texts."""
    found: set[str] = set()
    for path, tree in trees().items():
        found.update(re.findall(r"\w+", path))
        found |= {node.id for node in nodes(tree, ast.Name)} | {node.arg for node in nodes(tree, ast.arg)}
        found |= {node.attr for node in nodes(tree, ast.Attribute)}
        found |= {one for node in nodes(tree, ast.alias) for one in re.findall(r"\w+", node.name)}
        found |= {node.name for node in nodes(tree, ast.FunctionDef)}
        found |= {node.name for node in nodes(tree, ast.ClassDef)}
        found |= {node.arg for node in nodes(tree, ast.keyword) if node.arg}
        docs = {id(node.value) for node in nodes(tree, ast.Expr)}
        for one in nodes(tree, ast.Constant):
            if isinstance(one.value, str) and id(one) not in docs:
                found.update(re.findall(r"\w+", one.value))
    folders = (ROOT / "docs", ROOT / "frontend" / "src", SOURCE, ROOT / "tools", ROOT / "examples")
    for folder in folders:
        for pattern in TEXTS:
            for text in folder.rglob(pattern):
                found.update(re.findall(r"\w+", text.read_text("utf-8", errors="ignore")))
    return frozenset(found)


def absent_names(tree: ast.Module) -> Iterator[str]:
    """Yield each name in backticks in a docstring that is nowhere else; names with a number are examples."""
    for node in nodes(tree, ast.Expr):
        if isinstance(node.value, ast.Constant) and isinstance(node.value.value, str):
            named = [one for one in NAME.findall(node.value.value) if not one[-1].isdigit()]
            missing = [one for one in named if not words().issuperset({*one.split(".")} - OUTSIDE)]
            yield from (f"{node.lineno}: {one}" for one in missing)


def test_described_arguments_exist() -> None:
    found = [f"{path}:{one}" for path, tree in trees().items() for one in absent_arguments(tree)]
    assert not found, "\n".join(found)


def test_names_in_docstrings_exist() -> None:
    found = [f"{path}:{one}" for path, tree in trees().items() for one in absent_names(tree)]
    assert not found, "\n".join(found)


def test_an_absent_argument_and_an_absent_name_are_seen() -> None:
    text = 'def f(given):\n    """Return `gone_for_ever`.\n\n    Args:\n        asked: of it.\n    """\n'
    tree = ast.parse(text)
    assert [one.split(": ")[-1] for one in absent_arguments(tree)] == ["asked"]
    assert [one.split(": ")[-1] for one in absent_names(tree)] == ["gone_for_ever"]
