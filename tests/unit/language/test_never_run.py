"""Loops and branches that never run."""

import pytest

from support.tasks import codes, only

HEAD = "program p\nunits mm, deg, s\n"


def told(text: str) -> tuple[str, int, str]:
    """Return code, line in `text` and hint of the one finding."""
    found = only(HEAD + text)
    assert found.span is not None
    assert not found.is_error
    return found.code, found.span.line - 2, found.hint


def mended(text: str) -> str:
    """Return the text with the fix of its one finding."""
    fix = only(HEAD + text).fix
    assert fix is not None
    lines = text.splitlines()
    line = lines[fix.span.line - 3]
    lines[fix.span.line - 3] = line[: fix.span.column - 1] + fix.replacement + line[fix.span.end_column - 1 :]
    return "\n".join(lines)


@pytest.mark.parametrize(
    ("header", "step"),
    [
        ("for i = 10 to 1", "step -1"),
        ("for i = 10 to 1 step 2", "step -2"),
        ("for i = 10 to -1", "step -1"),
        ("for i = 9 mm to 1 mm step 2 mm", "step -2 mm"),
        ("for i = 9 mm to -1mm step 2 mm", "step -2 mm"),
        ("for i = 0.9 to 0.1 step 0.2", "step -0.2"),
        ("FOR i = (10) to (1)", "step -1"),
    ],
)
def test_a_for_that_would_count_down_has_the_step_for_it_as_fix(header: str, step: str) -> None:
    text = f"{header}\n print i\nendf"
    assert told(text) == ("T341", 1, f"write `{step}`")
    assert mended(text) == f"{header.partition(' step')[0]} {step}\n print i\nendf"
    assert codes(HEAD + mended(text)) == []


def test_the_fix_of_a_for_keeps_the_word_behind_it() -> None:
    assert mended("for i = 3 to 1 do\n print i\nendf") == "for i = 3 to 1 step -1 do\n print i\nendf"
    assert mended("for i = 3 to 1 step (1) do\n print i\nendf").startswith("for i = 3 to 1 step (-1) do")


def test_a_for_that_would_count_up_with_a_step_down_is_told_both_ways_out() -> None:
    text = "for i = 1 to 10 step -1\n print i\nendf"
    assert told(text) == ("T341", 1, "write `for i = 10 to 1 step -1`, or `step 1`")
    for header in ("for i = 10 to 1 step -1", "for i = 1 to 10 step 1"):
        assert codes(f"{HEAD}{header}\n print i\nendf") == []


def test_the_values_of_a_for_are_shown_as_they_are_written() -> None:
    text = "for z = 0  mm to 100mm step -10 mm\n print z\nendf"
    first, second = "for z = 100 mm to 0 mm step -10 mm", "step 10 mm"
    assert told(text) == ("T341", 1, f"write `{first}`, or `{second}`")
    assert "`0 mm to 100 mm` counts up" in only(HEAD + text).message
    for header in (first, f"for z = 0 mm to 100 mm {second}"):
        assert codes(f"{HEAD}{header}\n print z\nendf") == []


def test_values_of_a_for_that_are_worked_out_are_not_shown_and_there_is_no_fix() -> None:
    up = only(f"{HEAD}for i = 2 * 5 to 1 + 3\n print i\nendf")
    assert up.message.endswith("from the first value to the last one it counts down, and its step counts up")
    assert (up.hint, up.fix) == ("write `step -1`", None)
    down = only(f"{HEAD}for z = 10 mm + 5 mm to 2 * 20 mm step -1 mm\n print z\nendf")
    assert (down.hint, down.fix) == ("write the values the other way round, or `step 1 mm`", None)


@pytest.mark.parametrize("limit", ["n", "n - 1", "(n)", "2 * n"])
def test_a_bound_with_a_constant_of_the_text_is_told_without_a_fix(limit: str) -> None:
    found = only(f"{HEAD}const n = 0\nfor i = 1 to {limit}\n print i\nendf")
    assert (found.code, found.fix) == ("T341", None)
    assert found.hint == "give the constant another value, or write `step -1` for the other way"


@pytest.mark.parametrize("count", ["0", "-1", "2 - 2"])
def test_a_repeat_that_counts_less_than_one_is_told(count: str) -> None:
    text = f"const n = 0\nopen\nrepeat {count}\n close\nendr\nprint n"
    assert told(text) == ("T341", 3, "write a count of at least 1, or leave the loop out")


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("while false\n open\nendw", 1),
        ("while 1 > 2\n open\nendw", 1),
        ("if false then open", 1),
        ("if false and part_ok then open", 1),
        ("while part_ok and (false or 1 > 2)\n open\nendw", 1),
        ("if false\n open\nendif", 1),
        ("if part_ok\n open\nelseif false\n close\nendif", 3),
        ("repeat 3\n if not true then stop\nendr", 2),
        ("task T()\n if false then open\nendp\nT()", 2),
    ],
)
def test_a_condition_that_is_always_false_is_told_at_its_statement(text: str, line: int) -> None:
    code, at, hint = told(text)
    assert (code, at) == ("T341", line)
    assert hint == "write a condition that may come true, or put `#` before what is not to run"


@pytest.mark.parametrize("branch", ["else", "elseif part_ok"])
def test_a_branch_behind_a_condition_that_is_always_true_is_told(branch: str) -> None:
    code, line, _ = told(f"if true\n open\n{branch}\n close\nendif")
    assert (code, line) == ("T341", 3)


@pytest.mark.parametrize(
    "text",
    [
        "for i = 1 to 1\n print i\nendf",
        "n = 0\nfor i = 1 to n\n print i\nendf",
        "n = 0\nrepeat n\n open\nendr",
        "repeat 1\n open\nendr",
        "while true\n open\nendw",
        "const dry_run = false\nif dry_run then open\nif not dry_run\n close\nelse\n open\nendif",
        "const dry_run = true\nwhile not dry_run\n close\nendw",
        "const passes = 0\nrepeat passes\n open\nendr",
        "const passes = 1\nrepeat passes - 1\n open\nendr",
        "if infeed.z > 5 then open",
        "if true then open",
        "if false or part_ok then open",
        "if part_ok and true\n open\nelse\n close\nendif",
        "n = 3\nwhile n > 5\n n = n + 1\nendw",
    ],
)
def test_what_may_run_and_what_a_constant_switches_is_not_told(text: str) -> None:
    assert codes(HEAD + text) == []
