"""Kernels stand alone: machine code that needs numba at run time makes every process wait for it."""

import subprocess
import sys

ALL_KERNELS = """
import importlib, pkgutil, sys
import ropsim
from ropsim.codegen.kernel import Kernel

found = set()
for module in pkgutil.walk_packages(ropsim.__path__, "ropsim."):
    if module.name.endswith("_kernel"):
        own = vars(importlib.import_module(module.name)).values()
        found.update(one for one in own if isinstance(one, Kernel))
for one in found:
    one.made()
print(len(found), "numba" in sys.modules)
"""


def kernels_made() -> tuple[int, bool]:
    """Return how many kernels a new process has made or loaded, and whether it needed numba."""
    result = subprocess.run([sys.executable, "-c", ALL_KERNELS], capture_output=True, text=True, check=True)
    count, needed = result.stdout.split()
    return int(count), needed == "True"


def test_kernels_that_are_kept_are_loaded_without_numba() -> None:
    first, _ = kernels_made()  # compiles what the cache folder does not hold yet
    again, needed = kernels_made()
    assert again == first > 30
    assert not needed
