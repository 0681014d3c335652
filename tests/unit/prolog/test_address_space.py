"""Prolog in a process that may have little address space, and where there is none left."""

import subprocess
import sys

import pytest

pytestmark = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="limits of Linux")

TWO = """
import resource
resource.setrlimit(resource.RLIMIT_AS, (9_000_000 << 10, 9_000_000 << 10))
from ropsim.prolog import Engine
print(*(Engine().once("X = 1")["X"] for _ in range(2)), sep="")
engines = [Engine(), Engine()]
print(*(engine.once("X is 2 + 1")["X"] for engine in engines), sep="")
"""
NONE = """
import resource
import wasmtime
from pathlib import Path
from ropsim.core import shortage
from ropsim.prolog import Engine
Engine().once("X = 1")
pages = int(Path("/proc/self/statm").read_text().split()[0])
least = pages * resource.getpagesize() + (16 << 20)
resource.setrlimit(resource.RLIMIT_AS, (least, least))
engines = []
try:
    while len(engines) < 100:
        engines.append(Engine())
        engines[-1].once("X = 1")
except MemoryError as error:
    print(shortage(error).code)
"""


def ran(program: str) -> list[str]:
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    return done.stdout.split()


def test_two_engines_fit_into_nine_gigabytes() -> None:
    assert ran(TWO) == ["11", "33"]


def test_where_no_addresses_are_left_the_finding_says_so() -> None:
    assert ran(NONE) == ["X920"]
