"""The form of task texts: how lines are written, and what is left as it is."""

import pytest

from ropsim.language import formatted
from ropsim.language.testing import chunks

WRITTEN = """PROGRAM  Foo
UNITS  mm,deg , mm / s
// top



Task Pick ( q:loc,clear :length=60mm )->length
  Needs   gripper Open
if q.x>=3 Then
   # inside
mov q ABOVE -3 speed 30%# hello
   else
lin (300,20,   # goes on
 100;rx 90 deg , RPY 0 -90 0)
LIN q \\
  speed 150 mm/s   // fast
x:=- 3*( a-b )/sin( 3 )
end
return  q . x.
END
Pick infeed,  n=2
y=Pick (infeed, 3)
Pick (1,2,3)
print "a  b",x<>-3
spline via a,
b to (
c
) fine

"""
FORM = """program Foo
units mm, deg, mm/s
// top

task Pick(q: loc, clear: length = 60mm) -> length
  Needs   gripper Open
  if q.x >= 3 then
    # inside
    mov q above -3 speed 30%  # hello
  else
    lin (300, 20,  # goes on
         100; rx 90 deg, rpy 0 -90 0)
    lin q \\
      speed 150 mm/s  // fast
    x := -3 * (a - b) / sin(3)
  end
  return q.x.
end
Pick infeed, n = 2
y = Pick (infeed, 3)
Pick (1, 2, 3)
print "a  b", x <> -3
spline via a,
b to (
c
) fine
"""


def test_a_text_is_written_in_its_form() -> None:
    assert formatted(WRITTEN) == FORM


@pytest.mark.parametrize(
    ("written", "form"),
    [
        ("x=a-1", "x = a - 1"),
        ("x=-1", "x = -1"),
        ("x = a --1", "x = a - -1"),
        ("x=(a)-1", "x = (a) - 1"),
        ("x=not(-a<b)", "x = not (-a < b)"),
        ("lin q offset(0,0,-1)", "lin q offset (0, 0, -1)"),
        ("lin (1,2,3;rpy 10 -20 30)", "lin (1, 2, 3; rpy 10 -20 30)"),
        ("lin (1,2,3;rz a-20)", "lin (1,2,3;rz a-20)"),  # it cannot be read
        ("q . z=q.z+1", "q.z = q.z + 1"),
        ("mov joints (1,2)", "mov joints(1, 2)"),
        ("mov (1,2,3;config(Left,UP),turns (0 ,-1))", "mov (1, 2, 3; config(Left, UP), turns (0, -1))"),
        ("for i=9 to 1 step -2\nEndf", "for i = 9 to 1 step -2\nendf"),
        ("lin a at 3 mm Before END do set glue ON", "lin a at 3 mm before end do set glue on"),
        ("lin (1,2,3;euler ZYX 1 2 3)", "lin (1, 2, 3; euler ZYX 1 2 3)"),
        ("var  n:int=3", "var n: int = 3"),
        ("Call  Pick(a)", "call Pick(a)"),
        ("Pick", "Pick"),
        ("wait   500ms .", "wait 500ms."),
        ("wait 5  s", "wait 5  s"),
        ("grip  (3 , ", "grip  (3 , "),
        ("# note \\  ", "# note \\ "),
        ("mov a # note \\  ", "mov a  # note \\ "),
    ],
)
def test_a_line_is_written_in_its_form(written: str, form: str) -> None:
    assert formatted(f"{written}\n") == f"{form}\n"
    assert formatted(f"{form}\n") == f"{form}\n"


def test_comments_behind_statements_keep_their_column() -> None:
    text = "x=1       # one\ny = 22    # two\nlong_name = 333 # three\n"
    assert formatted(text) == "x = 1     # one\ny = 22    # two\nlong_name = 333  # three\n"


def test_blocks_are_seen_behind_lines_that_are_wrong() -> None:
    text = "while x ??\nmov a\nif b then\nlin (((\nend\nendw\nmov c\n"
    assert formatted(text) == "while x ??\n  mov a\n  if b then\nlin (((\n  end\nendw\nmov c\n"


def test_prose_keeps_its_words() -> None:
    text = 'task "T"\n  needs a  thing ,and\nMOVE it  With care(no end).\nMOV l\nendp\n'
    assert (
        formatted(text) == 'task "T"\n  needs a  thing ,and\n  MOVE it  With care(no end).\n  mov l\nendp\n'
    )


@pytest.mark.parametrize("text", ["", "\ufeff", "\n\n", "  \n\t\n"])
def test_nothing_is_made_of_nothing(text: str) -> None:
    assert formatted(text).strip("\ufeff") == ""


def test_line_ends_and_a_byte_order_mark_are_kept() -> None:
    assert formatted("\ufeffmov  a\r\n\r\n\r\nmov  b") == "\ufeffmov a\r\n\r\nmov b\r\n"


ROWS = [line for k in range(100) for line in (f"LIN  (1,{k}, 3)", f"x{k}=3+{k}")]


@pytest.mark.parametrize("opened", ["Repeat  3", "if  x1 > 2 then", "ENDR", "else"])
@pytest.mark.parametrize("indent", ["", "   "])
def test_lines_around_a_block_that_has_no_end_or_no_beginning_stay_as_they_are(
    opened: str, indent: str
) -> None:
    inside = [f"{indent}mov   a", "", "", f"{indent}MOV b"]
    text = "\n".join(("program  p", *ROWS, opened, *inside, *ROWS, "")).splitlines()
    form = formatted("\n".join(text)).splitlines()
    assert form[0] == "program p"
    start = form.index(opened)
    assert form[start : start + 5] == [opened, *inside]
    assert len(form) == len(text)
    as_written = sum(one == other for one, other in zip(form, text, strict=True))
    assert 5 <= as_written < 100  # of 405 lines: the piece of the block and no more


def test_a_task_whose_block_has_no_end_stays_as_it_is_and_others_do_not() -> None:
    wrong = "task A()\n repeat  3\n  MOV a\nendp\n"
    assert formatted(f"{wrong}\ntask B( )\nMOV  b\nendp\n") == f"{wrong}\ntask B()\n  mov b\nendp\n"
    assert formatted(wrong.rstrip("\n")) == wrong.rstrip("\n")


def test_a_text_and_its_form_are_cut_at_the_same_lines() -> None:
    text = "\n".join(ROWS).splitlines()
    form = formatted("\n".join(text)).splitlines()
    assert form != text
    sizes = [len(one.lines) for one in chunks(text)]
    assert [len(one.lines) for one in chunks(form)] == sizes
    assert len(sizes) > 1
