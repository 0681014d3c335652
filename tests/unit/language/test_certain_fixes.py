"""A fix is what was meant for certain; where that is not known, the hint stands without one."""

import re
from dataclasses import replace

import pytest

from ropsim import icr
from ropsim.core import Diagnostic
from ropsim.program import SignalUse, ValueType
from support.tasks import CELL, compiled

CELL_OF_TWO = replace(
    CELL,
    signals={
        **CELL.signals,
        "glue": SignalUse("glue", is_input=False, type=ValueType.BOOL),
        "pump": SignalUse("pump", is_input=False, type=ValueType.REAL),
    },
)
"""With the digital output `glue` and the analog one `pump`."""
HEAD = (
    "program p\nunits mm, deg, s\nframe table = (500, 0, 0)\nloc p = (300, 0, 100)\nloc a = (300, 100, 100)\n"
    "task Foo(q: loc, n: int = 1) -> int\n  lin q\n  return n\nendp\nm = Foo(p)\nprint m\n"
)
MEANT = [
    ("lin pose_trans(table, p)", "lin p in table"),
    ("mov pose_trans(base, p above 20) above 20", "mov p above 20 in base above 20"),
    ("lin pose_trans(p, (0, 0, 20))", "lin p rel (0, 0, 20)"),
    ("lin pose_trans(p, a above 20)", "lin p rel (a above 20)"),
    ("lin pose_trans(p, pose_trans(table, a))", "lin p rel (a in table)"),
    ("lin pose_trans(table, pose_trans(p, a))", "lin p rel a in table"),
    ("movej(pose_trans(table, p))", "mov p in table"),
    ("repeat 3\n  if m > 3 then EXIT\nendr", "repeat 3\n  if m > 3 then break\nendr"),
    ("exit", "stop"),
    ("if m > 3 then lin p end", "if m > 3 then lin p"),
    ("movel(p, a=1.2, v=0.15)", "lin p acc 1.2 m/s2 speed 0.15 m/s"),
    ("movep(p, a=1.2, v=0.15, r=0.01)", "lin p acc 1.2 m/s2 speed 0.15 m/s blend 0.01 m"),
    ("movej(p, r=0.01)", "mov p blend 0.01 m"),
    ("movel(p)", "lin p"),
    ("movel((300, 0, 100))", "lin (300, 0, 100)"),
]
SEMICOLONS = [
    ("lin p;", "lin p"),
    ("lin p; # near", "lin p"),
    ("MoveL p, v500, z10;", "lin p speed 500 mm/s blend 10 mm"),
    ("SetDO glue, 1;", "set glue on"),
    ("WaitTime 0.5;", "wait 0.5 s"),
    ("lin p; open", "lin p\nopen"),
    ("lin p; k = Foo(p); print k;", "lin p\nk = Foo(p)\nprint k"),
    ("repeat 3;\n  open;\nendr;", "repeat 3\n  open\nendr"),
    ("lin p v500;", "lin p speed 500 mm/s"),
]
WORDS = [
    ("if m > 3 then lin p end if", "if m > 3 then lin p"),
    ("if m > 3 then lin p endif", "if m > 3 then lin p"),
    ("if m > 3 lin p endif", "if m > 3 then lin p"),
    ("for i = 10 downto 1 step 2\n  print i\nendf", "for i = 10 to 1 step -2\n  print i\nendf"),
    ("for i = 10 downto 1 by -2\n  print i\nendf", "for i = 10 to 1 step -2\n  print i\nendf"),
    ("if m greater than 3 then lin p", "if m > 3 then lin p"),
    ("if m less than or equal to 3 then lin p", "if m <= 3 then lin p"),
    ("if m equal to 3 then lin p", "if m = 3 then lin p"),
    ("while m > 3 lin p endw", "while m > 3\n  lin p\nendw"),
    ("repeat 3 lin p endr", "repeat 3\n  lin p\nendr"),
    ("repeat 3 lin p end repeat", "repeat 3\n  lin p\nendr"),
    ("repeat 3\n  repeat 2 lin p end\nendr", "repeat 3\n  repeat 2\n    lin p\n  end\nendr"),
]
OUTPUTS = [
    ("set glue high", "set glue on"),
    ("set glue FALSE", "set glue off"),
    ("glue = 1", "set glue on"),
    ("glue = high", "set glue on"),
    ("high = m < 3\nglue = high", "high = m < 3\nset glue = high"),
    ("pump = 2", "set pump = 2"),
    ("if m > 3 then glue = off", "if m > 3 then set glue off"),
    ("lin p at 3 mm after start do set glue high", "lin p at 3 mm after start do set glue on"),
]
TYPES = [
    ("var real k = 0.5\nprint k", "var k = 0.5\nprint k"),
    ("const float k = 0.5\nprint k", "const k = 0.5\nprint k"),
    ('var string k = "a"\nprint k', 'var k: str = "a"\nprint k'),
    ("task F(float x)\n  lin p above x\nendp\nF(3)", "task F(x)\n  lin p above x\nendp\nF(3)"),
    ('task F(string x)\n  print x\nendp\nF("a")', 'task F(x: str)\n  print x\nendp\nF("a")'),
    *(
        (
            f"task F(r: loc){given} length\n  lin r\n  return 3 mm\nendp\nk = F(p)\nprint k",
            "task F(r: loc) -> length\n  lin r\n  return 3 mm\nendp\nk = F(p)\nprint k",
        )
        for given in (" return", " returns", ":")
    ),
    ("k = Fooo(p, 30)\nprint k", "k = Foo(p, 30)\nprint k"),
    ("k = 1\nif m > 3 then k = Fooo(p)\nprint k", "k = 1\nif m > 3 then k = Foo(p)\nprint k"),
    ("k = sqr(4)\nprint k", "k = sqrt(4)\nprint k"),
]
BLOCKS = [
    ("if m > 3 lin p\n lin a\nendif", "if m > 3 then\n lin p\n lin a\nendif"),
    ("if m > 3 lin p\nlin a\nendif", "if m > 3 then\n lin p\n lin a\nendif"),
    ("if m > 3 lin p\nend", "if m > 3 then\n lin p\nend"),
    ("if m > 3 lin p\nelse\n lin a\nendif", "if m > 3 then\n lin p\nelse\n lin a\nendif"),
    ("if m > 3 lin p\nelseif m > 2\n lin a\nend", "if m > 3 then\n lin p\nelseif m > 2\n lin a\nend"),
    ("repeat 3\n if m > 3 lin p\nend", "repeat 3\n if m > 3 then lin p\nend"),
    ("repeat 3\nif m > 3 lin p\nendr", "repeat 3\nif m > 3 then lin p\nendr"),
    (
        "repeat 3\n if m > 3 lin p\n repeat 2\n  lin a\n end\n end\nend",
        "repeat 3\n if m > 3 then\n lin p\n repeat 2\n  lin a\n end\n end\nend",
    ),
    ("if m > 3 lin p\nlin a", "if m > 3 then lin p\nlin a"),
]
UNCERTAIN = [
    ("print Fooo(p)", "there are `abs`"),
    ("pump = on", "`set pump = 1`"),
    ("pump = high", "`set pump = 1`"),
    ("pump = 2 V", "`set pump = 1`"),
    ("set pump high", "`set pump = 1`"),
    ("set pump true", "`set pump = 1`"),
    ("set pump on", "`set pump = 1`"),
    ("glue = 2", "`set glue on`"),
    ("for i = 10 downto 1 step m\n  print i\nendf", "`to 1 step -2`"),
    ("if m > 3 then lin p end while", "leave it out"),
    ("if m > 3 then lin p; open", "line of its own"),
    ("if m > 3 then lin p open", ""),
    ("lin (300, 0, 100); rz 30", "without `;`"),
    ("if m > 3 then\nif m > 4 lin p\nendif", "then `endif`"),
    ("if m > 3 lin p\n  lin a", "then `endif`"),
    ("if m > 3 then if m > 4 lin p\n  lin a\nendif", "then `endif`"),
    ("lin pose_trans(p, table)", "`p rel (0, 0, 60)`"),
    ("task G()\n  exit\nendp\nG()", "out of a loop `break`"),
    ("jump p", "`mov p above 60`"),
    ("move p", "a straight line is `lin p`"),
    ("movej(p, a=1.4, v=1.05)", "`mov p speed 50 % blend 10 mm`"),
    ("movel(p, t=3)", "`lin p speed 500 mm/s blend 10 mm`"),
    ("movel(p, 1.2, 0.15)", "`lin p speed 500 mm/s blend 10 mm`"),
    ("movel(p, v=250)", "`lin p speed 500 mm/s blend 10 mm`"),
    ("mov p v500", "`speed 50 %`"),
    ("mov p speed v500", "`speed 50 %`"),
    ("if m > 3 then mov p speed v500", "`speed 50 %`"),
    ("mov p vel v500", "`speed 50 %`"),
    ("lin p v=250", "`speed 500 mm/s`"),
    ("lin p r=10", "`blend 10 mm`"),
]


