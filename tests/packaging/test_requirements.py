"""What an installation needs on each system: numba and llvmlite only where PyPI has wheels of them."""

import re
import tomllib
from functools import cache
from pathlib import Path

import pytest
from packaging.requirements import Requirement

ROOT = Path(__file__).parents[2]
COMPILERS = ("numba", "llvmlite")


@cache
def requirements() -> dict[str, Requirement]:
    """Return what pyproject.toml requires, by name."""
    with (ROOT / "pyproject.toml").open("rb") as file:
        named = tomllib.load(file)["project"]["dependencies"]
    return {one.name: one for one in map(Requirement, named)}


# Wheels of numba 0.68.1 and llvmlite 0.50.0 as `pip download --only-binary=:all: --platform …` finds them.
SYSTEMS = [
    ("linux", "x86_64", "3.11", True),
    ("linux", "x86_64", "3.14", True),
    ("linux", "aarch64", "3.12", True),
    ("linux", "armv7l", "3.12", False),
    ("linux", "i686", "3.12", False),
    ("linux", "riscv64", "3.13", False),
    ("darwin", "arm64", "3.13", True),
    ("darwin", "x86_64", "3.13", False),
    ("win32", "AMD64", "3.11", True),
    ("win32", "ARM64", "3.11", False),
    ("win32", "ARM64", "3.13", True),
    ("linux", "x86_64", "3.15", False),
]


@pytest.mark.parametrize(("system", "machine", "python", "has_wheels"), SYSTEMS)
@pytest.mark.parametrize("name", COMPILERS)
def test_numba_is_required_where_there_are_wheels_of_it(
    name: str, system: str, machine: str, python: str, has_wheels: bool
) -> None:
    marker = requirements()[name].marker
    assert marker is not None
    around = {"sys_platform": system, "platform_machine": machine, "python_version": python}
    assert marker.evaluate({**around, "platform_python_implementation": "CPython"}) is has_wheels
    assert not marker.evaluate({**around, "platform_python_implementation": "PyPy"})


def test_everything_else_is_required_everywhere() -> None:
    assert [one.name for one in requirements().values() if one.marker is not None] == list(COMPILERS)


def test_the_page_on_installing_names_all_that_is_needed_without_numba() -> None:
    """On musl systems no marker of a requirement helps: the page lists what to install by hand."""
    page = (ROOT / "docs" / "how-to" / "install.md").read_text("utf-8")
    (command,) = re.findall(r"pip install ('numpy(?:\\\n|.)*)", page)
    named = {Requirement(one) for one in re.findall(r"'(.*?)'", command)}
    assert named == {one for name, one in requirements().items() if name not in COMPILERS}


def test_each_requirement_has_a_version_for_development() -> None:
    pinned = re.findall(r"^([\w.-]+)==", (ROOT / "constraints.txt").read_text("utf-8"), re.MULTILINE)
    assert set(requirements()) <= set(pinned)
