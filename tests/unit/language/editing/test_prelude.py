"""What a text defines stays on its lines; whether a text goes on is told by blocks and parentheses."""

import pytest

from ropsim.language import goes_on, prelude

TEXT = """program p   # name
units mm
# a note
loc a = (1, 2,
  3)
task T(q: loc)
  repeat 2
    lin q
  end
end
repeat 2
  const c = 3
  T a
end
var n: int
n = 3
task Last
  mov home
"""
KEPT = """program p   # name
units mm

loc a = (1, 2,
  3)
task T(q: loc)
  repeat 2
    lin q
  end
end




var n: int

task Last
  mov home
"""


def test_declarations_and_tasks_stay_where_they_are() -> None:
    assert prelude(TEXT) == KEPT
    assert prelude(KEPT) == KEPT


@pytest.mark.parametrize(
    "text",
    ["repeat 2", "task T\n  mov l", "if a then", "if a\nelse", "lin (1, 2,", "mov a \\", "repeat 2\nlin (1,"],
)
def test_a_text_that_is_not_whole_goes_on(text: str) -> None:
    assert goes_on(text)


@pytest.mark.parametrize(
    "text",
    [
        "",
        "mov a",
        "repeat 2\nend",
        "if a then mov b",
        "endr",
        "lin (1, 2))",
        "??",
        "try",
        "\n  repeat 2 3",
        "while",
    ],
)
def test_a_text_that_is_whole_does_not(text: str) -> None:
    assert not goes_on(text)
