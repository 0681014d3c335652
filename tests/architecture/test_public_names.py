"""Fronts: every public name exists, is imported from one place and has a docstring."""

import ast
import inspect
import re
from importlib import import_module
from pathlib import Path

import pytest

import ropsim

SOURCE = Path(ropsim.__file__).parent
PACKAGES = sorted(path.parent.name for path in SOURCE.glob("*/__init__.py"))


@pytest.mark.parametrize("name", ropsim.__all__)
def test_every_name_of_the_root_can_be_had(name: str) -> None:
    assert getattr(ropsim, name) is not None


def test_an_unknown_name_of_the_root_is_an_attribute_error() -> None:
    with pytest.raises(AttributeError, match="no attribute 'simulatoin'"):
        _ = ropsim.simulatoin


def test_the_root_offers_every_package_that_users_call() -> None:
    inner = {"cli", "codegen", "lsp", "query", "studio"}
    assert set(PACKAGES) - inner <= set(ropsim.__all__)


@pytest.mark.parametrize("package", PACKAGES)
def test_every_function_and_class_of_a_front_says_what_it_is(package: str) -> None:
    front = import_module(f"ropsim.{package}")
    assert front.__doc__
    silent = [
        name
        for name, value in vars(front).items()
        if not name.startswith("_")
        and (inspect.isfunction(value) or inspect.isclass(value))
        and not inspect.getdoc(value)
    ]
    assert silent == []


def test_the_code_map_names_every_package_that_there_is() -> None:
    text = (Path(__file__).parents[2] / "ARCHITECTURE.md").read_text("utf-8")
    rows = re.findall(r"^\| (`.+?) \|", text.split("## Code map")[1].split("\n## ")[0], re.MULTILINE)
    assert sorted(name for row in rows for name in re.findall(r"`(\w+)`", row)) == PACKAGES


@pytest.mark.parametrize("package", PACKAGES)
def test_a_front_offers_what_its_package_defines(package: str) -> None:
    tree = ast.parse((SOURCE / package / "__init__.py").read_text("utf-8"))
    offered = {
        alias.asname or alias.name
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith(f"ropsim.{package}.")
        for alias in node.names
    }
    assert offered
    front = import_module(f"ropsim.{package}")
    assert [name for name in sorted(offered) if not hasattr(front, name)] == []


def test_every_folder_with_code_is_a_package() -> None:
    folders = {path.parent for path in SOURCE.rglob("*.py")}
    assert [folder.name for folder in folders if not (folder / "__init__.py").exists()] == []
