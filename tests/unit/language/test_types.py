"""Types and units: bare numbers, dimensions, whole numbers."""

import math
import re
from dataclasses import replace

import pytest

from ropsim.flow import MessageInstruction
from ropsim.icr import run
from ropsim.language import LineCache, compile
from ropsim.program import Assign, Constant, Repeat, ValueType, Wait
from support.tasks import CELL, codes, compiled, only


def value(expression: str, head: str = "") -> object:
    """Return the constant that an expression is folded to."""
    result = compiled(f"{head}\nzz = {expression}")
    assert result.program is not None
    last = result.program.main[-1]
    assert isinstance(last, Assign), result.diagnostics
    assert isinstance(last.value, Constant), last
    return last.value.value


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("5 mm", 0.005),
        ("2 inch", 0.0508),
        ("90 deg", math.pi / 2),
        ("3 min", 180.0),
        ("250 ms", 0.25),
        ("30 %", 0.3),
        ("150 mm/s", 0.15),
        ("2 m/s2", 2.0),
        ("180 deg/s", math.pi),
        ("1 kg * 2 m/s2", 2.0),
        ("5 mm + 5", 0.055),
        ("10 - 2 cm", 0.08),
        ("sqrt(9 mm * 1 m) ", math.sqrt(0.009)),
        ("100 mm / 50 mm/s", 2.0),
        ("sin(30)", 0.5),
        ("atan2(1, 1)", math.pi / 4),
        ("acos(0)", math.pi / 2),
        ("min(3 mm, 1)", 0.003),
        ("abs(-3 mm)", 0.003),
    ],
)
def test_quantities_are_si(text: str, expected: float) -> None:
    assert value(text) == pytest.approx(expected, rel=1e-14)


@pytest.mark.parametrize(
    ("text", "expected"),
    [("7 mod 3", 1), ("2 * 3 + 1", 7), ("round(2.5)", 3), ("trunc(-2.7)", -2), ("-(-3)", 3), ("- - 3", 3)],
)
def test_whole_numbers_stay_whole(text: str, expected: int) -> None:
    assert value(text) == expected
    assert isinstance(value(text), int)


def test_a_bare_number_takes_the_unit_of_its_place() -> None:
    result = compiled("units mm, deg, s\nx = 0 mm\nx = (10 + 5) * 2\nwait 3")
    assert result.program is not None
    second, third = result.program.main[1:]
    assert isinstance(second, Assign)
    assert isinstance(second.value, Constant)
    assert second.value.value == pytest.approx(0.03)
    assert isinstance(third, Wait)
    assert third.duration == Constant(3.0, ValueType.REAL)


def test_classic_bare_lengths_are_centimetres() -> None:
    assert value("5 + 0 mm") == pytest.approx(0.05)


def test_a_variable_gets_its_type_from_a_later_use() -> None:
    result = compiled("units mm\nx = 5\nmov (x, 0, 0)\nn = 3\nrepeat n\nopen\nendr")
    assert result.program is not None
    assert [v.type for v in result.program.main_locals] == [ValueType.REAL, ValueType.INT]
    first = result.program.main[0]
    assert isinstance(first, Assign)
    assert first.value == Constant(0.005, ValueType.REAL)


def test_the_printed_count_may_be_written_as_a_real() -> None:
    result = compiled("repeat 6.0\nopen\nendr")
    assert result.program is not None
    loop = result.program.main[0]
    assert isinstance(loop, Repeat)
    assert loop.count == Constant(6, ValueType.INT)


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("x = 5 s + 3 mm", "T302"),
        ("wait 5 mm", "T302"),
        ("mov infeed above 30 %", "T302"),
        ("repeat 2.5\nendr", "T304"),
        ("x = infeed + 1", "T301"),
        ("if 3 then open", "T301"),
        ('x = "a" + 1', "T301"),
        ("x = sqrt(-1)", "T306"),
        ("x = 1 / 0", "T306"),
        ("mov infeed speed 101 %", "T306"),
        ("x = 1e999", "L104"),
        ("x = true = 3", "T301"),
    ],
)
def test_wrong_types_and_dimensions_have_one_finding_each(text: str, code: str) -> None:
    assert codes(text) == [code]


