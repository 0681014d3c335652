"""No law is lost: each test that `tests/laws.txt` names is there.

The list has tests of laws that hold for all inputs, and examples of manuals, literature and golden files:
tests with `given`, and those of `property`, `reference`, `spec` and `golden`. A law that is dropped or gets
another name is taken from the list by hand, and the diff is read.
"""

import re
from pathlib import Path

TESTS = Path(__file__).parents[1]


def test_each_listed_law_is_tested() -> None:
    listed = (TESTS / "laws.txt").read_text("utf-8").splitlines()
    texts = "".join(path.read_text("utf-8") for path in TESTS.rglob("test_*.py"))
    present = set(re.findall(r"^def (test_\w+)", texts, re.MULTILINE))
    assert [name for name in listed if name not in present] == []
    assert listed == sorted(set(listed))
