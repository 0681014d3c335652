"""The door to compiled code: arguments of Python reach it whole, and it refuses those that it cannot take."""

import ctypes
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest

from ropsim.codegen import Array1, Array2, Array3, Kernel, StoppedError, bound, kernel
from ropsim.codegen.testing import REAL, Call, NoObjectCodeError, Signature, machine_code_at
from ropsim.spatial import Array
from support.in_python import in_python

ROWS = np.arange(24.0).reshape(4, 6)
BLOCK = np.arange(24.0).reshape(2, 3, 4)


class Named(np.ndarray):
    """An array of another class."""


class Counted(int):
    """A whole number of another class."""


def fixed(array: Array) -> Array:
    copy = array.copy()
    copy.flags.writeable = False
    return copy


def _written(out: Array1, first: float, rows: Array2, number: int, block: Array3, second: float) -> None:
    out[0], out[1], out[2] = first, number, second
    out[3], out[4], out[5], out[6], out[7] = rows.shape[0], rows.shape[1], *block.shape
    for k in range(rows.shape[0]):
        for j in range(rows.shape[1]):
            out[8] += (j + 1) * rows[k, j]
    for k in range(block.shape[0]):
        for j in range(block.shape[1]):
            for i in range(block.shape[2]):
                out[9] += (k + 1) * (i + 1) * block[k, j, i]


def no_object_code(*_anything: object) -> None:
    raise NoObjectCodeError


