"""Instructions that only touch the stack, the variables and the program counter.

A handler takes the stack, the variables of the activation and its prepared operand; it returns None, or the
index of the next instruction. The types of the values are proved by the verifier, so they are not checked
again.
"""

import math
import operator
from collections.abc import Callable
from typing import Any

from ropsim.icr.machine.traps import division_by_zero, out_of_range
from ropsim.icr.types import INT_MAX, INT_MIN

Datum = Any  # a stack value; rule V4 proves its type, mypy cannot
Handler = Callable[[list[Datum], list[Datum], Datum], int | None]

MAX_TEXT = 65536
"""Length limit of a STR: a program cannot fill the memory."""


def _push(stack: list[Datum], _values: list[Datum], constant: Datum) -> None:
    stack.append(constant)


def load_local(stack: list[Datum], values: list[Datum], index: Datum) -> None:
    """LOAD of a parameter or local; the operand is its index."""
    stack.append(values[index])


def store_local(stack: list[Datum], values: list[Datum], index: Datum) -> None:
    """STORE to a parameter or local."""
    values[index] = stack.pop()


def load_global(stack: list[Datum], _values: list[Datum], place: Datum) -> None:
    """LOAD of a global; the operand is (all globals, index)."""
    shared, index = place
    stack.append(shared[index])


def store_global(stack: list[Datum], _values: list[Datum], place: Datum) -> None:
    """STORE to a global."""
    shared, index = place
    shared[index] = stack.pop()


def _nop(_stack: list[Datum], _values: list[Datum], _operand: Datum) -> None:
    pass


def _dup(stack: list[Datum], _values: list[Datum], _operand: Datum) -> None:
    stack.append(stack[-1])


def _pop(stack: list[Datum], _values: list[Datum], _operand: Datum) -> None:
    stack.pop()


def _swap(stack: list[Datum], _values: list[Datum], _operand: Datum) -> None:
    stack[-1], stack[-2] = stack[-2], stack[-1]


def _jump(_stack: list[Datum], _values: list[Datum], way: Datum) -> int:
    """JMP; the operand of jumps is the target, and the next instruction."""
    target: int = way[0]
    return target


def _jump_if_false(stack: list[Datum], _values: list[Datum], way: Datum) -> int | None:
    return None if stack.pop() else way[0]


def _jump_if_true(stack: list[Datum], _values: list[Datum], way: Datum) -> int | None:
    return way[0] if stack.pop() else None


def _add_int(stack: list[Datum], _values: list[Datum], _operand: Datum) -> None:
    right = stack.pop()
    stack[-1] = result = stack[-1] + right
    if not INT_MIN <= result <= INT_MAX:
        raise _too_large("ADD.I")


def _sub_int(stack: list[Datum], _values: list[Datum], _operand: Datum) -> None:
    right = stack.pop()
    stack[-1] = result = stack[-1] - right
    if not INT_MIN <= result <= INT_MAX:
        raise _too_large("SUB.I")


def _add_real(stack: list[Datum], _values: list[Datum], _operand: Datum) -> None:
    right = stack.pop()
    stack[-1] = result = stack[-1] + right
    if result - result != 0.0:  # only for infinities and NaN
        raise _not_finite("ADD.R")


def _mul_real(stack: list[Datum], _values: list[Datum], _operand: Datum) -> None:
    right = stack.pop()
    stack[-1] = result = stack[-1] * right
    if result - result != 0.0:
        raise _not_finite("MUL.R")


def _binary(function: Callable[[Datum, Datum], Datum]) -> Handler:
    """Return the handler of a function of two operands that cannot fail."""

    def run(stack: list[Datum], _values: list[Datum], _operand: Datum) -> None:
        right = stack.pop()
        stack[-1] = function(stack[-1], right)

    return run


def _unary(function: Callable[[Datum], Datum]) -> Handler:
    """Return the handler of a function of one operand that cannot fail."""

    def run(stack: list[Datum], _values: list[Datum], _operand: Datum) -> None:
        stack[-1] = function(stack[-1])

    return run


def _int(name: str, function: Callable[..., int]) -> Callable[..., int]:
    """Return a function with its result checked to fit in 64 bits."""

    def checked(*values: float) -> int:
        result = function(*values)
        if not INT_MIN <= result <= INT_MAX:
            raise _too_large(name)
        return result

    return checked


