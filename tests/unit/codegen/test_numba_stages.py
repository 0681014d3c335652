"""Types of calls are those that numba finds, and it is asked once for the same types."""

import math
import operator
from itertools import product

import pytest

pytest.importorskip("numba", reason="numba is not installed")

from numba.core.errors import TypingError
from numba.core.types import Array, Function, Type, UniTuple, float64, int64
from numba.core.typing import Context

from ropsim.codegen.machine.numba_stages import _CallTypes

ROWS = Array(float64, 2, "C")
NUMBERS = [*product((float64, int64), repeat=2)]
CALLS: list[tuple[object, tuple[Type, ...]]] = [
    *product((operator.add, operator.truediv, operator.pow, operator.lt, max), NUMBERS),
    *product((operator.neg, abs, math.sin, math.sqrt), [(float64,), (int64,)]),
    (operator.getitem, (ROWS, int64)),
    (operator.getitem, (ROWS, UniTuple(int64, 2))),
    (operator.setitem, (ROWS, UniTuple(int64, 2), float64)),
]


def given(types: Context, function: object, arguments: tuple[Type, ...]) -> object:
    return types.resolve_function_type(types.resolve_value_type(function), arguments, {})


def refreshed(types: Context) -> Context:
    types.refresh()
    return types


@pytest.fixture(scope="module")
def known() -> Context:
    return refreshed(_CallTypes())


def test_a_call_has_the_types_that_numba_gives_it_at_first_and_again(known: Context) -> None:
    numbas = refreshed(Context())
    for _ in range(2):
        assert [given(known, *call) for call in CALLS] == [given(numbas, *call) for call in CALLS]


def test_numba_is_asked_once_for_the_same_types(known: Context, monkeypatch: pytest.MonkeyPatch) -> None:
    asked = []
    numbas = Function.get_call_type

    def ask(self: Function, context: Context, args: tuple[Type, ...], kws: dict[str, Type]) -> object:
        asked.append(self.typing_key)
        return numbas(self, context, args, kws)

    monkeypatch.setattr(Function, "get_call_type", ask)
    calls = [(operator.floordiv, pair) for pair in NUMBERS]
    first = [given(known, *call) for call in calls]  # the process may have compiled some of these before
    assert asked.count(operator.floordiv) <= len(NUMBERS)
    asked.clear()
    assert [given(known, *call) for call in calls] == first
    assert asked == []


def test_a_call_that_cannot_be_is_refused_each_time(known: Context) -> None:
    for _ in range(2):
        with pytest.raises(TypingError):
            given(known, math.sin, (ROWS,))
