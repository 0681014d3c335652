"""Which variable a name means: in loops, behind them, and beside what the compiler keeps."""

import pytest

from support.outcomes import outcome
from support.tasks import codes, only

HEAD = """program p
units mm
pattern a = grid 2 from (0, 0, 40) step (70, 0, 0)
pattern b = grid 2 x 2 from (0, 0, 90) step (0, 70, 0), (5, 0, 0)
"""


def says(text: str) -> tuple[str, ...]:
    found = outcome(HEAD + text)
    assert found.trap is None
    return found.says


def test_nested_loops_over_patterns_may_use_one_name() -> None:
    inner = "for each s in b\nprint s.y, s.col, s.row\nendf\n"
    found = says(f"for each s in a\nprint s.x, s.col\n{inner}print s.x, s.col\nendf")
    through = ("0 mm 1 1", "70 mm 2 1", "0 mm 1 2", "70 mm 2 2")
    assert found == ("0 mm 1", *through, "0 mm 1", "70 mm 2", *through, "70 mm 2")


def test_nested_counting_loops_may_use_one_name() -> None:
    assert says("for i = 1 to 2\nfor i = 5 to 6\nprint i\nendf\nprint i\nendf") == (
        "5",
        "6",
        "1",
        "5",
        "6",
        "2",
    )


def test_a_counting_loop_inside_one_over_a_pattern_may_use_its_name() -> None:
    assert says("for each s in a\nfor s = 7 to 7\nprint s\nendf\nprint s.col\nendf") == ("7", "1", "7", "2")


def test_the_bounds_of_an_inner_loop_read_the_variable_around() -> None:
    assert says("for i = 1 to 2\nfor i = i to 2\nprint i\nendf\nendf") == ("1", "2", "2")


@pytest.mark.parametrize("loop", ["for i = 1 to 3", "for each i in a"])
def test_the_variable_of_a_loop_is_not_known_behind_it(loop: str) -> None:
    found = only(f"{HEAD}{loop}\nprint i\nendf\nprint i")
    assert (found.code, found.span and found.span.line) == ("N202", 8)
    assert "before the loop" in found.hint


def test_a_variable_that_has_a_value_before_counts_and_keeps_its_last_one() -> None:
    assert says("i = 7\nfor i = 1 to 5\nif i = 3 then break\nendf\nprint i") == ("3",)


def test_loops_one_after_the_other_may_count_different_things() -> None:
    text = "for i = 1 to 1\nprint i\nendf\nfor i = 5 mm to 5 mm step 1 mm\nprint i\nendf\ni = true\nprint i"
    assert says(text) == ("1", "5 mm", "true")


@pytest.mark.parametrize("declaration", ["var s: int = 4\n", "s = 4\n"])
def test_a_loop_over_a_pattern_leaves_a_variable_of_its_name_alone(declaration: str) -> None:
    assert says(f"{declaration}for each s in a\nprint s.x\nendf\nprint s") == ("0 mm", "70 mm", "4")


@pytest.mark.parametrize("name", ["s__row", "s__col", "s__left", "s__seen", "s_row"])
def test_no_name_of_a_program_is_one_that_the_compiler_keeps(name: str) -> None:
    text = f"{name} = 5\nfor each s in b\nif s.row = 2 then break\n{name} = {name} + 1\nendf\nprint {name}"
    assert says(text) == ("7",)


def test_a_component_written_in_another_frame_changes_no_variable_of_the_program() -> None:
    assert says("q__seen = 5\nq = infeed\nwith frame pallet\nq.x = 100\nendwith\nprint q__seen, q.x") == (
        "5 500 mm",
    )


def test_load_reads_the_whole_location_before_it_writes() -> None:
    swapped = "units mm\nx = 1 mm\ny = 2 mm\nz = 3 mm\nload (y, x, z), (x, y, z)\nprint x, y, z"
    assert outcome(swapped).says == ("2 mm 1 mm 3 mm",)
    moved = "units mm\nx = 4 mm\nload (x, y, z), infeed offset (x, x, x)\nprint x, y, z"
    assert outcome(moved).says == ("404 mm 304 mm 104 mm",)
    given = "units mm, deg\nx = 1\ny = 2\nz = 3\na = 10\nb = 20\n"
    turned = "load (x, y, z, b, a), (z, x, y, a, b)\nprint x, y, z, b, a"
    assert outcome(given + turned).says == ("3 mm 1 mm 2 mm 10 deg 20 deg",)


def test_load_writes_no_variable_twice() -> None:
    found = only("load (x, y, x), (1, 2, 3)")
    assert (found.code, found.span and found.span.column) == ("N206", 13)


def test_a_loop_variable_may_have_the_name_of_one_of_a_task_around() -> None:
    text = "task T(n: int)\nfor n = 1 to 2\nfor n = 8 to 8\nprint n\nendf\nendf\nprint n\nendp\nT 5"
    assert says(text) == ("8", "8", "2")


def test_a_name_that_is_no_variable_cannot_be_that_of_a_loop() -> None:
    assert codes(f"{HEAD}for each infeed in a\nendf") == ["N207"]
    assert codes(f"{HEAD}for part_ok = 1 to 2\nendf") == ["N207"]
