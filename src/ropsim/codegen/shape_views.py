"""What numba compiles for `shapes.py`: views of arrays, which nobody counts."""

from collections.abc import Callable

from llvmlite import ir
from numba.core import cgutils
from numba.core.cpu import CPUContext
from numba.core.types import Array, Integer, Type, float64, int64, intp
from numba.core.typing import Context
from numba.core.typing.templates import Signature
from numba.extending import intrinsic
from numba.np.arrayobj import populate_array

_Written = tuple[Signature, Callable[..., ir.Value]] | None


@intrinsic  # type: ignore[untyped-decorator]  # numba has no types
def as_row(_types: Context, array: Type) -> _Written:
    """Return the numbers of an array without gaps one behind the other."""
    if not isinstance(array, Array) or array.layout != "C":
        return None
    kind = Array(float64, 1, "C")

    def write(
        context: CPUContext, builder: ir.IRBuilder, _signature: Signature, arguments: list[ir.Value]
    ) -> ir.Value:
        given = context.make_array(array)(context, builder, arguments[0])
        count = context.get_constant(intp, 1)
        for length in cgutils.unpack_tuple(builder, given.shape, array.ndim):
            count = builder.mul(count, length)
        return array_view(context, builder, kind, given.data, [count])

    return kind(array), write


@intrinsic  # type: ignore[untyped-decorator]  # numba has no types
def as_table(_types: Context, array: Type, rows: Type, columns: Type) -> _Written:
    """Return the first numbers of an array as a table."""
    if array != Array(float64, 1, "C") or not isinstance(rows, Integer) or not isinstance(columns, Integer):
        return None
    kind = Array(float64, 2, "C")

    def write(
        context: CPUContext, builder: ir.IRBuilder, _signature: Signature, arguments: list[ir.Value]
    ) -> ir.Value:
        given = context.make_array(array)(context, builder, arguments[0])
        return array_view(context, builder, kind, given.data, arguments[1:])

    return kind(array, int64, int64), write


def array_view(
    context: CPUContext, builder: ir.IRBuilder, kind: Array, data: ir.Value, shape: list[ir.Value]
) -> ir.Value:
    """Return an array of float64 without gaps at an address; nobody counts who uses it."""
    made = context.make_array(kind)(context, builder)
    size = itemsize = context.get_constant(intp, 8)
    strides = [size]
    for length in reversed(shape[1:]):
        size = builder.mul(size, length)
        strides.insert(0, size)
    populate_array(made, data, shape, strides, itemsize, meminfo=None)
    return made._getvalue()
