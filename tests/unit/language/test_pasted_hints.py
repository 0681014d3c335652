"""What a hint proposes compiles when it is pasted, and means what was meant."""

import re
from dataclasses import replace

import pytest

from ropsim import icr
from ropsim.core import Diagnostic
from ropsim.program import SignalUse, ValueType
from support.tasks import CELL, compiled, only

GLUED = replace(
    CELL, signals={**CELL.signals, "glue": SignalUse("glue", is_input=False, type=ValueType.BOOL)}
)
HEAD = (
    "program p\nunits mm, deg, s\nloc p = (300, 0, 100)\nloc a = (300, 100, 100)\nloc b = (300, 200, 100)\n"
    "loc c = (350, 200, 100)\ntask Foo(q: loc, n: int = 1)\n  lin q\n  print n\nendp\nFoo p\n"
)
MEANT = [
    ("lin p speed 150 mm/s zone 10", "lin p speed 150 mm/s blend 10"),
    ("lin p zone 10", "lin p blend 10"),
    ("lin p zone z10", "lin p blend 10 mm"),
    ("lin p zone fine", "lin p fine"),
    ("lin p CNT0", "lin p fine"),
    ("lin p z10", "lin p blend 10 mm"),
    ("lin p, v100", "lin p speed 100 mm/s"),
    ("lin p vel 100", "lin p speed 100"),
    ("lin p accel 100", "lin p acc 100"),
    ("lin p r=0.01", "lin p blend 0.01 m"),
    ("lin p, r=10 mm", "lin p blend 10 mm"),
    ("lin p, a=1.2", "lin p acc 1.2 m/s2"),
    ("lin p, v=0.25", "lin p speed 0.25 m/s"),
    ("lin p, speed 100", "lin p speed 100"),
    ("lin p speeed 100", "lin p speed 100"),
    ("lin p tool jaws in pallet", "lin p in pallet tool jaws"),
    ("lin p fine above 20", "lin p above 20 fine"),
    ("spline a to b to c", "spline via a, b to c"),
    ("lin a above 20 to b to c", "lin via a above 20, b to c"),
    ("mov via a to b to (300, 0, 50)", "mov via a, b to (300, 0, 50)"),
    ("set speed 100 mm/s blend 10", "set speed 100 mm/s\nset blend 10"),
    ("set speed 100 mm/s, blend 10", "set speed 100 mm/s\nset blend 10"),
    ("set speeed 30 %", "set speed 30 %"),
    ("open print 1", "open\nprint 1"),
    ("print 1 lin p", "print 1\nlin p"),
    ("wait 3 sec", "wait 3 s"),
    ("WAIT SEC 0.5", "wait 0.5 s"),
    ("wait for 0.5", "wait 0.5 s"),
    ("wait for 500 ms", "wait 500 ms"),
    ("set glue high", "set glue on"),
    ("set glue LOW", "set glue off"),
    ("lin p blend z10", "lin p blend 10 mm"),
    ("lin p speed v500", "lin p speed 500 mm/s"),
    ("lin p with speed 100", "lin p speed 100"),
    ("lin p until part_ok = 1", "lin p until part_ok = on"),
    ("set zone 10", "set blend 10"),
    ("set vel 100", "set speed 100"),
    ("set z10", "set blend 10 mm"),
    ("set speed = 100", "set speed 100"),
    ("with vel 100\n  lin p\nendwith", "with speed 100\n  lin p\nendwith"),
    ("with speed 100 mm/s blend 10\n  lin p\nendwith", "with speed 100 mm/s, blend 10\n  lin p\nendwith"),
    ("if part_ok = 1 then open", "if part_ok = on then open"),
    ("wait until part_ok == 0", "wait until part_ok == off"),
    ("if part_ok == high then open", "if part_ok == on then open"),
    ("task G(loc r)\n  lin r\nendp\nG p", "task G(r: loc)\n  lin r\nendp\nG p"),
    ("task G(r loc)\n  lin r\nendp\nG p", "task G(r: loc)\n  lin r\nendp\nG p"),
    ("var int x = 3\nprint x", "var x: int = 3\nprint x"),
    ("const num x = 3\nprint x", "const x: num = 3\nprint x"),
    ("loc r (1, 2, 3)\nlin r", "loc r = (1, 2, 3)\nlin r"),
    ("for i = 1 to 3 by 1\n  print i\nendf", "for i = 1 to 3 step 1\n  print i\nendf"),
    ("for i = 3 downto 1\n  print i\nendf", "for i = 3 to 1 step -1\n  print i\nendf"),
    ("set glue to off", "set glue off"),
    ("lin base", "lin (0, 0, 0) in base"),
    ("k = 3 print k", "k = 3\nprint k"),
    ("print 1 k = 3", "print 1\nk = 3"),
    ("for i in 1 to 3\n  print i\nendf", "for i = 1 to 3\n  print i\nendf"),
    (
        "pattern g = grid 2 x 2 from p step (1, 0, 0), (0, 1, 0)\nfor s in g\n  lin s\nendf",
        "pattern g = grid 2 x 2 from p step (1, 0, 0), (0, 1, 0)\nfor each s in g\n  lin s\nendf",
    ),
    ("set glue = 1", "set glue on"),
    ("set glue = 0", "set glue off"),
    ("glue = on", "set glue on"),
    ("glue = false", "set glue off"),
    ("glue = part_ok", "set glue = part_ok"),
    ("if part_ok then glue = on", "if part_ok then set glue on"),
    ("lin Offs(p, 0, 0, 60)", "lin p offset (0, 0, 60)"),
    ("lin RelTool(p, 0, 0, 60)", "lin p rel (0, 0, 60)"),
    ("lin pose_trans(p, a)", "lin p rel a"),
    ("lin CRobT() above 20", "lin here above 20"),
    ("lin pallet above 20", "lin (0, 0, 0) in pallet above 20"),
    ("mov hom", "mov home"),
    ("lin p speed 100 mm / s", "lin p speed 100 mm/s"),
    ("lin p speed 100 mm/sec", "lin p speed 100 mm/s"),
    ("Foo n=3, (1,2,3)", "Foo (1,2,3), n=3"),
    ("Foo(n = 3, p)", "Foo p, n = 3"),
    ("joint p", "mov p"),
    ("linear p", "lin p"),
]
SAID = [
    ("lin p C_DIS", "`blend 10 mm`"),
    ("mov p C_PTP", "`blend 10 mm`"),
    ("lin p A_DIS", "`blend 10 mm`"),
    ("lin p CNT50", "`blend 10 mm`"),
    ("mov p v=1.05", "`speed 50 %`"),
    ("lin p vel", "`speed 500 mm/s`"),
    ("set glue on, 0.5", "`wait 0.5 s`"),
    ("set glue 1", "`on` or `off`"),
    ("lin p speed 5 m/min", "`0.0833333 m/s`"),
    ("lin jaws", "stands behind `tool`"),
    ("lin Offs(p, 60)", "`p offset (0, 0, 60)`"),
    ("circ via a to b to c", "`spline`"),
    ("if part_ok then open else close", "an `else` stands on a line of its own"),
    ("Bar 3", "define it with `task`"),
    ("call Bar(p)", "define it with `task`"),
    ("home", "`mov home`"),
    ("mov a, b, c", "`lin via a, b to c speed 100 mm/s`"),
    ("lin from a to b", ""),
    ("p.x = 3", "copy it first: `q = p`"),
    ("p.z += 10", "`p.z = p.z + 1`"),
    ('print "a" + 3', "behind commas"),
    ("repeat until part_ok\nendr", "stands below its lines"),
    ("set glue", "`set NAME on`"),
    ("set glue on for 0.5 s", "`wait 0.5 s`"),
    ("set glue on 0.5", "`wait 0.5 s`"),
    ("lin pallet.p", "`(0, 0, 0) in pallet`"),
    ("end program", "a program ends with its last line"),
    ("lin {X 300, Y 0, Z 100}", "`(x, y, z)`"),
]


