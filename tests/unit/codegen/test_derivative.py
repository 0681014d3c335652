"""Derivatives of traced formulas against difference quotients."""

import math

import numpy as np
import pytest

from ropsim.codegen import Engine, Formula, GivenCode, Tracer, cos, exp, load, rates_of, sin, sqrt


def test_rates_agree_with_difference_quotients() -> None:
    tracer = Tracer()
    x, v = tracer.variables("x", 3), tracer.variables("v", 3)
    a, b, c = x
    values = [
        sin(a * b) - cos(c) / (1.5 + a * a),
        sqrt(a * a + 2.0 * b * b + 0.3) * c,
        -(a - b) * (c - 2.0 * a) + 3.0,
        tracer.constant(4.0),
    ]
    rates = rates_of(values, dict(zip(x, v, strict=True)))
    results = [(f"out[{k}]", one) for k, one in enumerate([*values, *rates])]
    code = GivenCode.of(Formula("f", ("x", "v", "out"), results))
    function = load("f", code.functions, Engine.PYTHON)

    def evaluated(place: list[float]) -> list[float]:
        out = [0.0] * 8
        function(place, [0.4, -0.7, 1.1], [], out)
        return out

    at, h = np.array([0.3, 0.8, -0.5]), 1e-6
    speed = np.array([0.4, -0.7, 1.1])
    before, after = evaluated((at - h * speed).tolist()), evaluated((at + h * speed).tolist())
    quotients = [(b - a) / (2.0 * h) for a, b in zip(before[:4], after[:4], strict=True)]
    assert evaluated(at.tolist())[4:] == pytest.approx(quotients, rel=1e-8, abs=1e-9)
    assert math.isclose(quotients[3], 0.0)


def test_a_function_without_a_rule_is_refused() -> None:
    x = Tracer().variable("x[0]")
    with pytest.raises(ValueError, match="`exp` has no derivative here"):
        rates_of([exp(x)], {x: x})
