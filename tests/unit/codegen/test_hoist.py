"""Formulas that are split into what given numbers alone decide and the rest."""

import re

import numpy as np
import pytest

from ropsim.codegen import Engine, Formula, GivenCode, Scalar, Tracer, cos, given, load


def _formula(tracer: Tracer, present: tuple[bool, ...]) -> tuple[list[Scalar], list[Scalar]]:
    """Return x and results that mix x with numbers in all ways."""
    a, b, c = given(tracer, present)
    x = tracer.variables("x", 2)
    return x, [
        (a * b + c) * x[0] - 1.0 / (a * a) * cos(x[1] * (b - c)),
        abs(a) * abs(b),
        x[1] + 2.0,
        tracer.constant(7.0) * x[0] - (a * b + c),
    ]


def _code(present: tuple[bool, ...] = (True, True, True)) -> GivenCode:
    _, results = _formula(Tracer(), present)
    return GivenCode.of(Formula("f", ("x", "out"), [(f"out[{k}]", value) for k, value in enumerate(results)]))


def _value(numbers: tuple[float, ...], x: tuple[float, float]) -> list[float]:
    a, b, c = numbers
    return [
        (a * b + c) * x[0] - np.cos(x[1] * (b - c)) / (a * a),
        abs(a * b),
        x[1] + 2.0,
        7.0 * x[0] - (a * b + c),
    ]


@pytest.mark.parametrize("numbers", [(2.0, 3.0, -0.5), (-1.5, 0.25, 4.0), (1e-3, -1e3, 0.0)])
def test_the_parts_together_are_the_formula(numbers: tuple[float, ...]) -> None:
    out = np.empty(4)
    _code().bound("f", np.array(numbers), Engine.PYTHON)(np.array([0.3, -0.8]), out)
    np.testing.assert_allclose(out, _value(numbers, (0.3, -0.8)), rtol=1e-13)


def test_other_numbers_need_no_other_code() -> None:
    assert _code() == _code()
    functions = _code().functions
    assert load("f", functions, Engine.PYTHON) is load("f", _code().functions, Engine.PYTHON)


def test_the_code_does_no_work_that_numbers_alone_decide() -> None:
    """Every operation has an operand that changes at every call."""
    text = _code().functions[0].text
    assert "numbers" not in text
    constant = r"float\(constants\[\d+\]\)"
    assert not re.search(rf"{constant} [-+*/] {constant}", text)
    assert not re.search(rf"(abs|cos)\({constant}\)", text)


def test_what_is_wanted_twice_is_made_once() -> None:
    code = _code()
    assert code.count == 4  # a·b + c, 1 / a², b - c, |a|·|b|
    assert code.constants(np.array([2.0, 3.0, 4.0])).tolist() == pytest.approx([10.0, 0.25, -1.0, 6.0])


def test_a_number_that_is_not_there_leaves_the_code() -> None:
    code = _code((True, False, True))
    out, numbers = np.empty(4), np.array([2.0, 0.0, 3.0])
    code.bound("f", numbers, Engine.PYTHON)(np.array([0.3, -0.8]), out)
    np.testing.assert_allclose(out, _value((2.0, 0.0, 3.0), (0.3, -0.8)), rtol=1e-13)
    assert "numbers[1]" not in code.prologue.text


def test_functions_of_one_module_share_their_constants() -> None:
    tracer = Tracer()
    (a,) = given(tracer, (True,))
    x, y = tracer.variable("x[0]"), tracer.variable("y[0]")
    code = GivenCode.of(
        Formula("f", ("x", "out"), [("out[0]", x * (a * a))]),
        Formula("g", ("y", "out"), [("out[0]", y + a * a)]),
    )
    assert code.count == 1
    assert [function.text.count("constants[0]") for function in code.functions] == [1, 1]
