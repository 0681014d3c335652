"""Compiled code takes arguments out of objects of Python, and refuses what it cannot take."""

import ctypes
import gc
import subprocess
import sys
from typing import Any

import numpy as np
import pytest

from ropsim.codegen import StoppedError, bound, direct, kernel
from ropsim.codegen.caller import calling
from ropsim.codegen.direct_text import REAL
from ropsim.spatial import Array
from support.in_python import in_python

ROWS = np.arange(24.0).reshape(4, 6)
BLOCK = np.arange(24.0).reshape(2, 3, 4)
kernel_module = sys.modules["ropsim.codegen.kernel"]
SIGNATURE = "void(f8[::1], f8, f8[:,::1], i8, f8[:,:,::1], f8)"


class Named(np.ndarray):
    """An array of another class."""


class Counted(int):
    """A whole number of another class."""


def fixed(array: Array) -> Array:
    copy = array.copy()
    copy.flags.writeable = False
    return copy


def _told(out: Array, first: float, rows: Array, number: int, block: Array, second: float) -> None:
    out[0], out[1], out[2] = first, number, second
    out[3], out[4], out[5], out[6], out[7] = rows.shape[0], rows.shape[1], *block.shape
    for k in range(rows.shape[0]):
        for j in range(rows.shape[1]):
            out[8] += (j + 1) * rows[k, j]
    for k in range(block.shape[0]):
        for j in range(block.shape[1]):
            for i in range(block.shape[2]):
                out[9] += (k + 1) * (i + 1) * block[k, j, i]


