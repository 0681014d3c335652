"""Types of parameters: from the header or from their use in the task; in modern texts never from callers."""

import pytest

from ropsim import language
from support.tasks import codes, compiled, only

HEAD = "program p\nunits mm, deg\n"


def form(text: str) -> str:
    """Return how task `T` is called."""
    return str(compiled(HEAD + text).tasks["T"])


@pytest.mark.parametrize(
    ("body", "type_"),
    [
        ("repeat n\n    open\n  endr", "int"),
        ("mov infeed above n", "length [mm]"),
        ("mov n", "loc"),
        ("if n > 3.5 then open", "num"),
        ("if n > 3 then open", "int"),
        ("wait n", "time"),
    ],
)
def test_the_use_in_the_task_tells(body: str, type_: str) -> None:
    assert form(f"task T(n)\n  {body}\nendp\nmov home\n").startswith(f"T(n: {type_}")


@pytest.mark.parametrize("argument", ["3", "3 mm", "infeed", "2.5"])
def test_what_callers_pass_tells_nothing(argument: str) -> None:
    text = f"task T(n)\n  repeat n\n    open\n  endr\nendp\nT {argument}\n"
    assert form(text) == "T(n: int)"


def test_what_nothing_tells_is_one_error_at_the_header_with_a_fix() -> None:
    found = only(HEAD + "task T(n)\n  print n\nendp\nT 3 mm\nT 2\n")
    assert found.code == "T339"
    assert found.span is not None
    assert (found.span.line, found.span.column, found.span.end_column) == (3, 8, 9)
    assert found.fix is not None
    assert found.fix.replacement == "n: num"


def test_a_parameter_that_is_handed_on_has_the_type_that_the_callee_tells() -> None:
    text = "task A(n)\n  T n\nendp\ntask T(n)\n  mov infeed above n\nendp\nA 20\n"
    assert str(compiled(HEAD + text).tasks["A"]) == "A(n: length [mm])"


@pytest.mark.parametrize(("default", "type_"), [("3", "int"), ("3.5", "num"), ("3 mm", "length [mm]")])
def test_a_default_tells_where_nothing_else_does(default: str, type_: str) -> None:
    assert form(f"task T(n = {default})\n  print n\nendp\nT\n") == f"T(n: {type_} = {default})"


def test_in_a_classic_text_callers_may_tell() -> None:
    text = "task T(n)\n  x = n\n  mov (1, 2, 3)\nendp\ntask U(q)\n  T q\n  mov q\nendp\nU (1, 2, 3)\n"
    assert "T339" not in codes(text)
    assert str(language.compile(text).tasks["T"]) == "T(n: loc)"


def test_a_circle_of_tasks_is_answered() -> None:
    assert "N290" in codes(HEAD + "task T(n: int)\n  U n\nendp\ntask U(n)\n  T n\nendp\nT 3\n")
