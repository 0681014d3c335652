"""What start-up must not load: heavy packages come when they are needed."""

import subprocess
import sys

import pytest

SERVING = ("msgspec", "starlette", "uvicorn", "websockets")
HEAVY = ("numpy", "numba", "scipy", "pandas", "wasmtime", "filelock", "platformdirs", *SERVING)


def loaded_after(program: str) -> set[str]:
    ending = "; import sys; print('\\n' + ' '.join(sys.modules))"
    result = subprocess.run(
        [sys.executable, "-c", program + ending], capture_output=True, text=True, check=True
    )
    return set(result.stdout.split("\n")[-2].split())


@pytest.mark.parametrize("argument", ["--version", "--help"])
def test_version_and_help_import_nothing_heavy(argument: str) -> None:
    program = (
        "import contextlib, ropsim.cli.main as m\n"
        f"with contextlib.suppress(SystemExit): m.main([{argument!r}])\n"
        "pass"
    )
    loaded = loaded_after(program)
    assert "ropsim.cli.main" in loaded
    assert loaded.isdisjoint(HEAVY)


def test_the_root_alone_imports_next_to_nothing() -> None:
    loaded = loaded_after("import ropsim")
    assert {name for name in loaded if name.startswith("ropsim")} == {"ropsim", "ropsim.version"}


@pytest.mark.parametrize(
    "package", ["language", "program", "icr", "model", "cellfile", "records", "workbench", "views"]
)
def test_compiling_and_reading_do_not_import_numba(package: str) -> None:
    assert "numba" not in loaded_after(f"import ropsim.{package}")


@pytest.mark.parametrize(
    "program", ["ropsim.workbench", "ropsim.cli.commands.run", "ropsim.cli.commands.check"]
)
def test_only_the_studio_and_meshes_import_what_serves_them(program: str) -> None:
    assert loaded_after(f"import {program}").isdisjoint(SERVING)


@pytest.mark.parametrize("package", ["ropsim.workbench", "ropsim.lsp"])
def test_checking_a_text_loads_neither_what_runs_it_nor_what_shows_it(package: str) -> None:
    loaded = loaded_after(f"import {package}")
    assert loaded.isdisjoint({"ropsim.simulation", "ropsim.views"})
    assert loaded.isdisjoint({"ropsim.exchange", "ropsim.nirox"})  # come with their first file
    assert loaded.isdisjoint({"http", "ssl", "email"})


def test_the_module_is_the_command() -> None:
    result = subprocess.run(
        [sys.executable, "-m", "ropsim", "--version"], capture_output=True, text=True, check=True
    )
    assert "0.1.0" in result.stdout