@pytest.fixture(params=["directly", "by Python"])
def told(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Any:
    """A kernel that tells what it has been given; by Python where objects are not laid out as expected."""
    if request.param == "by Python":
        monkeypatch.setattr(direct, "is_as_read", lambda: False)
        monkeypatch.setattr(direct, "_direct", direct._direct.__wrapped__)
    return kernel(SIGNATURE)(_told)


ARRAYS = [
    ROWS,
    ROWS[1:3],
    fixed(ROWS),
    np.zeros((0, 3)),
    np.zeros((7, 0)),
    ROWS.view(Named),
    ROWS[:, :1].copy(),
]
BLOCKS = [BLOCK, BLOCK[1:], fixed(BLOCK), np.zeros((2, 0, 3)), BLOCK.view(Named)]


@pytest.mark.parametrize("rows", ARRAYS, ids=lambda array: f"{type(array).__name__}{array.shape}")
@pytest.mark.parametrize("block", BLOCKS, ids=lambda array: f"{type(array).__name__}{array.shape}")
def test_a_kernel_is_given_all_arguments(told: Any, rows: Array, block: Array) -> None:
    out, plain = np.zeros(10), np.zeros(10)
    for given in (out, plain):
        (told if given is out else _told)(given, 0.1, rows, -1, block, -7.5)
    np.testing.assert_array_equal(out, plain)


REALS = [
    2.5,
    np.float64(-2.5),
    np.float32(0.5),
    3,
    -1,
    2**53 + 1,
    2**63,
    True,
    np.int32(4),
    float("nan"),
    1e999,
]


@pytest.mark.parametrize("number", REALS, ids=repr)
def test_a_float_is_what_python_makes_of_a_number(told: Any, number: Any) -> None:
    out = np.zeros(10)
    told(out, number, ROWS, 0, BLOCK, number)
    np.testing.assert_array_equal(out[[0, 2]], float(number))


WHOLES = [0, 7, -1, True, 2**52, -(2**52), np.int64(-3), np.int32(3), np.uint8(200), Counted(5)]


@pytest.mark.parametrize("number", WHOLES, ids=repr)
def test_a_whole_number_is_what_python_makes_of_it(told: Any, number: Any) -> None:
    out = np.zeros(10)
    told(out, 0.0, ROWS, number, BLOCK, 0.0)
    assert out[1] == int(number)


WRONG = {
    "gaps": ROWS[:, ::2],
    "columns first": ROWS.T,
    "half as long": ROWS.astype(np.float32),
    "whole numbers": ROWS.astype(np.int64),
    "other bytes first": ROWS.astype(">f8"),
    "one axis": ROWS[0],
    "three axes": BLOCK,
    "no axis": np.array(1.0),
    "repeated": np.broadcast_to(np.zeros(3), (4, 3)),
    "None": None,
    "int": 5,
    "float": 5.0,
    "text": "rows",
    "bytes": b"rows" * 40,
    "list": [[1.0]],
    "a type": np.ndarray,
    "gaps in another class": ROWS.view(Named)[:, ::2],
}


@pytest.mark.parametrize("rows", WRONG.values(), ids=WRONG)
def test_what_compiled_code_cannot_take_is_refused(told: Any, rows: Any) -> None:
    out = np.zeros(10)
    with pytest.raises(TypeError, match="compiled code takes"):
        told(out, 0.0, rows, 0, BLOCK, 0.0)
    assert not out.any()


@pytest.mark.parametrize("number", [None, "1", ROWS, [1.0], 10**400], ids=lambda one: type(one).__name__)
def test_what_is_no_number_is_refused(told: Any, number: Any) -> None:
    with pytest.raises(Exception, match=r"required argument|int too large"):
        told(np.zeros(10), number, ROWS, 0, BLOCK, 0.0)


@pytest.mark.parametrize("number", [1.0, np.float64(1.0), None, 2**63, -(2**63) - 1], ids=repr)
def test_what_is_no_whole_number_is_refused(told: Any, number: Any) -> None:
    with pytest.raises(Exception, match=r"required argument|int too large|argument out of range"):
        told(np.zeros(10), 0.0, ROWS, number, BLOCK, 0.0)


def test_so_many_arguments_without_names_are_taken_and_no_others(told: Any) -> None:
    given = (np.zeros(10), 0.0, ROWS, 0, BLOCK, 0.0)
    for count in range(len(given)):
        with pytest.raises((TypeError, ValueError)):
            told(*given[:count])
    for more in ((*given, 0.0), (*given, ROWS)):
        with pytest.raises((TypeError, ValueError)):
            told(*more)
    with pytest.raises(TypeError):
        told(*given[:-1], second=0.0)


def test_bound_arguments_go_before_the_others(told: Any) -> None:
    given = (np.zeros(10), 0.5, ROWS, 3, BLOCK, 0.25)
    plain = np.zeros(10)
    _told(plain, *given[1:])
    for first in range(len(given) + 1):
        for second in range(first, len(given) + 1):
            given[0][:] = 0.0
            bound(bound(told, *given[:first]), *given[first:second])(*given[second:])
            np.testing.assert_array_equal(given[0], plain)


def test_calls_keep_and_take_nothing_of_the_objects(told: Any) -> None:
    given = (np.zeros(10), 0.123, ROWS.copy(), 12345, BLOCK.copy(), 0.25)
    told(*given)
    made = bound(told, *given[:2])
    objects = (*given, None)
    before = [ctypes.c_ssize_t.from_address(id(one)).value for one in objects]
    for _ in range(1000):
        assert told(*given) is None
        assert made(*given[2:]) is None
    after = [ctypes.c_ssize_t.from_address(id(one)).value for one in objects]
    assert np.abs(np.subtract(after, before)).max() < 100


def _early(*_places: int) -> int:
    return 3


def test_code_that_ends_before_its_end_is_told_once() -> None:
    code = ctypes.CFUNCTYPE(ctypes.c_int32, *[ctypes.c_void_p] * 4)(_early)
    address = ctypes.cast(code, ctypes.c_void_p).value
    assert address is not None
    call = calling(address, (1, REAL))
    for last in (1.0, True):
        with pytest.raises(StoppedError, match="ended with status 3"):
            call(np.zeros(2), last)


def test_a_kernel_is_a_function_of_python_with_name_and_text() -> None:
    made: Any = kernel(SIGNATURE)(_told)
    assert (made.__name__, made.__module__) == ("_told", __name__)
    assert in_python(made) is _told
    assert in_python(_told) is _told


def test_kernels_and_bound_functions_can_be_let_go() -> None:
    made: Any = kernel(SIGNATURE)(_told)
    behind = ctypes.py_object(made.__self__)
    assert behind.value is made.__self__
    for _ in range(3):
        made = kernel(SIGNATURE)(_told)
        calls = [bound(made, np.zeros(10), float(k)) for k in range(10)]
        calls[-1](ROWS, 1, BLOCK, 2.0)
        del calls
        gc.collect()


class Boastful(np.ndarray):
    """An array whose class tells of more numbers than there are."""

    @property  # type: ignore[misc]
    def shape(self) -> Any:
        return (1 << 28, 1 << 10)

    @property
    def dtype(self) -> Any:
        return np.dtype(np.float64)

    @property
    def __array_interface__(self) -> Any:
        return {"data": (16, False)}


class Pretender:
    """What only says that it is an array."""

    __class__ = np.ndarray  # type: ignore[assignment]
    dtype, ndim, shape = np.dtype(np.float64), 2, (4, 6)


def test_what_the_class_of_an_array_tells_is_not_believed(told: Any) -> None:
    out, plain = np.zeros(10), np.zeros(10)
    told(out, 0.0, ROWS.view(Boastful), 0, BLOCK, 0.0)
    told(plain, 0.0, ROWS, 0, BLOCK, 0.0)
    np.testing.assert_array_equal(out, plain)
    for wrong in (ROWS.astype(np.int8).view(Boastful), Pretender()):
        with pytest.raises(TypeError, match="compiled code takes"):
            told(out, 0.0, wrong, 0, BLOCK, 0.0)


def test_what_is_compiled_a_second_time_meanwhile_is_left_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    one: Any = kernel(SIGNATURE)(_told)
    made, blocks = kernel_module._compiled, []

    def slowly(*arguments: Any) -> Any:
        monkeypatch.setattr(kernel_module, "_compiled", made)
        one(np.zeros(10), 0.0, ROWS, 0, BLOCK, 0.0)  # as another thread would
        blocks.append(one.__self__.block)
        return made(*arguments)

    monkeypatch.setattr(kernel_module, "_compiled", slowly)
    one(np.zeros(10), 0.0, ROWS, 0, BLOCK, 0.0)
    assert one.__self__.block is blocks[0]


def test_kernels_can_be_called_when_modules_are_gone() -> None:
    text = """
import builtins, numpy as np
from ropsim.kinematics.steps_kernel import spread_over
class Late:
    array = np.ones(1), np.ones((1, 1))
    spread = staticmethod(spread_over)
    def __del__(self):
        self.spread(self.array[1], self.array[0], self.array[0])
        self.write("late")
    from os import write as _write
    def write(self, text, write=_write): write(1, text.encode())
builtins.late = Late()
spread_over(Late.array[1], Late.array[0], Late.array[0])
"""
    ended = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, check=True)
    assert (ended.stdout, ended.stderr) == ("late", "")
