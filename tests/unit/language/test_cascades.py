"""One mistake gives one finding, however much hangs on the line that is wrong."""

import pytest

from support.tasks import codes, compiled, only

PROGRAM = """program p
units mm, deg, s
frame tab = (1,2,3)
tool cup = (0,0,1)
loc a = (1,2,3)
const c = 3 mm
signal s = input 1
signal lamp = output 2
pattern g = grid 2 x 2 from (0,0,0) step (1,0,0), (0,1,0)
task Pick(part: loc, clear: length = 60 mm)
  mov part above clear
  lin part
  close
  mov part above clear
  n = clear * 2
  print n
endp
task H(q: loc) -> length
 return q.z
endp
with tool cup
  Pick a
  Pick infeed in tab, clear = c
endwith
for each b in g
  lin b in tab
  Pick b
endf
x = H(a)
y = x + c
print y
set lamp on
wait until s
if s then set lamp off
repeat 3
  Pick a, x
endr
for i = 1 to 3
  lin a above i
endf
mov home
"""
MISTAKES = [
    ("program p", "progam p"),
    ("units mm, deg, s", "unit mm, deg, s"),
    ("units mm", "units mmm"),
    ("frame tab", "fram tab"),
    ("frame tab = (1,2,3)", "frame tab = (1,2,3"),
    ("frame tab = (1,2,3)", "frame tab = (1 s,2,3)"),
    ("frame tab =", "frame tabb ="),
    ("tool cup = (0,0,1)", "tool cup = (0,0,1 s)"),
    ("tool cup", "tol cup"),
    ("tool cup =", "tool cupp ="),
    ("loc a =", "lock a ="),
    ("loc a = (1,2,3)", "loc a = (1,2"),
    ("loc a = (1,2,3)", "loc a = (1,2)"),
    ("loc a =", "loc aa ="),
    ("const c", "cnst c"),
    ("const c = 3 mm", "const c = 3 mmm"),
    ("const c =", "const cc ="),
    ("signal s = input 1", "signal s = inptu 1"),
    ("signal s", "singal s"),
    ("signal lamp", "singal lamp"),
    ("signal lamp =", "signal lmap ="),
    ("pattern g", "patern g"),
    ("pattern g = grid", "pattern g = gird"),
    ("task Pick(", "taks Pick("),
    ("task Pick(", "task Pcik("),
    ("part: loc", "part loc"),
    ("part: loc", "part: lok"),
    ("task H(", "taks H("),
    ("task Pick(part: loc, clear: length = 60 mm)", "task Pick(part: loc, clear: length = 60 mm"),
    ("-> length", "-> lenght"),
    ("-> length", ""),
    ("endp\ntask H", "task H"),
    ("endp\nwith", "with"),
    ("endp\nwith", "edp\nwith"),
    ("endp\ntask H", "edp\ntask H"),
    ("with tool cup\n", "wiht tool cup\n"),
    ("with tool cup\n", "with tol cup\n"),
    ("endwith", "endwit"),
    ("endwith\n", ""),
    ("for each b in g", "for each b in gg"),
    ("for each b in g", "for ech b in g"),
    ("for each b in g", "fro each b in g"),
    ("endf\nx", "x"),
    ("x = H(a)", "x = HH(a)"),
    ("x = H(a)", "x = H(aa)"),
    ("x = H(a)", "xx = H(a)"),
    ("repeat 3\n", "repaet 3\n"),
    ("endr\n", ""),
    ("endr", "enr"),
    ("for i = 1 to 3", "for i = 1 too 3"),
    ("for i = 1 to 3", "for i := 1"),
    ("for i = 1", "fr i = 1"),
    ("if s then", "if s then then"),
    (" return q.z", " retrun q.z"),
    (" n = clear * 2", " n = claer * 2"),
    ("endf\nmov home\n", "mov home\n"),
    ("if s then set lamp off", "if s then"),
    ("part: loc", "prt: loc"),
]


def test_the_program_is_right() -> None:
    assert codes(PROGRAM) == []


@pytest.mark.parametrize(("right", "wrong"), MISTAKES)
def test_one_mistake_gives_one_finding(right: str, wrong: str) -> None:
    assert right in PROGRAM
    assert len(codes(PROGRAM.replace(right, wrong, 1))) == 1


