"""Folding and sharing of traced scalars."""

import math

import pytest

from ropsim.codegen import Tracer, cos, exp, sin, tanh


def test_adding_zero_and_multiplying_by_one_give_the_same_node() -> None:
    tracer = Tracer()
    x = tracer.variable("x[0]")
    assert x + 0.0 is x
    assert 0.0 + x is x
    assert x - 0.0 is x
    assert 1.0 * x is x
    assert x / 1.0 is x


def test_multiplying_by_zero_gives_the_constant_zero() -> None:
    tracer = Tracer()
    assert (tracer.variable("x[0]") * 0.0).value == 0.0


def test_constants_fold_with_double_precision() -> None:
    tracer = Tracer()
    a, b = tracer.constant(0.1), tracer.constant(0.2)
    assert (a + b).value == 0.1 + 0.2
    assert (a - b).value == 0.1 - 0.2
    assert (a * b).value == 0.1 * 0.2
    assert (a / b).value == 0.1 / 0.2


def test_functions_of_constants_fold() -> None:
    tracer = Tracer()
    angle = tracer.constant(0.7)
    assert sin(angle).value == math.sin(0.7)
    assert cos(angle).value == math.cos(0.7)
    assert tanh(angle).value == math.tanh(0.7)
    assert exp(angle).value == math.exp(0.7)
    assert abs(-angle).value == 0.7


def test_equal_operations_are_one_node_whatever_the_order_of_their_operands() -> None:
    tracer = Tracer()
    x, y = tracer.variables("x", 2)
    assert x + y is y + x
    assert x * y is y * x
    assert x - y is not y - x


def test_signs_move_outwards_and_cancel() -> None:
    tracer = Tracer()
    x, y = tracer.variables("x", 2)
    negative = -x
    assert -negative is x
    assert (-x) * (-y) is x * y
    assert x * -1.0 is -x
    assert x - (-y) is x + y
    assert x + (-y) is x - y
    assert -(x - y) is y - x
    assert (-x) / (-y) is x / y


def test_a_number_less_itself_is_zero() -> None:
    tracer = Tracer()
    x = tracer.variable("x[0]")
    assert (x - x).value == 0.0


def test_a_zero_constant_has_no_sign() -> None:
    assert math.copysign(1.0, Tracer().constant(-0.0).value or 0.0) == 1.0


@pytest.mark.parametrize("factor", [-2.0, 0.5, 3.0])
def test_negative_factors_share_the_product_of_the_positive_one(factor: float) -> None:
    tracer = Tracer()
    x = tracer.variable("x[0]")
    assert x * -factor is -(x * factor)
