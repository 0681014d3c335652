"""Warnings of what compiles and is hardly meant."""

import re

import pytest

from support.tasks import codes, compiled, only


@pytest.mark.parametrize(
    ("text", "line", "meant"),
    [
        ("count = 1\nrepeat 3\n cuont = count + 1\nendr\nprint count", 3, "count"),
        ("task T(part: loc)\n prat = part\n mov part\nendp\nT infeed", 2, "part"),
        ("var total: int = 0\ntask T()\n totall = 3\nendp\nT()\nprint total", 3, "total"),
    ],
)
def test_a_new_variable_beside_one_of_nearly_its_name_is_a_warning(text: str, line: int, meant: str) -> None:
    found = only(f"program p\n{text}")
    assert found.span is not None
    assert found.fix is not None
    assert (found.code, found.is_error, found.span.line) == ("N237", False, line + 1)
    assert found.fix.replacement == meant


@pytest.mark.parametrize(
    "text",
    [
        "slot1 = 1\nslot2 = 2\nprint slot1, slot2",
        "count = 1\ncuont = count + 1\nprint cuont",
        "row = 1\nrows = 2\nprint row, rows",
        "load (x, y, z), infeed\nprint x",
    ],
)
def test_names_that_are_read_short_or_differ_by_more_are_no_slips(text: str) -> None:
    assert codes(text) == []


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("stop\nopen", 2),
        ("repeat\n open\nendr\nclose", 4),
        ("while true\n open\nendw\nclose", 4),
        ("repeat 3\n break\n open\nendr", 3),
        ("repeat 3\n if part_ok\n  break\n else\n  continue\n endif\n open\nendr", 7),
        ("with tool jaws\n stop\nendwith\nopen", 4),
        ("task T(q: loc)\n return\n mov q\n lin q\nendp\nT infeed", 3),
    ],
)
def test_a_statement_that_is_never_reached_is_a_warning_at_the_first(text: str, line: int) -> None:
    found = only(text)
    assert found.span is not None
    assert (found.code, found.is_error, found.span.line) == ("T337", False, line)


@pytest.mark.parametrize(
    "text",
    [
        "repeat\n if part_ok then break\nendr\nclose",
        "repeat\n open\nuntil part_ok\nclose",
        "repeat\n repeat 2\n  break\n endr\n if part_ok\n  break\n endif\nendr\nclose",
        "if part_ok then stop\nopen",
        "pattern s = grid 2 x 2 from (0, 0, 0) step (1,0,0), (0,1,0)\nfor each b in s\n break\nendf\nopen",
        "task T(n: int) -> int\n if n > 1\n  return 1\n endif\n return 2\nendp\nx = T(1)\nprint x",
    ],
)
def test_what_a_way_leads_to_is_reached(text: str) -> None:
    assert codes(text) == []


@pytest.mark.parametrize(
    ("text", "hint"),
    [
        ("wait 500", "write `wait 500 ms`, or `wait 500 s`"),
        ("set speed 0.2", "write the unit: `speed 0.2 m/s`, or `speed 0.2 mm/s`, or for joints `speed 20 %`"),
        ("set speed 4", "write the unit: `speed 4 m/s`, or `speed 4 mm/s`"),
        ("set acc 1", "write the unit: `acc 1 m/s2`, or `acc 1 mm/s2`, or for joints `acc 100 %`"),
        ("lin infeed speed 0.5", "write the unit: `speed 0.5 m/s`, or `speed 0.5 mm/s`"),
        ("lin infeed acc 1.2", "write the unit: `acc 1.2 m/s2`, or `acc 1.2 mm/s2`"),
        ("wait until part_ok timeout 5000", "write `timeout 5000 ms`, or `timeout 5000 s`"),
        ("lin infeed until part_ok timeout 500", "write `timeout 500 ms`, or `timeout 500 s`"),
        ("units inch\nlin infeed speed 0.1", "write the unit: `speed 0.1 m/s`, or `speed 2.54 mm/s`"),
        ("units min\nlin infeed speed 20", "write the unit: `speed 20 m/s`, or `speed 3.33333 mm/s`"),
        ("units mm, min\nlin infeed speed 90", "write the unit: `speed 90 mm/s`, or `speed 1.5 mm/s`"),
        ("units inch\nlin infeed speed 0.05", "write the unit: `speed 0.05 m/s`, or `speed 1.27 mm/s`"),
        (
            "with acc 0.9\n open\nendwith",
            "write the unit: `acc 0.9 m/s2`, or `acc 0.9 mm/s2`, or for joints `acc 90 %`",
        ),
        ("units m\nset speed 200", "write the unit: `speed 200 mm/s`"),
        ("lin infeed speed 150 m/s", "write `speed 150 mm/s`, or the speed of a robot"),
        ("mov joints(0, 1.3, -3.14, 0, -1.3, 0)", "write degrees, or `rad` behind each number"),
        ("mov joints(1.5708, 0, 0, 0, 0, 0)", "write degrees, or `rad` behind each number"),
    ],
)
def test_a_bare_number_that_looks_like_another_unit_is_a_warning(text: str, hint: str) -> None:
    found = only(text if text.startswith("units") else f"units mm\n{text}")
    assert (found.code, found.is_error, found.hint) == ("T338", False, hint)
    head = "" if text.startswith("units") else "units mm\n"
    for meant in hint.split("`")[1::2]:
        word = meant.partition(" ")[0]
        if word in ("speed", "acc", "wait", "timeout"):
            assert codes(head + re.sub(rf"{word} [\d.]+( m/s)?", meant, text)) == []


