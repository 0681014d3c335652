"""Straight-line source from traced graphs."""

import numpy as np

from ropsim.codegen import Engine, Tracer, cos, emit, load, sin


def test_operations_that_no_result_needs_are_left_out() -> None:
    tracer = Tracer()
    x, y = tracer.variables("x", 2)
    sin(y)
    text = emit("f", ("x", "out"), [("out[0]", x + 1.0)]).text
    assert "sin" not in text
    assert "x[1]" not in text


def test_a_shared_value_is_computed_once() -> None:
    tracer = Tracer()
    x = tracer.variable("x[0]")
    shared = sin(x)
    text = emit("f", ("x", "out"), [("out[0]", shared + 1.0), ("out[1]", shared * x)]).text
    assert text.count("math.sin") == 1


def test_the_same_operations_give_the_same_text_whatever_was_traced_beside_them() -> None:
    def text(beside: int) -> str:
        tracer = Tracer()
        x, y = tracer.variables("x", 2)
        for count in range(beside):
            cos(y + float(count))
        shared = sin(x + y)
        return emit("f", ("x", "out"), [("out[0]", shared + 1.0), ("out[1]", shared * x)]).text

    assert text(beside=0) == text(beside=1000)


def test_constants_are_written_exactly() -> None:
    tracer = Tracer()
    third = 1.0 / 3.0
    text = emit("f", ("x", "out"), [("out[0]", tracer.variable("x[0]") * third)]).text
    assert repr(third) in text


def test_results_may_overwrite_inputs() -> None:
    tracer = Tracer()
    x, y = tracer.variables("x", 2)
    swap = emit("swap", ("x",), [("x[0]", y), ("x[1]", x)])
    values = np.array([1.0, 2.0])
    load("swap", (swap,), Engine.PYTHON)(values)
    assert values.tolist() == [2.0, 1.0]


def test_the_emitted_function_computes_what_the_formula_says() -> None:
    tracer = Tracer()
    x, y = tracer.variables("x", 2)
    results = [("out[0]", -(x * y) + abs(x - 3.0)), ("out[1]", (x + y) / (1.0 + x * x)), ("out[2]", x * -2.0)]
    out = np.empty(3)
    load("formula", (emit("f", ("x", "out"), results),), Engine.PYTHON)(np.array([0.5, -1.5]), out)
    np.testing.assert_array_equal(out, [0.75 + 2.5, -1.0 / 1.25, -1.0])


def test_a_function_without_results_is_still_a_function() -> None:
    source = emit("nothing", ("x",), [])
    load("nothing", (source,), Engine.PYTHON)(np.zeros(1))
    assert source.signature == "void(f8[::1])"
