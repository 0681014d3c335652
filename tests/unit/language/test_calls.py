"""Calls: arguments by place and by name, defaults, results, library tasks."""

from dataclasses import replace

import pytest

from ropsim.core import Span
from ropsim.flow import MessageInstruction, MotionKind, MoveInstruction
from ropsim.icr import run
from ropsim.language import TaskSignature, formatted
from ropsim.program import Assign, Call, Constant, Local, Move, Settings, Task, ValueType, Variable
from support.tasks import CELL, codes, compiled, only

HEAD = """program p
units mm, deg, s
task Pick(part: loc, clear: length = 60, n: int = 1)
  mov part above clear
endp
"""
INFEED = (0.4, 0.3, 0.1, 0.0, 1.0, 0.0, 0.0)


def arguments(call: str, head: str = HEAD) -> list[object]:
    """Return the constants that the last statement passes."""
    result = compiled(head + call)
    assert result.program is not None
    last = result.program.main[-1]
    assert isinstance(last, Call), result.diagnostics
    return [a.value for a in last.arguments if isinstance(a, Constant)]


@pytest.mark.parametrize(
    ("call", "expected"),
    [
        ("Pick infeed", [INFEED, 0.06, 1]),
        ("call Pick infeed, 5 mm", [INFEED, 0.005, 1]),
        ("Pick(infeed, 5 mm, 2)", [INFEED, 0.005, 2]),
        ("Pick(infeed, n = 4)", [INFEED, 0.06, 4]),
        ("Pick infeed, n = 4, clear = 7", [INFEED, 0.007, 4]),
        ("Pick part = infeed", [INFEED, 0.06, 1]),
        ("Pick (1, 2, 3)", [(0.001, 0.002, 0.003, 0.0, 1.0, 0.0, 0.0), 0.06, 1]),
    ],
)
def test_arguments_find_their_parameters(call: str, expected: list[object]) -> None:
    assert arguments(call) == expected


def test_a_default_takes_the_type_that_the_body_tells() -> None:
    head = "program p\nunits mm\ntask t(q: loc, d = 60)\nmov q above d\nendp\n"
    assert arguments("t infeed", head) == [INFEED, 0.06]


def test_the_result_of_a_task_goes_to_a_variable() -> None:
    text = (
        "program p\ntask h(q: loc, b: length = 1 mm) -> length\nreturn q.z + b\nendp\nx = h(infeed, b = 2 mm)"
    )
    result = compiled(text)
    assert result.ok, result.diagnostics
    assert result.program is not None
    call = result.program.main[0]
    assert isinstance(call, Call)
    assert call.result == "x"
    assert [v.type for v in result.program.main_locals] == [ValueType.REAL]


def test_library_tasks_are_called_like_those_of_the_text() -> None:
    span = Span.on_line("library", 1, 1)
    move = Move(MotionKind.PTP, Variable("at_", ValueType.POSE), Settings(), span)
    parameters = (Local("at_", ValueType.POSE), Local("d", ValueType.REAL))
    task = Task("Visit", parameters, (), None, (move,), (), span)
    environment = replace(CELL, tasks={"Visit": TaskSignature(task, {"d": "length"})})
    result = compiled("units mm\nVisit infeed, 5", environment)
    assert result.ok, result.diagnostics
    assert result.program is not None
    assert [t.name for t in result.program.tasks] == ["Visit"]
    call = result.program.main[0]
    assert isinstance(call, Call)
    assert call.arguments[1] == Constant(0.005, ValueType.REAL)
    assert codes("Visit infeed, 5 s", environment) == ["T302"]


def test_globals_are_seen_in_tasks_when_declared() -> None:
    text = "program p\nvar n: int = 2\ntask t\nn = n + 1\nendp\nt\nrepeat n\nopen\nendr"
    result = compiled(text)
    assert result.ok, result.diagnostics
    assert result.program is not None
    assert isinstance(result.program.main[0], Assign)
    assert [v.name for v in result.program.main_locals] == ["n"]
    assert result.program.tasks[0].locals == ()
    assert codes("program p\nn = 2\ntask t\nm = n + 1\nendp\nt") == ["N202"]


BOTH = """program p
task Show(n: int, same: bool = false) -> int
  print n, same
  return n
endp
n = 3
"""


