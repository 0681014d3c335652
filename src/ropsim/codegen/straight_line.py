"""Straight-line source to instructions of LLVM, without numba's stages for programs of any kind.

A formula of hundreds of lines has one type and no branch: there is nothing to find out about it. Written
down directly it is compiled in a third of the time.
"""

import ast
from collections.abc import Callable
from typing import TYPE_CHECKING, Protocol, cast

from llvmlite import ir

from ropsim.codegen.instructions import REAL, Instructions
from ropsim.codegen.lanes import written_for_rows

if TYPE_CHECKING:
    from numba.core.types import Type
    from numba.core.typing.templates import Signature


_ROW, _ROWS = "array(float64, 1d, C)", "array(float64, 2d, C)"
"""numba's words for arrays of float64 without gaps."""


class _Row(Protocol):
    """What is needed of numba's view of an array: where it is, and its lengths."""

    data: ir.Value
    shape: ir.Value


class _Context(Protocol):
    """What is needed of numba's context of a target."""

    def make_array(self, kind: "Type") -> Callable[..., "_Row"]:
        """Return what makes a view of an array of the type."""

    def get_dummy_value(self) -> ir.Value:
        """Return what stands for no value."""


def straight_line(text: str) -> Callable[..., None]:
    """Return a function for code that numba compiles; nobody else can call it.

    Args:
        text: of a function of one-dimensional arrays of float64, as `emit` writes it.
    """
    function = _parsed(text)
    names = [argument.arg for argument in function.args.args]

    def write(builder: ir.IRBuilder, rows: list[_Row]) -> None:
        builder.call(_written(builder.module, function, names), [row.data for row in rows])

    return _made(function.name, names, dict.fromkeys(names, _ROW), write)


def straight_rows(text: str, name: str, shared: str) -> Callable[..., None]:
    """Return a function of arrays of rows for code that numba compiles, see `ropsim.codegen.row_by_row`.

    Args:
        text: of the function of one row, as for `straight_line`.
        name: of the function.
        shared: name of the argument that is the same for all rows; it is the first one.
    """
    function = _parsed(text)
    names = [argument.arg for argument in function.args.args]
    order = [shared, *(one for one in names if one != shared)]

    def write(builder: ir.IRBuilder, rows: list[_Row]) -> None:
        data = {one: row.data for one, row in zip(order, rows, strict=True)}
        count = builder.extract_value(rows[1].shape, 0)
        lengths = [builder.extract_value(row.shape, 1) for row in rows[1:]]
        called = written_for_rows(builder.module, function, shared)
        builder.call(called, [*(data[one] for one in names), count, *lengths])

    return _made(name, order, {one: _ROW if one == shared else _ROWS for one in order}, write)


def _parsed(text: str) -> ast.FunctionDef:
    (function,) = ast.parse(text).body
    assert isinstance(function, ast.FunctionDef)
    return function


def _made(
    name: str, names: list[str], kinds: dict[str, str], write: Callable[[ir.IRBuilder, list[_Row]], None]
) -> Callable[..., None]:
    """Return the function for code that numba compiles.

    Args:
        name: of it.
        names: of its arguments.
        kinds: numba's word for the type of each.
        write: writes the call for arrays.
    """
    from numba import types
    from numba.extending import intrinsic

    def of(taken: tuple["Type", ...]) -> "tuple[Signature, Callable[..., ir.Value]] | None":
        """Return what numba asks for: the types, and who writes the call; None for types that do not fit."""
        if [str(one) for one in taken] != [kinds[one] for one in names]:
            return None

        def call(
            context: _Context, builder: ir.IRBuilder, signature: "Signature", arguments: list[ir.Value]
        ) -> ir.Value:
            rows = zip(signature.args, arguments, strict=True)
            write(builder, [context.make_array(kind)(context, builder, row) for kind, row in rows])
            return context.get_dummy_value()

        return types.void(*taken), call

    # numba counts the arguments of the function that it is given
    row = ", ".join(names)
    scope: dict[str, Callable[..., object]] = {"of": of}
    exec(f"def {name}(context_, {row}): return of(({row},))", scope)  # our own source
    return cast("Callable[..., None]", intrinsic(scope[name]))


def _written(module: ir.Module, function: ast.FunctionDef, names: list[str]) -> ir.Function:
    """Return the function in a module; it is written down where it is not there yet."""
    symbol = f"straight_line.{function.name}"
    known = module.globals.get(symbol)
    if known is not None:
        return known
    row = REAL.as_pointer()
    made = ir.Function(module, ir.FunctionType(ir.VoidType(), [row] * len(names)), symbol)
    made.linkage = "internal"
    lines = Instructions(ir.IRBuilder(made.append_basic_block()), dict(zip(names, made.args, strict=True)))
    for line in function.body:
        lines.write(line)
    lines.builder.ret_void()
    return made
