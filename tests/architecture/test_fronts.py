"""Fronts: what a package offers stands in its `__init__.py`, and nobody reaches behind it from outside.

The packages are those directly below `ropsim`; inside one of them modules import each other. A contract of
import-linter cannot say this: to it `from ropsim.simulation import run` is an import of the module `run`,
although the front offers a function of that name.
"""

import ast
import re
from collections.abc import Iterator, Sequence
from functools import cache
from pathlib import Path

import pytest

import ropsim
from support.pages import Step, steps
from support.sources import nodes, trees

SOURCE = Path(ropsim.__file__).parent
ROOT = Path(__file__).parents[2]
PACKAGES = frozenset(path.parent.name for path in SOURCE.glob("*/__init__.py"))
DEEP_IMPORTS = 145
"""Imports of tests from behind fronts."""
FRONT = re.compile(r"src/ropsim/(\w+)/__init__\.py")


@cache
def offered(package: str) -> frozenset[str]:
    """Return the names that the front of a package binds, those for type checkers included."""
    tree = ast.parse((SOURCE / package / "__init__.py").read_text("utf-8"))
    names = [
        alias.asname or alias.name
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    ]
    return frozenset(names)


def behind_fronts(tree: ast.Module, own: str = "") -> list[str]:
    """Return what a module of the package `own` takes from others except through their fronts."""
    found = [*nodes(tree, ast.Import), *nodes(tree, ast.ImportFrom), *nodes(tree, ast.Attribute)]
    return [one for node in found for one in _behind(node, own)] + _through(found, own)


def _behind(node: ast.AST, own: str) -> Iterator[str]:
    match node:
        case ast.Import(names=names):
            for alias in names:
                root, _, rest = alias.name.partition(".")
                package, dot, _ = rest.partition(".")
                if root == "ropsim" and dot and package != own:
                    yield alias.name
        case ast.ImportFrom(module=str() as module, level=0, names=names) if module.startswith("ropsim."):
            package, dot, _ = module.removeprefix("ropsim.").partition(".")
            if package in PACKAGES - {own}:
                known = frozenset() if dot else offered(package)
                yield from (f"{module}.{alias.name}" for alias in names if alias.name not in known)
        case _:
            pass


def _through(found: Sequence[ast.AST], own: str) -> list[str]:
    """Return modules that are reached as attributes, as `icr.machine` is after `from ropsim import icr`."""
    called = {
        alias.asname or alias.name: alias.name
        for node in found
        if isinstance(node, ast.ImportFrom) and node.module == "ropsim"
        for alias in node.names
        if alias.name in PACKAGES - {own}
    }
    return [
        f"ropsim.{package}.{node.attr}"
        for node in found
        if isinstance(node, ast.Attribute)
        and isinstance(node.value, ast.Name)
        and (package := called.get(node.value.id)) is not None
        and any((SOURCE / package / name).exists() for name in (node.attr, f"{node.attr}.py"))
        and node.attr not in offered(package)
    ]


@pytest.mark.parametrize(
    "line",
    [
        "import ropsim.views.terminal.run",
        "from ropsim.views.html.report import html_report",
        "from ropsim.views import terminal",
        "from ropsim import views\nviews.terminal.terminal_report(summary)",
        "def f() -> None:\n    from ropsim.views.summary.summary import summarize",
    ],
)
def test_reaching_behind_a_front_is_found(line: str) -> None:
    assert behind_fronts(ast.parse(line), "simulation")
    assert behind_fronts(ast.parse(line), "views") == []


@pytest.mark.parametrize(
    "line",
    [
        "import ropsim.views",
        "from ropsim.views import summarize as shortened, scene",
        "from ropsim import views\nviews.summarize(recording)",
        "from ropsim.version import __version__",
    ],
)
def test_what_a_front_offers_may_be_used(line: str) -> None:
    assert behind_fronts(ast.parse(line), "simulation") == []


@pytest.mark.parametrize("package", sorted(PACKAGES))
def test_a_package_enters_others_through_their_fronts(package: str) -> None:
    own = {path: tree for path, tree in trees().items() if path.startswith(f"{package}/")}
    assert own
    assert {f"{path}: {one}" for path, tree in own.items() for one in behind_fronts(tree, package)} == set()


@pytest.mark.parametrize("folder", ["tools", "examples"])
def test_tools_and_examples_use_what_the_fronts_offer(folder: str) -> None:
    found = {
        f"{path.relative_to(ROOT)}: {one}"
        for path in (ROOT / folder).rglob("*.py")
        for one in behind_fronts(ast.parse(path.read_text("utf-8")))
    }
    assert found == set()


def test_pages_show_what_the_fronts_offer() -> None:
    pages = [*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md")]
    assert sum(step.language == "python" for page in pages for step in steps(page)) > 10
    found = {
        f"{page.relative_to(ROOT)}: {one}"
        for page in pages
        for step in steps(page)
        if step.language == "python"
        for one in behind_fronts(ast.parse(step.text), own_package(step))
        if one not in added_to_fronts(page)
    }
    assert found == set()


def own_package(step: Step) -> str:
    """Return the package of ropsim to which a file of a page belongs, empty for one of a user."""
    parts = Path(step.path).parts
    return parts[2] if parts[:2] == ("src", "ropsim") else ""


def added_to_fronts(page: Path) -> set[str]:
    """Return the names, with their packages, that the edits of a page add to fronts."""
    return {
        f"ropsim.{front[1]}.{alias.name}"
        for step in steps(page)
        if step.mode == "edit" and (front := FRONT.fullmatch(step.path))
        for line in step.text.splitlines()
        if line.startswith("+from")
        for node in ast.parse(line[1:]).body
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    }


def deep_imports(text: str) -> list[str]:
    """Return the modules behind fronts from which a text imports; the door `testing` of a package is none."""
    nodes = list(ast.walk(ast.parse(text)))
    modules = [node.module or "" for node in nodes if isinstance(node, ast.ImportFrom)]
    modules += [one.name for node in nodes if isinstance(node, ast.Import) for one in node.names]
    return [
        one for one in modules if re.fullmatch(r"ropsim(\.\w+){2,}", one) and not one.endswith(".testing")
    ]


def test_deep_imports_are_seen_and_doors_are_none() -> None:
    text = (
        "from ropsim.studio.wire import jobs\nimport ropsim.cli.main\nfrom ropsim.lsp.testing import Document"
    )
    assert deep_imports(f"from ropsim.flow import Event\n{text}") == ["ropsim.studio.wire", "ropsim.cli.main"]


def test_tests_enter_packages_by_fronts_and_doors() -> None:
    """The number only falls: a test that needs more takes it from `ropsim/PACKAGE/testing.py`."""
    found = [one for path in (ROOT / "tests").rglob("*.py") for one in deep_imports(path.read_text("utf-8"))]
    assert len(found) <= DEEP_IMPORTS