@pytest.mark.parametrize(
    ("line", "meant"),
    [
        ("taks T(q: loc)\n lin q\nendp\nT infeed", "task"),
        ("repaet 3\n open\nendr", "repeat"),
        ("fro each b in s\n lin b\nendf", "for"),
        ("whiel part_ok\n open\nendw", "while"),
        ("repeat 3\n open\nenr", "endr"),
        ("loca bin = (1, 2, 3)\nmov bin\nlin bin", "loc"),
        ("singal go = output 1\nset go on", "signal"),
    ],
)
def test_a_misspelt_first_word_keeps_its_part_in_the_text(line: str, meant: str) -> None:
    found = only(f"program p\nmov home\n{line}")
    assert (found.code, found.hint) == ("N201", f"did you mean `{meant}`?")
    assert found.fix is not None
    assert found.fix.replacement == meant


@pytest.mark.parametrize(
    ("line", "meant"),
    [("sped 500 mm/s", "set speed"), ("blned 10 mm", "set blend"), ("acc2 2 m/s2", "set acc")],
)
def test_a_misspelt_setting_is_named_with_the_word_before_it(line: str, meant: str) -> None:
    text = f"program p\nmov home\n{line}\n"
    found = only(text)
    assert (found.code, found.hint) == ("N201", f"did you mean `{meant}`?")
    assert found.fix is not None
    assert compiled(text.replace(line.split(maxsplit=1)[0], found.fix.replacement)).ok


@pytest.mark.parametrize(
    ("line", "meant"),
    [
        ("cirx via (500, 50, 400) to (500, 100, 400)", "circ"),
        ("splin via (500, 50, 400), (500, 80, 400) to (500, 100, 400)", "spline"),
        ("wiat until part_ok", "wait"),
    ],
)
def test_a_misspelt_verb_is_named_where_the_rest_of_the_line_fits_it_alone(line: str, meant: str) -> None:
    found = only(f"program p\nmov home\n{line}\n")
    written = line.split(maxsplit=1)[0]
    assert found.code == "L101"
    assert found.hint == f"with `{meant}` instead of `{written}` the line is a statement"


@pytest.mark.parametrize("text", ["mask 3", "tasks infeed", "lock infeed", "withe tool jaws\nopen"])
def test_a_word_near_to_an_opener_is_a_call_where_no_end_is_left_over(text: str) -> None:
    assert codes(f"program p\n{text}\nmov nowhere")[-1] == "N202"


def test_an_unknown_name_is_told_once_with_its_other_places() -> None:
    found = only("mov infeed\n" + "mov nowhere\n" * 3)
    assert found.span is not None
    assert (found.span.line, [one.span.line for one in found.secondary]) == (2, [3, 4])
    many = only("mov nowhere\n" * 500)
    assert (len(many.secondary), many.notes) == (200, ("It stands in more places.",))


def test_an_unknown_name_that_is_mended_in_two_ways_is_told_twice() -> None:
    head = "program p\nunits mm\n"
    task = "task T(n: length)\n {0} = n\n m = infed\n m = {0}\n m = m + infed\nendp\n"
    found = compiled(f"{head}{task.format('infedd')}T 3\nmov infed\nmov infed").diagnostics
    unknown = [one for one in found if one.code == "N202"]
    fixes = [(one.fix.replacement if one.fix else "", len(one.secondary)) for one in unknown]
    assert fixes == [("infedd", 1), ("infeed", 1)]


def test_two_unknown_names_are_two_mistakes() -> None:
    assert codes("mov nowhere\nmov anywhere\nmov nowhere") == ["N202", "N202"]


def test_names_that_a_pattern_makes_for_itself_are_not_suggested() -> None:
    text = "pattern s = grid 2 x 2 from (0, 0, 0) step (1, 0, 0), (0, 1, 0)\nfor each b in s\n lin b\nendf\n"
    assert "__" not in only(text + "mov nowhere").hint


def test_a_task_without_end_has_no_other_findings() -> None:
    assert [one.code for one in compiled("task T() -> length\n return 3 mm\nmov home").diagnostics] == [
        "L106"
    ]
