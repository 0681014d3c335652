"""Straight-line code written down for LLVM directly."""

import ast
import math
import random

import numpy as np
import pytest
from llvmlite import ir

from ropsim.codegen import (
    Engine,
    Scalar,
    Tracer,
    cos,
    emit,
    exp,
    load,
    maximum,
    minimum,
    power,
    sin,
    sqrt,
    tanh,
)
from ropsim.codegen.formulas.emit import _BINARY, _CALLS
from ropsim.codegen.testing import UNARY, Instructions

COUNT = 6
SPECIAL = (0.0, -0.0, 1.0, -1.0, 0.5, math.inf, -math.inf, math.nan, 5e-324, 1e308)


def formula(rng: random.Random, size: int) -> list[Scalar]:
    """Return `size` values that use all operations on six inputs and on each other."""
    tracer = Tracer()
    values = [*tracer.variables("x", COUNT), tracer.constant(-0.75), tracer.constant(1.0 / 3.0)]
    operations = (
        lambda a, b: a + b,
        lambda a, b: a - b,
        lambda a, b: a * b,
        lambda a, b: a / b,
        lambda a, _: -a,
        lambda a, _: abs(a),
        lambda a, _: sin(a),
        lambda a, _: cos(a),
        lambda a, _: tanh(a),
        lambda a, _: exp(-abs(a)),
        lambda a, b: power(abs(a), minimum(abs(b), b.tracer.constant(1.0))),
        lambda a, _: sqrt(abs(a)),
        minimum,
        maximum,
    )
    for number in range(size):
        values.append(operations[number % len(operations)](*rng.choices(values[-24:], k=2)))
    return values[-size:]


def test_every_bit_is_that_of_the_lines_in_python(
    tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ROPSIM_CACHE_DIR", str(tmp_path_factory.mktemp("cache")))
    rng = random.Random(1)
    values = formula(rng, 220)
    assert {value.op for value in values} >= {*UNARY, *_BINARY, *_CALLS}  # a new operation belongs here, too
    source = emit("f", ("x", "out"), [(f"out[{k}]", value) for k, value in enumerate(values)])
    compiled, lines = (load("bits", (source,), engine) for engine in (Engine.NUMBA, Engine.PYTHON))
    differ = 0
    for _ in range(600):
        x = np.array([rng.choice((rng.gauss(0.0, 2.0), rng.choice(SPECIAL[:5]))) for _ in range(COUNT)])
        got, wanted = np.empty((2, len(values)))
        compiled(x, got)
        try:
            lines(x, wanted)
        except (ZeroDivisionError, OverflowError, ValueError):  # Python's; compiled code gives inf and NaN
            continue
        differ += 1
        np.testing.assert_array_equal(got, wanted)
    assert differ > 100


@pytest.mark.parametrize("special", SPECIAL)
def test_the_smaller_and_the_greater_are_those_of_python(special: float) -> None:
    tracer = Tracer()
    x, y = tracer.variables("x", 2)
    results = [("out[0]", minimum(x, y)), ("out[1]", maximum(x, y)), ("out[2]", abs(x))]
    compiled = load("compared", (emit("f", ("x", "out"), results),), Engine.NUMBA)
    for other in SPECIAL:
        out = np.empty(3)
        compiled(np.array([special, other]), out)
        assert [repr(value) for value in out.tolist()] == [
            repr(value) for value in (min(special, other), max(special, other), abs(special))
        ]


@pytest.mark.parametrize(
    "line",
    [
        "for k in x: pass",
        "y = x",
        "y = x[k]",
        "y = 1",
        "y = x[0] ** 2.0",
        "y = x[0] @ x[1]",
        "y = math.erf(x[0])",
    ],
)
def test_other_lines_are_refused(line: str) -> None:
    module = ir.Module()
    row = ir.DoubleType().as_pointer()
    function = ir.Function(module, ir.FunctionType(ir.VoidType(), [row]), "f")
    lines = Instructions(ir.IRBuilder(function.append_basic_block()), {"x": function.args[0]})
    with pytest.raises(ValueError, match="is not straight-line code"):
        lines.write(ast.parse(line).body[0])
