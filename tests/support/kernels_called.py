"""All kernels of ropsim, and a plugin of pytest: at its end it prints those that no test has called."""

import importlib
import pkgutil

import pytest

import ropsim
from ropsim.codegen import Kernel


def all_kernels() -> list[Kernel]:
    """Return the kernels of all modules whose name ends with `_kernel`."""
    found: dict[int, Kernel] = {}
    for module in pkgutil.walk_packages(ropsim.__path__, "ropsim."):
        if module.name.endswith("_kernel"):
            own = vars(importlib.import_module(module.name)).values()
            found |= {id(one): one for one in own if isinstance(one, Kernel)}
    return list(found.values())


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Print the names of the kernels that were not called, a line each."""
    for one in all_kernels():
        if one._made is None:
            terminalreporter.write_line(f"not called: {one.function.__module__}.{one.function.__name__}")