def first(text: str) -> Diagnostic:
    return compiled(text, CELL_OF_TWO).diagnostics[0]


def applied(text: str, found: Diagnostic) -> str:
    fix = found.fix
    assert fix is not None, found
    lines = text.split("\n")
    line = lines[fix.span.line - 1]
    lines[fix.span.line - 1] = line[: fix.span.column - 1] + fix.replacement + line[fix.span.end_column - 1 :]
    return "\n".join(lines)


def mended(text: str) -> str:
    """Return a text with all fixes of its errors, one after the other."""
    for _ in range(9):
        errors = [one for one in compiled(text, CELL_OF_TWO).diagnostics if one.is_error]
        if not errors:
            return text
        text = applied(text, errors[0])
    raise AssertionError(text)


def code_of(text: str) -> list[str]:
    result = compiled(text, CELL_OF_TWO)
    assert result.icr is not None, [str(one) for one in result.diagnostics]
    return [re.sub(r"@\d+(:\d+)?", "", line) for line in icr.disassemble(result.icr).splitlines()]


@pytest.mark.parametrize(("line", "meant"), MEANT + SEMICOLONS + WORDS + OUTPUTS + TYPES + BLOCKS)
def test_what_is_mended_fix_by_fix_is_what_was_meant(line: str, meant: str) -> None:
    assert code_of(mended(HEAD + line)) == code_of(HEAD + meant)


