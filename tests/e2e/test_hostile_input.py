"""Hostile input to every reader: answered, quickly, with little memory and with nothing else opened.

`python -m tools.fuzz` reads a hundred thousand of each; docs/explanation/robustness.md tells what that found.
"""

import sys
from collections.abc import Iterator

import pytest

from support.fuzzing.guard import fuzz, nursery
from support.fuzzing.targets import MODULES, NAMES, targets_of
from support.nursery import Nursery

CASES = 100
SEED = 7
WORDS = {
    1: "KeyError",
    2: "memory",
    3: "open '/etc/hostname'",
    4: "socket",
    6: "hang",
    8: "died with -11",
}
"""What is said of the faulty cases, at its beginning."""

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(sys.platform == "win32", reason="the guard needs limits of POSIX"),
]


@pytest.fixture(scope="module")
def copies() -> Iterator[Nursery]:
    """Return what makes the processes that read."""
    with nursery() as running:
        yield running


@pytest.mark.parametrize("name", NAMES)
def test_hostile_input_is_answered(name: str, copies: Nursery) -> None:
    result = fuzz(copies, name, SEED, range(CASES))
    assert result.faults == {}
    assert result.cases == CASES
    assert result.answers["read"] > 0  # some of it is still right
    assert len(result.answers) > 1  # and some is not


@pytest.mark.parametrize("module", MODULES)
def test_every_target_of_a_module_is_listed(module: str) -> None:
    assert tuple(one.name for one in targets_of(module)) == MODULES[module]


def test_the_guard_sees_what_it_is_for(copies: Nursery) -> None:
    """Six faulty cases among right ones; a case that ends its process costs no other case."""
    found = fuzz(copies, "fault", SEED, range(10), hang=0.5)
    assert found.cases == 10
    assert {number: fault[: len(WORDS[number])] for number, fault in found.faults.items()} == WORDS
