"""Which lines know which names: the compiler and what editors offer say the same."""

import re

import pytest

from ropsim.core import SourceText
from ropsim.language import LineCache, Space, Uses, uses_of
from support.tasks import CELL, compiled

HEAD = "program p\nunits mm, deg, s\npattern slots = grid 2 from (0, 0, 40) step (70, 0, 0)\n"
LOOPS = """for each s in slots
  a = s.x
  for i = 1 to 2
    b = i
  endf
  for each s in slots
    for i = 5 to 6
    endf
  endf
end
c = 1
for c = 2 to 3
endf
"""
TASKS = """x = 1
task A(q: loc, n: int)
  y = n
  # a remark
  if part_ok then
    z = 2
  elseif n > 3 then
    z = 4
  else
    w = 3
  endif
  for n = 1 to 2
    repeat 2
      v = n
    until v > 3
  endf
endp

z = x
task B()
  load (u, v, w), (1, 2, 3)
endp
A (1, 2, 3), 4
var g: int = 0
const k = 3
loc corner = (1, 2, 3)
signal lamp = output 7
"""
CUT = """task A(q: loc)
  for each s in slots
    if s.row > 1 then
      t = 2

"""
WIDE = """total =
task A(n: int)
  total = (n +
    2)
  while total > 3
    last = (total
      - 1)
    print last
  endw
endp
"""


def seen(text: str) -> Uses:
    outside = frozenset((*CELL.locations, *CELL.signals))
    return uses_of(SourceText("t.task", text), LineCache(), outside)


def names(text: str, line: int) -> set[str]:
    return {name for space, name in seen(text).seen_at(line) if space is Space.SYMBOL}


def is_known(lines: list[str], number: int, name: str) -> bool:
    """Return whether the compiler knows a name at the begin of a line."""
    text = "\n".join([*lines[: number - 1], f"print {name}", *lines[number - 1 :]])
    found = compiled(text).diagnostics
    return not any(one.code == "N202" and one.span and one.span.line == number for one in found)


@pytest.mark.parametrize("text", [LOOPS, TASKS], ids=["loops", "tasks"])
def test_a_line_sees_what_the_compiler_knows_there(text: str) -> None:
    lines = (HEAD + text).split("\n")
    told = seen(HEAD + text)
    symbols = {m.name for m in told.meanings() if m.space is Space.SYMBOL and m.role is not None}
    assert len(symbols) > 5
    within = re.compile(r"(?!\s*(task|end|else))")  # a line put before one of these stands in another block
    for number in range(4, len(lines) + 1):
        if not within.match(lines[number - 1]):
            continue
        known = {name for name in symbols if is_known(lines, number, name)}
        assert {name for space, name in told.seen_at(number) if space is Space.SYMBOL} == known, number


@pytest.mark.parametrize("text", [LOOPS, TASKS, CUT, WIDE], ids=["loops", "tasks", "cut", "wide"])
def test_what_a_name_means_at_its_place_a_statement_there_can_name(text: str) -> None:
    told = seen(HEAD + text)
    for use in told.found:
        meaning = use.meaning
        begins = meaning.definition is not None and meaning.definition.line == use.span.line
        if meaning.role is not None and meaning.space is Space.SYMBOL and not begins:
            assert told.seen_at(use.span.line)[Space.SYMBOL, meaning.name] == meaning


def test_a_block_without_end_reaches_to_the_end_of_the_task_or_text() -> None:
    assert names(HEAD + CUT, 9) == {"slots", "q", "s", "t"}
    after = HEAD + CUT + "endp\n\ntask B()\n"
    assert names(after, 8) == {"slots", "q", "s", "t"}
    assert names(after, 10) == {"slots"}


def test_a_statement_over_several_lines_knows_its_variable_behind_it() -> None:
    knows = ["last" in names(HEAD + WIDE, line) for line in (9, 10, 11, 12, 13)]
    assert knows == [False, False, True, True, False]


def test_a_classic_task_knows_an_implicit_parameter_behind_the_line_that_reads_it() -> None:
    text = "task A\n  mov slot above 20\n\nendp\n"
    assert ["slot" in names(text, line) for line in (2, 3, 4)] == [False, True, False]