@pytest.mark.parametrize(("line", "said"), UNCERTAIN)
def test_what_is_not_certain_has_no_fix(line: str, said: str) -> None:
    found = first(HEAD + line)
    assert found.fix is None
    assert said in found.hint


def test_an_end_behind_the_last_statement_of_a_block_stands_below_it() -> None:
    found = compiled(f"{HEAD}repeat 3\n  lin p endr", CELL_OF_TWO).diagnostics[-1]
    assert (found.hint, found.fix and found.fix.replacement) == (
        "the end of a block stands on a line of its own",
        "\n  endr",
    )


def test_a_semicolon_at_the_end_is_told_beside_what_else_is_wrong() -> None:
    found = compiled(f"{HEAD}MoveL p, v500, z10;", CELL_OF_TWO).diagnostics
    assert [one.code for one in found] == ["N201", "L101"]
    assert all(one.fix is not None for one in found)


def test_both_ends_of_a_condition_without_then_in_another_one_are_right() -> None:
    text = f"{HEAD}if m > 3 then\n  if m > 4 lin p\n  lin a\n  endif\nendif"
    assert [one.code for one in compiled(text, CELL_OF_TWO).diagnostics] == ["L101"]
    assert code_of(mended(text)) == code_of(text.replace("4 lin p", "4 then\n  lin p"))
