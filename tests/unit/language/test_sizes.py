"""Long chains, deep nesting and long texts: each is answered, none breaks the compiler."""

from collections.abc import Callable

import pytest

from ropsim import icr
from ropsim.language.testing import MAX_HINTS
from support.tasks import codes, compiled
from support.work import peak_of, steps_of


def chain(length: int) -> str:
    """Return tasks that call each other, one the next one."""
    tasks = (f"task T{k}\n  T{k + 1}\nendp\n" for k in range(length))
    return f"program p\n{''.join(tasks)}task T{length}\n  open\nendp\nT0\n"


@pytest.mark.parametrize("length", [340, 3000])
def test_tasks_may_call_each_other_in_a_long_chain(length: int) -> None:
    result = compiled(chain(length))
    assert result.diagnostics == ()
    assert result.icr is not None
    assert len(result.icr.procedures) == length + 2


def test_a_contract_is_checked_at_the_end_of_a_long_chain() -> None:
    text = (
        chain(1000)
        .replace("task T1000\n", "task T1000\n  assumes gripper closed\n")
        .replace("\nT0\n", "\nopen\nT0\n")
    )
    assert codes(text) == ["T390"]


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("x = " + "(" * 10_000 + "1" + ")" * 10_000, "L114"),
        ("x = " + "(" * 900 + "1" + ")" * 900, "L113"),
        ("x = " + "(\n" * 10_000 + "1" + ")\n" * 10_000, "L101"),
        ("x = " + "-" * 1900 + "1", "L113"),
        ("x = " + "not " * 400 + "true", "L113"),
        ("x = 1" + " + 1" * 400, "L113"),
        ("if true\n" * 2000 + "open\n" + "endif\n" * 2000, "L113"),
        ("repeat 2\n" * 2000 + "open\n" + "endr\n" * 2000, "L113"),
        ("if true\n" * 2000 + "open\n", "L113"),
        ("if true then " * 150 + "open", "L113"),
    ],
)
def test_what_nests_too_deeply_is_a_finding(text: str, code: str) -> None:
    found = codes(text)
    assert code in found
    assert compiled(text).icr is None


def test_comparisons_of_truth_values_grow_with_their_text_only() -> None:
    code = []
    for depth in (9, 18):
        text = f"a = true\nb = a\nx = {'(' * depth}a == b{') == b' * depth}\nset_it = x <> a\n"
        result = compiled(text)
        assert result.icr is not None
        code.append(sum(len(one.code) for one in result.icr.procedures))
    assert code[1] - code[0] == 9 * 2


@pytest.mark.parametrize(
    "around",
    [
        "dist((#, 1, 0), b)",
        "dist((#, 1, 0, 0, 0), b)",
        "dist((1, #, 0; pitch 30, roll 5), b)",
        "dist((#, 1, 0; down, rz 10) in pallet, b)",
        "dist(b above # offset (4, 0, 0), b)",
        "((#, 0, 0, 0, 0) in pallet rel (0, 0, 5)).x",
        "abs(min(#, x))",
    ],
)
def test_code_grows_with_the_depth_of_an_expression_only(around: str) -> None:
    sizes = []
    for depth in (3, 5, 7):
        inner = "x"
        for _ in range(depth):
            inner = around.replace("#", inner)
        result = compiled(f"units mm\nloc b = (1, 2, 3)\nx = 3 mm\ny = {inner}\n")
        assert result.icr is not None
        sizes.append(len(result.icr.procedures[0].code))
    assert sizes[2] - sizes[1] == sizes[1] - sizes[0]


def lines(line: str, count: int) -> str:
    """Return so many lines, `#` in each replaced by its number."""
    return "\n".join(line.replace("#", str(number)) for number in range(count))


LONG: dict[str, Callable[[int], str]] = {
    "variables": lambda n: lines("x# = 1", n),
    "variables of a task": lambda n: f"task T()\n{lines('x# = 1', n)}\nendp\nT()",
    "moves": lambda n: lines("lin (300, #, 100)", n),
    "branches": lambda n: "n = 1\n" + lines("if n > #\n x# = 2\nelse\n x# = 3\nendif\nprint x#", n),
    "one branching": lambda n: (
        f"n = 1\nif n > 0\n x = 1\n{lines('elseif n > #' + chr(10) + ' x = 2', n)}\nendif"
    ),
    "loops": lambda n: lines("for i# = 1 to 3\n n = i#\nendf", n),
    "patterns": lambda n: PATTERN + lines("for each b in g\n mov b\nendf", n),
    "waits": lambda n: lines("wait until part_ok and x timeout 3 s else print 1", n).join(("x = true\n", "")),
    "ways out of a loop": lambda n: (
        f"repeat 3\n{lines('x# = 1' + chr(10) + 'if x# > 3 then break', n)}\nendr"
    ),
    "passes of a loop": lambda n: (
        f"repeat 3\n{lines('x# = 1' + chr(10) + 'if x# > 3 then continue', n)}\nendr"
    ),
    "returns": lambda n: f"task T()\n{lines('x# = 1' + chr(10) + 'if x# > 3 then return', n)}\nendp\nT()",
    "tasks": lambda n: (
        f"program p\n{lines('task T#()' + chr(10) + 'open' + chr(10) + 'endp', n)}\n{lines('T#()', n)}"
    ),
    "tasks with variables of all": lambda n: "\n".join(
        (
            "program p",
            lines("var x#: int = 0", n),
            lines("task T#()\n x# = x# + 1\nendp", n),
            lines("T#()", n),
        )
    ),
    "a chain of tasks": chain,
}
PATTERN = "units mm\npattern g = grid 2 x 2 from (300, 0, 0) step (9, 0, 0), (0, 9, 0)\n"


def verified(text: str) -> None:
    """Compile a text that is right, and verify its code."""
    result = compiled(text)
    assert result.icr is not None
    assert icr.verify(result.icr) == ()


@pytest.mark.slow
@pytest.mark.parametrize("kind", LONG)
def test_work_and_memory_are_in_proportion_to_the_text(kind: str) -> None:
    short, long = LONG[kind](25), LONG[kind](100)
    assert steps_of(lambda: verified(long)) < PROPORTION * steps_of(lambda: verified(short))
    assert peak_of(lambda: verified(long)) < PROPORTION * peak_of(lambda: verified(short))


PROPORTION = 4.8
"""Four times the text may take so many times the work: 4, and a margin for tables that grow.

It shows what looks through all lines before each line, where that takes a 130th of the work of a line each.
"""


def test_a_right_program_with_many_hints_runs() -> None:
    answer = compiled("".join(f"v{k} = {k}\n" for k in range(500)))
    assert answer.icr is not None
    assert [one.code for one in answer.diagnostics] == ["N239"] * MAX_HINTS