def _real(name: str, function: Callable[..., float]) -> Callable[..., float]:
    """Return a function with its domain and its result checked."""

    def checked(*values: float) -> float:
        try:
            result = function(*values)
        except (ValueError, OverflowError):
            shown = ", ".join(map(repr, values))
            raise out_of_range(f"`{name}` is not defined for {shown}") from None
        if not math.isfinite(result):
            raise _not_finite(name)
        return result

    return checked


def _divide(function: Callable[[Datum, Datum], Datum]) -> Callable[[Datum, Datum], Datum]:
    def checked(left: Datum, right: Datum) -> Datum:
        if right == 0:
            raise division_by_zero()
        return function(left, right)

    return checked


def _rounded(value: float) -> int:
    whole = math.trunc(value)
    return whole + int(math.copysign(1.0, value)) if abs(value - whole) >= 0.5 else whole


def _joined(left: str, right: str) -> str:
    if len(left) + len(right) > MAX_TEXT:
        raise out_of_range(f"a text has {len(left) + len(right)} characters, allowed are {MAX_TEXT}")
    return left + right


def _too_large(name: str) -> Exception:
    return out_of_range(f"the result of `{name}` does not fit in 64 bits")


def _not_finite(name: str) -> Exception:
    return out_of_range(f"the result of `{name}` is not a finite number")


def _equal(stack: list[Datum], _values: list[Datum], _operand: Datum) -> None:
    right = stack.pop()
    stack[-1] = stack[-1] == right


def _unequal(stack: list[Datum], _values: list[Datum], _operand: Datum) -> None:
    right = stack.pop()
    stack[-1] = stack[-1] != right


def _less(stack: list[Datum], _values: list[Datum], _operand: Datum) -> None:
    right = stack.pop()
    stack[-1] = stack[-1] < right


def _at_most(stack: list[Datum], _values: list[Datum], _operand: Datum) -> None:
    right = stack.pop()
    stack[-1] = stack[-1] <= right


def _greater(stack: list[Datum], _values: list[Datum], _operand: Datum) -> None:
    right = stack.pop()
    stack[-1] = stack[-1] > right


def _at_least(stack: list[Datum], _values: list[Datum], _operand: Datum) -> None:
    right = stack.pop()
    stack[-1] = stack[-1] >= right


_COMPARE = {
    "EQ": _equal,
    "NE": _unequal,
    "LT": _less,
    "LE": _at_most,
    "GT": _greater,
    "GE": _at_least,
}

HANDLERS: dict[str, Handler] = {
    "NOP": _nop,
    "PUSH": _push,
    "DUP": _dup,
    "POP": _pop,
    "SWAP": _swap,
    "JMP": _jump,
    "JF": _jump_if_false,
    "JT": _jump_if_true,
    "ADD.I": _add_int,
    "SUB.I": _sub_int,
    "MUL.I": _binary(_int("MUL.I", operator.mul)),
    "DIV.I": _binary(_divide(_int("DIV.I", operator.floordiv))),
    "MOD.I": _binary(_divide(operator.mod)),
    "NEG.I": _unary(_int("NEG.I", operator.neg)),
    "ABS.I": _unary(_int("ABS.I", operator.abs)),
    "MIN.I": _binary(min),
    "MAX.I": _binary(max),
    "ADD.R": _add_real,
    "SUB.R": _binary(_real("SUB.R", operator.sub)),
    "MUL.R": _mul_real,
    "DIV.R": _binary(_divide(_real("DIV.R", operator.truediv))),
    "MOD.R": _binary(_divide(operator.mod)),
    "NEG.R": _unary(operator.neg),
    "ABS.R": _unary(operator.abs),
    "MIN.R": _binary(min),
    "MAX.R": _binary(max),
    "POW": _binary(_real("POW", math.pow)),
    "SQRT": _unary(_real("SQRT", math.sqrt)),
    "SIN": _unary(math.sin),
    "COS": _unary(math.cos),
    "TAN": _unary(_real("TAN", math.tan)),
    "ASIN": _unary(_real("ASIN", math.asin)),
    "ACOS": _unary(_real("ACOS", math.acos)),
    "ATAN2": _binary(math.atan2),
    "I2R": _unary(float),
    "TRUNC": _unary(_int("TRUNC", math.trunc)),
    "ROUND": _unary(_int("ROUND", _rounded)),
    "NOT": _unary(operator.not_),
    "AND": _binary(operator.and_),
    "OR": _binary(operator.or_),
    "XOR": _binary(operator.xor),
    "CAT": _binary(_joined),
    **{f"{name}.{kind}": test for kind in "IR" for name, test in _COMPARE.items()},
    "EQ.B": _equal,
}
"""Mnemonic -> handler; LOAD and STORE depend on where the variable lives."""
