"""Long chains, deep nesting and long texts: each is answered, none breaks the compiler."""

import pytest

from support.tasks import codes, compiled


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