@pytest.mark.parametrize(
    ("call", "expected"),
    [
        ("Show 5, n == 3", "5 true"),
        ("Show(5, n == 4)", "5 false"),
        ("Show(n = 7)", "7 false"),
        ("k = Show(n = 7)", "7 false"),
        ("k = Show(7, n == 3)", "7 true"),
        ("Show(7, (n = 3))", "7 true"),
        ("k = Show(7, (n = 3))", "7 true"),
        ("Show(7, same = (n = 3 and true))", "7 true"),
        ("k = Show(7, same = (n = 3 and true))", "7 true"),
        ("Show(7, same = n = 3 or n = 4)", "7 true"),
        ("k = Show(7, same = n = 3 or n = 4)", "7 true"),
        ("k = Show(7, same = not n < 3)", "7 true"),
        ("k = Show(n + 1, n + 1 = 4)", "4 true"),
        ("Show(7, same := true)", "7 true"),
        ("k = Show(n := 7, same := n <> 3)", "7 false"),
        ("Show n := 7, same := true", "7 true"),
    ],
)
def test_one_sign_gives_arguments_by_name_and_two_compare(call: str, expected: str) -> None:
    code = compiled(BOTH + call).icr
    assert code is not None
    assert [m.text for m in run(code).instructions if isinstance(m, MessageInstruction)] == [expected]


@pytest.mark.parametrize(
    "call", ["Show n == 3", "Show(n == 3)", "k = Show(n == 3)", "Show((n = 3))", "k = Show((n = 3))"]
)
def test_a_comparison_is_never_an_argument_by_name(call: str) -> None:
    assert codes(BOTH + call) == ["T301"]


def test_an_argument_by_name_does_not_read_a_variable_of_that_name() -> None:
    text = BOTH + "same = false\nk = Show(7, same = true or false)"
    result = compiled(text)
    assert result.icr is not None
    assert [m.text for m in run(result.icr).instructions if isinstance(m, MessageInstruction)] == ["7 true"]
    assert "nothing reads the variable `same`" in [one.message for one in result.diagnostics]


@pytest.mark.parametrize("value", ["abs(n = 3)", "min(n := 3, 4)", "max(4, n = 3)"])
def test_a_function_takes_values_without_names(value: str) -> None:
    text = "program p\nn = 3\nx = {}\nprint x, n"
    found = only(text.format(value))
    assert (found.code, found.label) == ("T303", "")
    assert found.span is not None
    assert text.format(value).splitlines()[2][found.span.column - 1] == "n"
    assert "without names" in found.message
    assert codes(text.format(value.replace("n = ", "").replace("n := ", ""))) == []


def test_a_parenthesis_that_is_no_list_of_arguments_holds_a_comparison() -> None:
    assert codes("program p\nn = 3\nm = 4\nx = (n = 3)\nif (n = 3) and (m = 4) then print x") == []


def test_a_task_of_the_text_hides_that_of_the_library() -> None:
    library = compiled("task Other\n  print 2\nendp\nOther").program
    assert library is not None
    environment = replace(CELL, tasks={one.name: TaskSignature(one) for one in library.tasks})
    result = compiled("task Other\n  print 1\nendp\nOther", environment)
    assert result.program is not None
    assert [one.name for one in result.program.tasks] == ["Other"]
    assert result.icr is not None
    said = [one.text for one in run(result.icr).instructions if isinstance(one, MessageInstruction)]
    assert said == ["1"]


VISIT = "program p\nunits mm\ntask Visit(q: loc, n: int = 1)\n  repeat n\n    lin q\n  endr\nendp\n"


@pytest.mark.parametrize(
    ("call", "lines"),
    [
        ("Visit (300, 0, 100)", 1),
        ("Visit (300, 0, 100), 2", 2),
        ("Visit((300, 0, 100))", 1),
        ("Visit((300, 0, 100), 2)", 2),
        ("Visit(n = 2, q = (300, 0, 100))", 2),
        ("call Visit (300, 0, 100; down)", 1),
    ],
)
def test_a_parenthesis_is_a_location_behind_a_blank_and_the_arguments_at_the_name(
    call: str, lines: int
) -> None:
    code = compiled(VISIT + call).icr
    assert code is not None
    assert sum(isinstance(one, MoveInstruction) for one in run(code).instructions) == lines


