"""What the compiler computes has the bits that the machine would compute, and traps stay traps."""

import itertools
import math
import struct
from collections.abc import Mapping

import pytest

from ropsim.language.testing import fold
from ropsim.program import Binary, Constant, Program, Unary, ValueType
from support.outcomes import outcome
from support.tasks import codes, compiled

BELOW_HALF = "0.49999999999999994"
"""The largest number below a half: with 0.5 added it is 1."""
NUMBERS = (
    "0.0", "-0.0", "0.5", "-0.5", BELOW_HALF, "-" + BELOW_HALF, "1.5", "2.5", "-2.5", "0.1", "-7.0", "1.0",
    "1e-300", "999999999999.5", "-1e12",
)  # fmt: skip
WHOLES = ("0", "1", "-1", "2", "3", "-7", "1000000000000", "-1000000000000")
OF_ONE = ("-{a}", "abs({a})", "round({a})", "trunc({a})", "sqrt({a})", "sin({a} * 1 rad)", "cos({a} * 1 rad)",
          "tan({a} * 1 rad)", "asin({a})", "acos({a})")  # fmt: skip
OF_TWO = ("{a} + {b}", "{a} - {b}", "{a} * {b}", "{a} / {b}", "{a} mod {b}", "min({a}, {b})", "max({a}, {b})",
          "atan2({a}, {b})", "{a} = {b}", "{a} <> {b}", "{a} < {b}", "{a} <= {b}", "{a} > {b}",
          "{a} >= {b}")  # fmt: skip


def bits(value: object) -> object:
    """Return a value so that zeros of different sign differ."""
    return struct.pack("d", value) if isinstance(value, float) else (type(value), value)


def declared(word: str, kind: str, values: tuple[str, ...]) -> str:
    return "".join(f"{word} {word[0]}{k}: {kind} = {value}\n" for k, value in enumerate(values))


def is_folded(program: Program | None) -> bool:
    assert program is not None
    return not any(isinstance(getattr(one, "value", None), Unary | Binary) for one in program.main)


def computed(head: str, expressions: list[str]) -> Mapping[str, object]:
    """Return the values `y0`, `y1` … of expressions in one program, which must come to its end."""
    found = outcome(head + "".join(f"y{k} = {one}\n" for k, one in enumerate(expressions)))
    assert found.trap is None
    return found.values


@pytest.mark.parametrize(("kind", "values"), [("num", NUMBERS), ("int", WHOLES)])
@pytest.mark.parametrize("form", [*OF_ONE, *OF_TWO])
def test_a_constant_has_the_bits_that_the_machine_computes(
    form: str, kind: str, values: tuple[str, ...]
) -> None:
    """Constants are folded; variables of the same values are computed when the program runs."""
    constants, variables = declared("const", kind, values), declared("var", kind, values)
    places = list(itertools.product(range(len(values)), repeat=2 if "{b}" in form else 1))
    known = [form.format(**dict(zip("ab", (f"c{k}" for k in place), strict=False))) for place in places]
    found = [form.format(**dict(zip("ab", (f"v{k}" for k in place), strict=False))) for place in places]
    first = len(values) + 1
    answer = compiled(constants + "".join(f"y{k} = {one}\n" for k, one in enumerate(known)))
    assert is_folded(answer.program)
    assert {one.code for one in answer.diagnostics if one.is_error} <= {"T306"}
    refused = {one.span.line - first for one in answer.diagnostics if one.is_error and one.span is not None}
    right = [k for k in range(len(places)) if k not in refused]
    folded = computed(constants, [known[k] for k in right])
    run_now = computed(variables, [found[k] for k in right])
    for k, place in enumerate(right):
        assert bits(folded[f"y{k}"]) == bits(run_now[f"y{k}"]), (known[place], places[place])
    for place in refused:
        assert outcome(f"{variables}y = {found[place]}").trap is not None, found[place]


@pytest.mark.parametrize(
    "text", ["0 * (1 / n)", "(1 / n) * 0", "0 * round(1 / n)", "(7 mod n) * 0", "0 * (5 / n) + 3"]
)
def test_a_product_with_zero_hides_no_division_by_zero(text: str) -> None:
    assert outcome(f"var n: int = 0\nx = {text}").trap == ("I460", 2)


@pytest.mark.parametrize("text", ["1000000000000 * 10000000", "round(1e12 * 1e12)", "trunc(-1e12 * 1e12)"])
def test_a_constant_beyond_64_bits_is_refused(text: str) -> None:
    assert codes(f"x = {text}") == ["T306"]


def test_a_sum_with_nothing_keeps_the_sign_that_the_machine_gives_zero() -> None:
    found = outcome("var z: num = -0.0\na = z + 0.0\nb = 0.0 + z\nc = z - 0.0\nd = z * 1\n").values
    assert [math.copysign(1.0, float(str(found[name]))) for name in "abcd"] == [1.0, 1.0, -1.0, -1.0]


def test_orientations_of_constants_and_of_variables_have_the_same_bits() -> None:
    angles = [f"{k * 17.3 - 170:.1f}" for k in range(20)]
    for turn in itertools.pairwise(angles):
        a, b = turn
        head = f"units mm, deg\nvar a: angle = {a}\nvar b: angle = {b}\n"
        found = outcome(f"{head}p = (1, 2, 3; rx {a}, rz {b})\nq = (1, 2, 3; rx a, rz b)").values
        assert found["p"] == found["q"], turn


@pytest.mark.parametrize("number", [*NUMBERS, "5e-324"])
@pytest.mark.parametrize("factor", [0.001, math.pi / 180.0, 1.0, 25.4, 1e-300])
def test_a_number_in_its_unit_has_the_bits_of_the_product(number: str, factor: float) -> None:
    given = fold.real(float(number))
    product = fold.binary("mul", given, fold.real(factor), ValueType.REAL)
    scaled = fold.scaled(given, factor)
    assert isinstance(product, Constant)
    assert isinstance(scaled, Constant)
    assert bits(scaled.value) == bits(product.value)


def test_a_number_too_large_for_its_unit_has_no_place() -> None:
    with pytest.raises(ArithmeticError):
        fold.scaled(fold.real(1.7e308), 25.4)