@pytest.fixture(params=["machine code", "numba"])
def written(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Any:
    """A kernel that writes its arguments down; compiled by numba alone where no object code can be made."""
    if request.param == "numba":
        monkeypatch.setenv("ROPSIM_CACHE_DIR", str(tmp_path))
        monkeypatch.setattr("ropsim.codegen.machine.compiled.emit_object", no_object_code)
        return BY_NUMBA
    return WRITTEN


WRITTEN, BY_NUMBA = kernel(_written), kernel(_written)


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
def test_a_kernel_is_given_all_arguments(written: Any, rows: Array, block: Array) -> None:
    out, plain = np.zeros(10), np.zeros(10)
    for given in (out, plain):
        (written if given is out else _written)(given, 0.1, rows, -1, block, -7.5)
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
def test_a_float_is_what_python_makes_of_a_number(written: Any, number: Any) -> None:
    out = np.zeros(10)
    written(out, number, ROWS, 0, BLOCK, number)
    np.testing.assert_array_equal(out[[0, 2]], float(number))


WHOLES = [0, 7, -1, True, 2**52, -(2**52), np.int64(-3), np.int32(3), np.uint8(200), Counted(5)]


@pytest.mark.parametrize("number", WHOLES, ids=repr)
def test_a_whole_number_is_what_python_makes_of_it(written: Any, number: Any) -> None:
    out = np.zeros(10)
    written(out, 0.0, ROWS, number, BLOCK, 0.0)
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
def test_what_compiled_code_cannot_take_is_refused(written: Any, rows: Any) -> None:
    out = np.zeros(10)
    with pytest.raises(TypeError, match="compiled code takes"):
        written(out, 0.0, rows, 0, BLOCK, 0.0)
    assert not out.any()


@pytest.mark.parametrize("number", [None, "1", ROWS, [1.0], 10**400], ids=lambda one: type(one).__name__)
def test_what_is_no_number_is_refused(written: Any, number: Any) -> None:
    with pytest.raises(Exception, match=r"required argument|int too large|takes a number"):
        written(np.zeros(10), number, ROWS, 0, BLOCK, 0.0)


@pytest.mark.parametrize("number", [1.0, np.float64(1.0), None, 2**63, -(2**63) - 1], ids=repr)
def test_what_is_no_whole_number_is_refused(written: Any, number: Any) -> None:
    with pytest.raises(Exception, match=r"required argument|int too large|argument out of range"):
        written(np.zeros(10), 0.0, ROWS, number, BLOCK, 0.0)


def test_so_many_arguments_without_names_are_taken_and_no_others(written: Any) -> None:
    given = (np.zeros(10), 0.0, ROWS, 0, BLOCK, 0.0)
    for count in range(len(given)):
        with pytest.raises((TypeError, ValueError)):
            written(*given[:count])
    for more in ((*given, 0.0), (*given, ROWS)):
        with pytest.raises((TypeError, ValueError)):
            written(*more)
    with pytest.raises(TypeError):
        written(*given[:-1], second=0.0)


def test_bound_arguments_go_before_the_others(written: Any) -> None:
    given = (np.zeros(10), 0.5, ROWS, 3, BLOCK, 0.25)
    plain = np.zeros(10)
    _written(plain, *given[1:])
    for first in range(len(given) + 1):
        for second in range(first, len(given) + 1):
            given[0][:] = 0.0
            bound(bound(written, *given[:first]), *given[first:second])(*given[second:])
            np.testing.assert_array_equal(given[0], plain)


def test_calls_keep_and_take_nothing_of_the_objects(written: Any) -> None:
    given = (np.zeros(10), 0.123, ROWS.copy(), 12345, BLOCK.copy(), 0.25)
    written(*given)
    made = bound(written, *given[:2])
    objects = (*given, None)
    before = [ctypes.c_ssize_t.from_address(id(one)).value for one in objects]
    for _ in range(1000):
        assert written(*given) is None
        assert made(*given[2:]) is None
    after = [ctypes.c_ssize_t.from_address(id(one)).value for one in objects]
    assert np.abs(np.subtract(after, before)).max() < 100


def _early(*_places: int) -> int:
    return 3


def test_code_that_stops_before_its_end_raises_an_error() -> None:
    code = ctypes.CFUNCTYPE(ctypes.c_int32, ctypes.c_void_p)(lambda _block: 3)
    address = ctypes.cast(code, ctypes.c_void_p).value
    assert address is not None
    call = Call(machine_code_at(address), (1, REAL))
    for last in (1.0, True):
        with pytest.raises(StoppedError, match="ended with status 3"):
            call(np.zeros(2), last)


def test_a_kernel_has_name_and_text_of_its_function() -> None:
    made: Any = kernel(_written)
    assert (made.__name__, made.__module__) == ("_written", __name__)
    assert in_python(made) is _written
    assert in_python(_written) is _written


def test_many_threads_call_a_kernel_at_the_same_time(written: Any) -> None:
    def one(number: int) -> list[float]:
        out = np.zeros(10)
        for _ in range(200):
            written(out, float(number), ROWS, number, BLOCK, 0.0)
        return [*out[:2]]

    with ThreadPoolExecutor(8) as pool:
        assert list(pool.map(one, range(16))) == [[float(number), float(number)] for number in range(16)]


class Inner(NamedTuple):
    """A record in another one."""

    number: int
    rows: Array2


class Outer(NamedTuple):
    """A record of all kinds."""

    share: float
    inner: Inner
    place: Array1
    block: Array3


class Similar(NamedTuple):
    """A record with the same fields."""

    number: int
    rows: Array2


def _records(first: Outer, second: Inner, out: Array1) -> None:
    out[0] = first.share * first.inner.number + second.number
    out[1] = first.inner.rows[1, 0] + 10.0 * second.rows[0, 1]
    _ends(first, Inner(3, first.inner.rows[1:]), out)


def _ends(first: Outer, made: Inner, out: Array) -> None:
    out[2], out[3] = first.place[-1], first.block[1, 0, 2]
    out[4] = made.number * made.rows[0, 0]


RECORDS, RECORDS_BY_NUMBA = kernel(_records), kernel(_records)


@pytest.fixture(params=["machine code", "numba", "Python"])
def records(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Any:
    """A kernel of records in each of the ways in which it may run."""
    if request.param == "numba":
        monkeypatch.setenv("ROPSIM_CACHE_DIR", str(tmp_path))
        monkeypatch.setattr("ropsim.codegen.machine.compiled.emit_object", no_object_code)
        return RECORDS_BY_NUMBA
    return RECORDS if request.param == "machine code" else _records


OUTER, INNER = Outer(0.5, Inner(4, ROWS), np.arange(3.0), BLOCK), Inner(7, fixed(ROWS))
FOUND = [9.0, 16.0, 2.0, 14.0, 18.0]


def test_a_kernel_takes_records_of_arrays_numbers_and_records(records: Any) -> None:
    out = np.zeros(5)
    records(OUTER, INNER, out)
    assert out.tolist() == FOUND


def test_records_are_bound_like_other_arguments(records: Any) -> None:
    for count in range(3):
        out = np.zeros(5)
        bound(records, *(OUTER, INNER)[:count])(*(OUTER, INNER)[count:], out)
        assert out.tolist() == FOUND


@pytest.mark.parametrize(
    "wrong",
    [Similar(7, ROWS), (7, ROWS), Inner(7, ROWS[0]), Inner(7, ROWS[:, ::2]), Inner(7, None), None],  # type: ignore[arg-type]
    ids=repr,
)
def test_another_record_is_refused(wrong: Any) -> None:
    out = np.zeros(5)
    with pytest.raises(TypeError, match="compiled code takes"):
        RECORDS(OUTER, wrong, out)
    assert not out.any()


def test_a_signature_is_read_from_annotations_at_the_first_need() -> None:
    assert Signature.of(_written) == Signature.parse("void(f8[::1], f8, f8[:,::1], i8, f8[:,:,::1], f8)")
    assert Signature.of(_records).records == (Inner, Outer)

    def unknown(rows: Array, out: Array1) -> None: ...

    def returned(out: Array1) -> float: ...  # type: ignore[empty-body]

    for function in (unknown, returned):
        made = Kernel(function)  # type: ignore[arg-type]
        with pytest.raises(TypeError, match=function.__name__):
            made.made()


class Boastful(np.ndarray):
    """An array whose class states more numbers than there are."""

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


def test_what_the_class_of_an_array_states_is_not_believed(written: Any) -> None:
    out, plain = np.zeros(10), np.zeros(10)
    written(out, 0.0, ROWS.view(Boastful), 0, BLOCK, 0.0)
    _written(plain, 0.0, ROWS, 0, BLOCK, 0.0)
    np.testing.assert_array_equal(out, plain)
    for wrong in (ROWS.astype(np.int8).view(Boastful), Pretender()):
        with pytest.raises(TypeError, match="compiled code takes"):
            written(out, 0.0, wrong, 0, BLOCK, 0.0)


def test_kernels_can_be_called_when_modules_are_gone() -> None:
    text = """
import builtins, numpy as np
from ropsim.kinematics.chain.steps_kernel import spread_over
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
