"""What lines have by themselves is what the whole text has, too."""

from itertools import chain
from pathlib import Path

import pytest

from ropsim.core import SourceText
from ropsim.language import LineCache, compile, line_findings

EXAMPLES = Path(__file__).parents[4] / "examples"
TEXTS = sorted(EXAMPLES.glob("*/programs/*.task"))
MODERN = """program p
units mm
task Go(a: loc)
  needs gripper open
  and then it goes on (
  lin a above
endp
x = (1 + 2
mov (1, 2, 3
if x > 2 than
endif
lin here wth 3
Go (0, 0, 0)
"""


def found(text: str) -> list[tuple[str, object, str]]:
    return [(one.code, one.span, one.message) for one in line_findings(SourceText("t", text), LineCache())]


def test_findings_of_lines_are_among_those_of_the_text() -> None:
    whole = {(one.code, one.span, one.message) for one in compile(MODERN, name="t").diagnostics}
    assert len(found(MODERN)) >= 3
    assert set(found(MODERN)) <= whole


def test_lines_of_a_classic_text_may_be_prose() -> None:
    assert found(MODERN.replace("program p\n", "")) == []


@pytest.mark.parametrize("program", TEXTS, ids=lambda one: one.parts[-3])
def test_examples_with_a_letter_less_have_no_finding_that_the_text_has_not(program: Path) -> None:
    text = program.read_text("utf-8")
    for place in range(0, len(text), max(len(text) // 12, 1)):
        torn = text[:place] + text[place + 1 :]
        whole = {(one.code, one.span, one.message) for one in compile(torn, name="t").diagnostics}
        assert set(chain(found(torn))) <= whole