def test_the_message_names_what_was_found_and_what_is_allowed() -> None:
    found = only("wait 5 mm")
    assert found.message == "the time of `wait` must be a time, found a length"
    assert found.span is not None
    assert (found.span.line, found.span.column, found.span.end_column) == (1, 6, 10)


def test_strict_wants_units_and_declarations() -> None:
    assert codes("strict\nvar d: length\nd = 5\nd = 0\nm = 3\nmov home") == ["T307", "T311"]


@pytest.mark.parametrize(
    ("line", "code"),
    [
        ("mov joints(1, 2)\nmov joints(1, 2, 3)", "T335"),
        (f"mov joints({', '.join(['0'] * 33)})", "T335"),
        ("n = 1\nn = 1000000000000 * 1000000000000", "T306"),
        ("n = round(1e12 * 1e12)", "T306"),
        ("repeat 1e12 * 1e12\nendr", "T304"),
        ("mov (1, 2, 1e12 * 1e12)", "T306"),
        ("mov infeed above 1e12 * 1e12", "T306"),
        ("tool t = (0, 0, 1e12 * 1e12)\nopen", "T306"),
        ("units min\nconst h = " + "*".join(["1e12"] * 25) + "*1.7e8\nwait h", "T306"),
    ],
)
def test_what_no_code_could_carry_out_is_a_finding(line: str, code: str) -> None:
    assert codes(line) == [code]


def test_joint_coordinates_are_as_many_as_the_station_has_axes() -> None:
    six = replace(CELL, axes=("angle",) * 6)
    found = only("mov joints(0, 0, 0)", six)
    assert (found.code, found.hint) == ("T335", "the station has 6 axes")
    assert codes("mov joints(0, 0, 0, 0, 0, 0)", six) == []


MODERN = "program p\nunits mm, deg, s\n"


@pytest.mark.parametrize(
    ("lines", "fixed"),
    [
        ("m = 7\nm = m / 2\nprint m", "m = 7.0\nm = m / 2\nprint m"),
        ("m = 0.5\nvar m = 3\nprint m", "m = 0.5\nvar m = 3.0\nprint m"),
        ("m = 7\nm = m * 0.5\nprint m", "m = 7.0\nm = m * 0.5\nprint m"),
        ("m = 7\nm = 2.5\nprint m", "m = 7.0\nm = 2.5\nprint m"),
        ("m = -7\nm = m / 2\nprint m", "m = -7.0\nm = m / 2\nprint m"),
        ("if part_ok then m = 7\nm = m / 2\nprint m", "if part_ok then m = 7.0\nm = m / 2\nprint m"),
        (
            "m = -3\nrepeat 2\n  m = m / 2\nendr\nprint m",
            "m = -3.0\nrepeat 2\n  m = m / 2\nendr\nprint m",
        ),
        ("var m = 7\nm = m / 2\nprint m", "var m = 7.0\nm = m / 2\nprint m"),
        ("strict\nvar m = 0\nm = m + 0.5\nprint m", "strict\nvar m = 0.0\nm = m + 0.5\nprint m"),
        (
            "var m = -7\nrepeat 2\n  m = m / 2\nendr\nprint m",
            "var m = -7.0\nrepeat 2\n  m = m / 2\nendr\nprint m",
        ),
        (
            "if part_ok\n  m = 7\n  m = m / 2\n  print m\nendif",
            "if part_ok\n  m = 7.0\n  m = m / 2\n  print m\nendif",
        ),
    ],
)
def test_a_variable_has_the_type_of_its_first_value(lines: str, fixed: str) -> None:
    """Whatever stands behind: the finding is at the line that does not fit, the fix at the first value."""
    (found,) = compiled(MODERN + lines).diagnostics
    assert found.code == "T304"
    assert found.fix is not None
    assert [label.span for label in found.secondary] == [found.fix.span]
    text = (MODERN + lines).split("\n")
    span = found.fix.span
    line = text[span.line - 1]
    text[span.line - 1] = line[: span.column - 1] + found.fix.replacement + line[span.end_column - 1 :]
    assert "\n".join(text) == MODERN + fixed
    assert compiled(MODERN + fixed).icr is not None