def applied(text: str, found: Diagnostic) -> str:
    fix = found.fix
    assert fix is not None, found.hint
    lines = text.splitlines()
    line = lines[fix.span.line - 1]
    lines[fix.span.line - 1] = line[: fix.span.column - 1] + fix.replacement + line[fix.span.end_column - 1 :]
    return "\n".join(lines)


def code_of(text: str) -> list[str]:
    result = compiled(text, GLUED)
    assert result.icr is not None, [str(one) for one in result.diagnostics]
    return [re.sub(r"@\d+(:\d+)?", "", line) for line in icr.disassemble(result.icr).splitlines()]


@pytest.mark.parametrize(("line", "meant"), MEANT)
def test_a_line_with_its_fix_is_the_line_that_was_meant(line: str, meant: str) -> None:
    text = f"{HEAD}{line}"
    found = only(text, GLUED)
    assert code_of(applied(text, found)) == code_of(f"{HEAD}{meant}")


@pytest.mark.parametrize(("line", "said"), SAID)
def test_a_line_that_nobody_can_complete_says_what_to_write(line: str, said: str) -> None:
    found = only(f"{HEAD}k = 1\nprint k\n{line}", GLUED)
    assert said in found.hint
    assert "did you mean" not in found.hint


@pytest.mark.parametrize("line", ["lin p fine blend 10", "lin p blend 10 fine"])
def test_fine_and_blend_exclude_each_other(line: str) -> None:
    assert only(HEAD + line, GLUED).message == "`fine` and `blend` exclude each other"
    assert only(f"{HEAD}lin p fine fine", GLUED).message == "`fine` is given twice"


@pytest.mark.parametrize(
    ("block", "end", "meant"),
    [
        ("if part_ok then", "endswitch", "endif"),
        ("while part_ok", "EndWhile", "endw"),
        ("for i = 1 to 3", "endfor", "endf"),
        ("repeat 3", "endloop", "end"),
        ("task G()", "endproc", "endp"),
    ],
)
def test_an_end_of_another_language_ends_the_block(block: str, end: str, meant: str) -> None:
    behind = "G\n" if meant == "endp" else ""
    text = f"{HEAD}{block}\n  open\n{end}\n{behind}loc late = (300, 0, 50)\nlin late\n"
    found = only(text, GLUED)
    assert (found.code, found.hint) == ("N201", f"did you mean `{meant}`?")
    assert compiled(applied(text, found), GLUED).ok


def test_an_end_of_another_language_that_closes_nothing_is_one_finding() -> None:
    assert only(f"{HEAD}wend", GLUED).code == "N201"


@pytest.mark.parametrize("line", ["lin p tooll", "repeat 3 3", "set glue tru", "lin p abc", "then p"])
def test_no_near_word_is_proposed_that_fails_at_the_same_place(line: str) -> None:
    for found in compiled(HEAD + line, GLUED).diagnostics:
        if found.hint.startswith("did you mean"):
            again = compiled(applied(HEAD + line, found), GLUED).diagnostics
            assert (found.code, found.span) not in [(one.code, one.span) for one in again]