@pytest.mark.parametrize(
    ("call", "told", "hint"),
    [
        ("Visit(300, 0, 100)", "takes 1 to 2 arguments, found 3", "with a blank between, `Visit (…)`"),
        ("Visit(300, 2)", "there is no reference location 300", "write it as `(x, y, z)`"),
        ("Visit (infeed, 2)", "a parenthesis behind a blank is one value", "without the blank"),
        ("Visit (q = infeed)", "a parenthesis behind a blank is one value", "without the blank"),
    ],
)
def test_the_other_blank_is_told(call: str, told: str, hint: str) -> None:
    (found,) = [one for one in compiled(VISIT + call).diagnostics if one.is_error]
    assert told in found.message
    assert hint in found.hint
    if found.fix is not None:
        assert compiled(VISIT + call.replace("Visit (", found.fix.replacement)).icr is not None


BLANKS = """program p
units mm
task Visit(q: loc, n: int = 1)
  repeat n
    lin q
  endr
endp
task Pair(q: loc, n: length)
  lin q above n
endp
task Sum(a: length, b: length, c: length)
  print a + b + c
endp
task Four(q: loc, a: length, b: length, c: length = 0)
  lin q above (a + b + c)
endp
"""


@pytest.mark.parametrize(
    ("task", "arguments", "other"),
    [
        ("Visit", "(300, 0, 100)", "Visit (300, 0, 100)"),
        ("Pair", "(300, 0, 100)", ""),
        ("Pair", " (300, 0, 100)", ""),
        ("Sum", " (300, 0, 100)", "Sum(300, 0, 100)"),
        ("Sum", "(1, 2, 3, 4, 5)", ""),
        ("Four", "(a = 1, b = 2, c = 3)", ""),
    ],
)
def test_the_other_blank_is_proposed_where_the_arguments_fit_then(
    task: str, arguments: str, other: str
) -> None:
    (found,) = [one for one in compiled(f"{BLANKS}{task}{arguments}").diagnostics if one.is_error]
    assert "takes " in found.message
    assert ("the parenthesis is" in found.hint) == bool(other)
    if other:
        assert compiled(BLANKS + other).icr is not None


@pytest.mark.parametrize("names", [("a = ", "b = ", "c = "), ("", "", "c = "), ("a = ", "", "")])
def test_a_parenthesis_with_a_name_in_it_is_no_location_behind_a_blank(names: tuple[str, ...]) -> None:
    head = "program p\nunits mm\ntask Sum(a: length, b: length, c: length)\n  print a + b + c\nendp\n"
    values = ", ".join(f"{name}{number}" for number, name in enumerate(names, 1))
    (found,) = compiled(f"{head}Sum ({values})").diagnostics
    assert found.message == "a parenthesis behind a blank is one value, and this one is none"
    assert found.fix is not None
    assert found.fix.replacement == "Sum("
    code = compiled(f"{head}Sum({values})").icr
    assert code is not None
    assert [m.text for m in run(code).instructions if isinstance(m, MessageInstruction)] == ["6 mm"]


def test_a_classic_text_asks_the_first_parameter() -> None:
    classic = "task Grip(l: loc)\n  lin l\nendp\n"
    for call in ("Grip(300, 0, 100)", "Grip (300, 0, 100)", "Grip (infeed)", "Grip(infeed)"):
        assert compiled(classic + call).icr is not None, call


def test_each_call_inside_an_expression_is_told() -> None:
    text = "program p\nunits mm\ntask Top(q: loc) -> length\n  return q.z\nendp\n"
    calls = "h = Top(infeed) + 1\ng = Top(infeed) + 1\nprint h, g\nlin infeed above Top(infeed)"
    found = compiled(text + calls).diagnostics
    assert [(one.code, one.span.line) for one in found if one.span] == [("N225", 6), ("N225", 7), ("N225", 9)]


@pytest.mark.parametrize(
    ("line", "meant"),
    [("ope", "open"), ("Tpo infeed", "Top"), ("Tpo(infeed)", "Top"), ("mov part above 3", "")],
)
def test_what_is_proposed_may_stand_in_its_place(line: str, meant: str) -> None:
    text = "program p\nunits mm, deg, s\ntask Top(q: loc)\n  lin q\nendp\nTop infeed\n"
    (found,) = compiled(text + line).diagnostics
    assert (found.fix.replacement if found.fix is not None else "") == meant


TWO = (
    "program p\nunits mm, deg, s\ntask V(n: int) -> int\n  return n\nendp\n"
    "task W(n: int) -> int\n  return n\nendp\n"
)