@pytest.mark.parametrize(
    ("lines", "meant"),
    [
        ("m = 300\nlin (m, 0, 100)\nm = m + 12.5\nprint m", "300 mm"),
        ("m = 300\nm = m + 12.5\nlin (m, 0, 100)", "300 mm"),
        ("m = 300\nrepeat 2\n  lin (2 * m, 0, 100)\n  m = m / 2\nendr", "300 mm"),
        ("task T\n  m = 3\n  m = m * 1.5\n  wait m\nendp\nT", "3 s"),
        ("m = 3\nm = m * 1.5\nlin infeed speed m", "3 mm/s"),
        ("m = 3\nm = m * 1.5\nlin (300, 0, 100; down, rz m)", "3 deg"),
    ],
)
def test_a_first_value_of_what_is_used_as_a_quantity_gets_its_unit(lines: str, meant: str) -> None:
    (found,) = compiled(MODERN + lines).diagnostics
    assert (found.code, found.fix) == ("T304", None)
    assert found.hint.startswith(f"write `{meant}` there, as it is used")
    number = meant.partition(" ")[0]
    assert compiled(MODERN + lines.replace(f"m = {number}", f"m = {meant}", 1)).icr is not None


def test_a_first_value_of_nothing_gets_the_unit_of_what_is_added() -> None:
    (found,) = compiled(f"{MODERN}m = 0\nm = m + 10 mm\nlin infeed above m").diagnostics
    assert found.fix is not None
    assert (found.code, found.fix.replacement) == ("T304", "0 mm")
    assert compiled(f"{MODERN}m = 0 mm\nm = m + 10 mm\nlin infeed above m").icr is not None


@pytest.mark.parametrize(
    "lines",
    [
        "m = 3\nlin (m, 0, 100)\nwait m\nm = m / 2",
        "var m = 3\ntask T\n  wait m\nendp\nm = m / 2\nT",
        "m = 2 * 3\nm = m / 2\nwait m",
        "m = 300\nm = m + 12.5\nk = m * 2\nlin (k, 0, 100)",
        "m = 300\nk = m * 2\nlin (k, 0, 100)\nm = m + 12.5\nprint m",
    ],
)
def test_where_no_first_value_is_certain_there_is_no_fix(lines: str) -> None:
    (found,) = compiled(MODERN + lines).diagnostics
    assert (found.code, found.fix) == ("T304", None)


@pytest.mark.parametrize(
    ("lines", "hint"),
    [
        ("m = 3\nm = 5 mm\nprint m", "write a unit there"),
        ("var m = 3\nm = m + 5 mm\nprint m", "write a unit there"),
        ("var m: int = 3\nm = 2.5\nprint m", "declare it as `var m: num`, or use `round( )` here"),
        ("var m: int = 3\nm = 2 mm * 3 s\nprint m", "declare it with a first value in that unit"),
        ("task T(m: int)\n  m = 2.5\n  print m\nendp\nT 3", "use `round( )` or `trunc( )`"),
        ("for m = 1 to 3\n  m = m / 2\n  print m\nendf", "use `round( )` here, or a variable of its own"),
        ("task T\n  for m = 1 to 3\n    m = 5 mm\n    print m\n  endf\nendp\nT", "a variable of its own"),
    ],
)
def test_what_a_variable_cannot_keep_is_told(lines: str, hint: str) -> None:
    (found,) = compiled(MODERN + lines).diagnostics
    assert (found.code, found.fix) == ("T304", None)
    assert hint in found.hint
    assert ("first value is one" in found.message) == lines.startswith(("m = ", "var m ="))


@pytest.mark.parametrize(
    ("lines", "word"),
    [
        ("task T\n  m = m / 2\n  print m\nendp\nvar m = 7\nT", "num"),
        ("task T\n  m = m / 2\n  print m\nendp\nvar m: int = 7\nT", "num"),
        ("task T\n  m = 5 mm\nendp\nvar m = 3\nT\nprint m", "length"),
        ("task T\n  m = m / 2\n  print m\nendp\nvar m = 2 * 3\nT", "num"),
        ("task T\n  m = 20 mm/s\nendp\nvar m = 3\nT\nprint m", "speed"),
    ],
)
def test_a_declared_variable_has_the_type_of_its_first_value_everywhere(lines: str, word: str) -> None:
    """The hint, in the place of the declaration, is what the line needs."""
    (found,) = compiled(MODERN + lines).diagnostics
    assert (found.code, found.fix) == ("T304", None)
    assert "keeps whole numbers, as it is declared" in found.message
    pasted = found.hint.split("`")[1]
    assert pasted == f"var m: {word}"
    assert compiled(MODERN + re.sub(r"var m(: int)?", pasted, lines)).icr is not None