@pytest.mark.parametrize(
    ("line", "mended"),
    [
        ("wait 500", ""),
        ("wait 3600", ""),
        ("wait until part_ok timeout 300", ""),
        ("set speed 3", ""),
        ("lin infeed acc 20", ""),
        ("lin infeed acc 1", ""),
        ("set speed 0.2", "set speed 0.2 m/s"),
        ("lin infeed speed 0.5 blend 3 mm", "lin infeed speed 0.5 m/s blend 3 mm"),
        ("lin infeed speed 150 m/s", "lin infeed speed 150 mm/s"),
        ("lin infeed acc 0.9", "lin infeed acc 0.9 m/s2"),
        ("wait 250 + 250", ""),
        ("set speed 0.12345678", ""),
    ],
)
def test_a_number_that_is_written_out_gets_the_unit_that_is_likely_meant(line: str, mended: str) -> None:
    found = next(one for one in compiled(f"units mm\n{line}").diagnostics if one.code == "T338")
    assert (found.fix is not None) is bool(mended)
    if found.fix is not None:
        span = found.fix.span
        assert line[: span.column - 1] + found.fix.replacement + line[span.end_column - 1 :] == mended
        assert codes(f"units mm\n{mended}") == []


@pytest.mark.parametrize(
    "line",
    [
        "wait 99",
        "wait 500 s",
        "set speed 0.2 mm/s",
        "set speed 200",
        "set speed 45 m/s",
        "set speed 5",
        "set acc 50",
        "set speed 4 mm/s",
        "lin infeed acc 3 mm/s2",
        "wait until part_ok timeout 99",
        "lin infeed until part_ok timeout 500 ms",
        "mov joints(0, 45, -3.14, 0, 0, 0)",
        "mov joints(0, 1, 3, 0, 0, 0)",
        "mov joints(0, 1.57 rad, 0, 0, 0, 0)",
    ],
)
def test_usual_numbers_and_those_with_a_unit_are_believed(line: str) -> None:
    assert codes(f"units mm\n{line}") == []


@pytest.mark.parametrize(
    ("unit", "line"),
    [
        ("min", "wait until part_ok timeout 2"),
        ("ms", "wait 120000"),
        ("ms", "lin infeed until part_ok timeout 300000"),
    ],
)
def test_times_are_believed_where_the_text_names_another_unit(unit: str, line: str) -> None:
    assert codes(f"units mm, deg, {unit}\n{line}") == []
    assert codes(f"units mm, deg, s\n{line.replace('timeout 2', 'timeout 500')}") == ["T338"]


def test_a_task_that_nothing_reaches_is_a_hint() -> None:
    tasks = "task A\n open\nendp\ntask B\n C\nendp\ntask C\n close\nendp\n"
    found = only(f"program p\n{tasks}B")
    assert found.span is not None
    assert (found.code, found.severity.value, found.span.line) == ("N238", "hint", 2)
    assert codes(f"program p\n{tasks}A\nB") == []
    assert codes(f"program p\n{tasks}") == ["L111"]


@pytest.mark.parametrize(
    "text", ["slot1 = 1\nslot2 = 2\nprint slot1", "row = 1\nrow2 = row", "task T()\n n = 3\nendp\nT()"]
)
def test_a_variable_that_nothing_reads_is_a_hint(text: str) -> None:
    found = only(f"program p\n{text}")
    assert (found.code, found.severity.value) == ("N239", "hint")


def test_where_a_line_is_wrong_nothing_is_said_of_variables_that_it_may_read() -> None:
    assert codes("n = 1\nprint n n") == ["L101"]
