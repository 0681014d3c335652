"""`end` closes the innermost block, whichever it is; elsewhere it stays a name."""

import pytest

from ropsim import icr
from ropsim.core import SourceText
from ropsim.language import LineCache, outline
from support.tasks import codes, compiled, only

LONG = """program p
units mm, deg, s
task Visit(q: loc, n: int)
  for i = 1 to n
    while q.z < 5 mm
      q.z = q.z + 1
    endw
    if i > 2 then
      with speed 20 mm/s
        lin q
      endwith
    else
      repeat 2
        mov q
      endr
    endif
  endf
endp
Visit infeed, 4
"""
CLOSERS = ("endw", "endwith", "endr", "endif", "endf", "endp")


def short(text: str) -> str:
    for word in CLOSERS:
        text = text.replace(f"{word}\n", "end\n")
    return text


def identity(text: str) -> str:
    code = compiled(text).icr
    assert code is not None, [str(one) for one in compiled(text).diagnostics]
    return icr.disassemble(code)


@pytest.mark.parametrize("written", ["end", "END", "End.", "end # of it", "end // of it"])
def test_every_kind_of_block_ends_with_end(written: str) -> None:
    assert identity(short(LONG).replace("end\n", f"{written}\n")) == identity(LONG)


def test_end_is_a_name_wherever_it_does_not_stand_alone() -> None:
    text = "program p\nend = 3\nfor i = 1 to end\n  end = end + i\nend\nprint end\n"
    assert identity(text).replace("end", "last") == identity(
        text.replace("end ", "last ").replace(" end\n", " last\n")
    )


@pytest.mark.parametrize("header", ["task end", "task END(q: loc)", '1. Task "end"'])
def test_no_task_is_called_end(header: str) -> None:
    assert codes(f"{header}\n  mov home\nendp\nmov home\n") == ["L101"]


def test_a_block_left_open_tells_which_one_its_end_has_closed() -> None:
    loops = "  repeat 2\n    mov home\n  end\n  repeat 3\n    mov home\n"
    finding = only(f"program p\ntask T\n{loops}end\ntask S\nend\nT\nS\n")
    assert (finding.code, finding.span and finding.span.line) == ("L106", 2)
    assert [(one.span.line, one.text) for one in finding.secondary] == [
        (8, "closes the `repeat`"),
        (6, "which begins here"),
    ]


def test_an_end_too_many_tells_which_block_the_one_before_has_closed() -> None:
    finding = only("program p\nrepeat 2\n  mov home\nend\nendr\n")
    assert (finding.code, finding.span and finding.span.line) == ("L107", 5)
    assert [one.span.line for one in finding.secondary] == [4, 2]


def test_an_end_too_many_closes_nothing() -> None:
    assert codes("program p\nmov home\nend\n") == ["L107"]


def test_an_end_closes_what_an_outer_end_has_cut_off() -> None:
    assert codes("program p\ntask T\n  repeat 2\n    mov home\nendp\nend\nT\n") == ["L106"]


@pytest.mark.parametrize(
    ("text", "code", "word"),
    [
        ("repeat 2\n  mov home\nedn\n", "N201", "end"),
        ("repaet 2\n  mov home\nend\n", "N201", "repeat"),
        ("if true then\n  mov home\nend if\n", "L101", "end"),
    ],
)
def test_a_misspelt_end_or_beginning_is_one_finding(text: str, code: str, word: str) -> None:
    finding = only("program p\n" + text)
    assert finding.code == code
    assert f"`{word}`" in finding.hint


def test_a_parenthesis_left_open_does_not_take_in_an_end() -> None:
    finding = only("program p\nrepeat 2\n  mov (1, 2, 3\nend\nmov home\n")
    assert (finding.code, finding.span and finding.span.line) == ("L101", 3)


def test_prose_of_a_classic_text_may_hold_the_word() -> None:
    text = "task T\n  needs gripper open at the\n  end\n  of the line.\n  mov home\nendp\nT\n"
    assert "L112" in codes(text)
    assert compiled(text.replace("end\n  of", "end of")).ok


def test_the_outline_knows_where_a_task_ends() -> None:
    tasks = outline(SourceText("t", short(LONG)), LineCache()).tasks
    assert [(one.span.line, one.span.end_line) for one in tasks] == [(3, 18)]