@pytest.mark.parametrize(
    ("line", "columns"),
    [
        ("x = V(1) + W(2)", [5, 12]),
        ("print V(1), W(2), V(3)", [7, 13, 19]),
        ("lin (V(1), W(2), 3)", [6, 12]),
        ("x = max(V(1), W(2))", [9, 15]),
        ("x = V(W(1))", [7]),
        ("if V(1) > 1 then x = V(W(2))", [4, 24]),
        ("loc q = (V(1), W(2), 1)", [10, 16]),
        ("const x = V(1)", [11]),
    ],
)
def test_each_task_called_inside_an_expression_of_a_line_is_told(line: str, columns: list[int]) -> None:
    found = compiled(TWO + line).diagnostics
    assert [(one.code, one.span.column) for one in found if one.span] == [("N225", at) for at in columns]


@pytest.mark.parametrize("line", ["var x = V(1)", "var x: int = V(1)"])
def test_a_declared_variable_is_assigned_the_result_of_a_task_below(line: str) -> None:
    (found,) = compiled(f"{TWO}{line}\nprint x").diagnostics
    assert found.hint == "declare `x` without a value, and assign the result below: `x = V(…)`"
    mended = compiled(f"{TWO}{line.partition(' =')[0]}\nx = V(1)\nprint x").diagnostics
    assert not [one for one in mended if one.is_error]


RESULTS = """program p
units mm, deg, s
task Top(q: loc, clear: length = 0) -> length
  return q.z + clear
endp
task Sum(x: length, y: length, z: length) -> length
  return x + y + z
endp
task Visit(q: loc, clear: length = 0)
  lin q above clear
endp
"""


@pytest.mark.parametrize(
    ("statement", "right"),
    [
        ("Top (300, 0, 100)", True),
        ("Top ((300, 0, 100))", True),
        ("Top(300, 0, 100)", False),
        ("Top((300, 0, 100), 5)", True),
        ("Top ((300, 0, 100), 5)", False),
        ("Top (infeed)", True),
        ("Top(300, 0, 100; down)", True),
        ("Top (300, 0, 100; down)", True),
        ("Top (q = infeed)", False),
        ("Top(q = infeed)", True),
        ("Sum(300, 0, 100)", True),
        ("Sum (300, 0, 100)", False),
    ],
)
def test_a_blank_before_the_parenthesis_means_the_same_in_statements_and_assignments(
    statement: str, right: bool
) -> None:
    assigned = compiled(f"{RESULTS}h = {statement}\nprint h").diagnostics
    stated = compiled(f"{RESULTS}{statement}").diagnostics
    assert [one.code for one in assigned if one.is_error] == [] if right else ["T303"]
    assert [(one.code, one.message) for one in assigned if one.is_error] == [
        (one.code, one.message) for one in stated if one.is_error
    ]


@pytest.mark.parametrize("arguments", ["(300, 0, 200) above 20", "(infeed) above 20", "((300, 0, 200)), 5"])
def test_nothing_follows_a_list_of_arguments(arguments: str) -> None:
    (found,) = (one for one in compiled(f"{RESULTS}Visit{arguments}").diagnostics if one.is_error)
    assert found.code == "T303"
    assert found.fix is not None
    assert found.fix.replacement == "Visit ("
    assert compiled(f"{RESULTS}Visit {arguments}").ok
    assert compiled(f"{RESULTS.replace('program p', 'classic')}Visit{arguments}").ok


def test_a_list_of_a_classic_text_stays_one_in_an_assignment() -> None:
    text = "classic\nunits mm, deg, s\ntask T(q: loc, a: num, b: num) -> num\n  return a + b\nendp\n"
    twice = "task U(q: loc)\n  x = T(1, 20, 30)\n  print x\nendp\nU infeed\n"
    assert compiled(text + twice).ok
    top = "classic\nunits mm, deg, s\ntask T(q: loc) -> length\n  return q.z\nendp\n"
    assert compiled(top + "x = T(300, 0, 100)\ny = T (300, 0, 100)\nprint x, y").ok


def test_the_form_of_a_text_keeps_the_blank_before_the_arguments_of_an_assigned_call() -> None:
    text = f"{RESULTS}h = Top (300, 0, 100)\nk = Top(infeed)\nm = min(3, 4)\nprint h, k, m\n"
    assert formatted(text) == text
    assert formatted(text.replace("min(3", "min (3")) == text
