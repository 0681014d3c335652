"""What pages count: robots by their makers, tasks of the library."""

import re

import pytest

from ropsim.robots import catalogue
from ropsim.tasks.testing import library_texts
from support.manual import DOCS

PAGES = {"README.md": DOCS.parent / "README.md", "what-it-does.md": DOCS / "explanation" / "what-it-does.md"}
TENS = ("twenty", "thirty", "forty", "fifty")
ONES = ("", "-one", "-two", "-three", "-four", "-five", "-six", "-seven", "-eight", "-nine")


@pytest.mark.parametrize("page", PAGES)
def test_robots_of_makers_are_as_many_as_there_are(page: str) -> None:
    makers = [one.maker for one in catalogue() if one.maker]
    listed = sorted({*makers})
    words = f"{', '.join(listed[:-1])} and {listed[-1]}"
    number = f"{TENS[len(makers) // 10 - 2]}{ONES[len(makers) % 10]}"
    text = re.sub(r"\[|\]\([^)]*\)", "", PAGES[page].read_text("utf-8"))
    assert f"{number} arms of {words}".lower() in text.lower()


def test_tasks_of_the_library_are_as_many_as_there_are() -> None:
    count = sum(len(re.findall(r"^task\(", one.text, re.MULTILINE)) for one in library_texts())
    assert f"a library of {count} tasks" in PAGES["what-it-does.md"].read_text("utf-8")