def test_a_parameter_is_not_what_its_name_is_declared_as() -> None:
    text = MODERN + "var m = 3\ntask T(m: int)\n  m = m / 2\n  print m\nendp\nT 3\nprint m"
    hidden, found = [one for one in compiled(text).diagnostics if one.is_error]
    assert hidden.code == "N223"
    assert found.message.startswith("the value of `m` must be a whole number")


def test_a_declared_variable_keeps_its_type_where_no_line_needs_another() -> None:
    text = MODERN + "var n = 7\nvar x = 7.0\nvar d = 2 mm\nn = n + 1\nx = x / 2\nd = d / 4\nprint n, x, d"
    assert compiled(text).diagnostics == ()
    code = compiled(text).icr
    assert code is not None
    assert [m.text for m in run(code).instructions if isinstance(m, MessageInstruction)] == ["8 3.5 0.5 mm"]


@pytest.mark.parametrize(
    ("name", "first", "later", "hint"),
    [
        ("m", "2 * 3", "m / 2", "multiply it by `1.0`"),
        ("m", "7 mod 2", "2.5", "multiply it by `1.0`"),
        ("m", "round(7.2)", "m / 2", "multiply it by `1.0`"),
        ("m", "Count()", "m / 2", "use `round( )` here"),
        ("m", "2 * 3", "5 mm", "let it begin with a length"),
        ("var m", "2 * 3", "m / 2", "multiply it by `1.0`"),
        ("var m", "2 * 3", "5 mm", "let it begin with a length"),
    ],
)
@pytest.mark.parametrize("far", ["", "repeat 2\n  print 1\nendr\n"])
def test_a_first_value_that_is_worked_out_is_marked(
    name: str, first: str, later: str, hint: str, far: str
) -> None:
    """In the same part of the text and in one above."""
    task = "task Count() -> int\n  return 3\nendp\n"
    text = f"{MODERN}{task}{name} = {first}\n{far}m = {later}\nprint m\n"
    (found,) = compiled(text).diagnostics
    assert (found.code, found.fix) == ("T304", None)
    assert hint in found.hint
    assert "as its first value is one" in found.message
    (label,) = found.secondary
    assert text.split("\n")[label.span.line - 1][label.span.column - 1 :] == first
    if "1.0" in hint:
        assert compiled(text.replace(f"m = {first}", f"m = {first} * 1.0")).icr is not None


def test_of_a_counter_with_a_variable_of_its_own_no_other_of_its_name_is_marked() -> None:
    lines = "for i = 1 to 3\n  i = i / 2\nendf\ni = 2\nprint i"
    (found,) = compiled(MODERN + lines).diagnostics
    assert (found.code, found.secondary, found.fix) == ("T304", (), None)


def test_an_edit_of_the_first_value_is_seen_by_the_finding_far_below() -> None:
    cache, far = LineCache(), "".join(f"lin (500, {n}, 300)\n" for n in range(200))
    for first in (
        "m = 2 * 3",
        "m = -7",
        "var m = 7",
        "var m = 2 * 4",
        "var m: int = 7",
        "m = 2 * 4",
        "m = 7.0",
    ):
        text = f"{MODERN}n = 1\n{first}\n{far}m = m / 2\nprint m + n\n"
        assert compile(text, cache=cache).diagnostics == compile(text).diagnostics


def test_in_a_classic_text_lines_behind_tell_the_type() -> None:
    for lines in (
        "m = 7\nm = m / 2\nprint m",
        "var m = 7\nm = m / 2\nprint m",
        "d = 5\nlin infeed above d\nd = 2 cm\nlin infeed above d",
    ):
        assert compiled(lines).diagnostics == (), lines
