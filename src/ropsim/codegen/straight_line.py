"""Straight-line source to instructions of LLVM, without numba's stages for programs of any kind.

A formula of hundreds of lines has one type and no branch: there is nothing to find out about it. Written
down directly it is compiled in a third of the time.
"""

import ast
from collections.abc import Callable

from llvmlite import ir

from ropsim.codegen.instructions import REAL, Instructions
from ropsim.codegen.intrinsics import ROW, ROWS, Row, made
from ropsim.codegen.lanes import written_for_rows


def straight_line(text: str) -> Callable[..., None]:
    """Return a function for code that numba compiles; nobody else can call it.

    Args:
        text: of a function of one-dimensional arrays of float64, as `emit` writes it.
    """
    function = _parsed(text)
    names = [argument.arg for argument in function.args.args]

    def write(builder: ir.IRBuilder, _scalars: dict[str, ir.Value], rows: dict[str, Row]) -> None:
        builder.call(_written(builder.module, function, names), [rows[one].data for one in names])

    return made(function.name, {one: (ROW,) for one in names}, write)


def straight_rows(text: str, name: str, shared: str) -> Callable[..., None]:
    """Return a function of arrays of rows for code that numba compiles, see `ropsim.codegen.row_by_row`.

    Args:
        text: of the function of one row, as for `straight_line`.
        name: of the function.
        shared: name of the argument that is the same for all rows; it is the first one.
    """
    function = _parsed(text)
    names = [argument.arg for argument in function.args.args]
    others = [one for one in names if one != shared]

    def write(builder: ir.IRBuilder, _scalars: dict[str, ir.Value], rows: dict[str, Row]) -> None:
        count = builder.extract_value(rows[others[0]].shape, 0)
        lengths = [builder.extract_value(rows[one].shape, 1) for one in others]
        called = written_for_rows(builder.module, function, shared)
        builder.call(called, [*(rows[one].data for one in names), count, *lengths])

    return made(name, {shared: (ROW,)} | {one: (ROWS,) for one in others}, write)


def _parsed(text: str) -> ast.FunctionDef:
    (function,) = ast.parse(text).body
    assert isinstance(function, ast.FunctionDef)
    return function


def _written(module: ir.Module, function: ast.FunctionDef, names: list[str]) -> ir.Function:
    """Return the function in a module; it is written down where it is not there yet."""
    symbol = f"straight_line.{function.name}"
    known = module.globals.get(symbol)
    if known is not None:
        return known
    row = REAL.as_pointer()
    written = ir.Function(module, ir.FunctionType(ir.VoidType(), [row] * len(names)), symbol)
    written.linkage = "internal"
    lines = Instructions(
        ir.IRBuilder(written.append_basic_block()), dict(zip(names, written.args, strict=True))
    )
    for line in function.body:
        lines.write(line)
    lines.builder.ret_void()
    return written
