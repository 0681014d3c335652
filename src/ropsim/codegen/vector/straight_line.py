"""Straight-line source to instructions of LLVM, without numba's stages for programs of any kind.

A formula of hundreds of lines has a single type and no branch. Written down directly it is compiled in a
third of the time. For arrays of rows each of its values becomes a vector, a lane for each row: processors
work on four or eight numbers with one instruction, and no row depends on another one.
"""

import ast
from collections.abc import Callable

from llvmlite import ir

from ropsim.codegen.machine.numba_stages import ROW, ROWS, Row, instructions
from ropsim.codegen.vector.instructions import LANES, REAL, VECTOR, WHOLE, Instructions
from ropsim.codegen.vector.lane_functions import LaneFunctions


def straight_line(text: str) -> Callable[..., None]:
    """Return a function for code that numba compiles; other code cannot call it.

    Args:
        text: of a function of one-dimensional arrays of float64, as `emit` writes it.
    """
    function = _parsed(text)
    names = [argument.arg for argument in function.args.args]

    def write(builder: ir.IRBuilder, _scalars: dict[str, ir.Value], rows: dict[str, Row]) -> None:
        builder.call(_written(builder.module, function, names), [rows[one].data for one in names])

    return instructions(function.name, {one: (ROW,) for one in names}, write)


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
        called = _written_for_rows(builder.module, function, shared)
        builder.call(called, [*(rows[one].data for one in names), count, *lengths])

    return instructions(name, {shared: (ROW,)} | {one: (ROWS,) for one in others}, write)


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


class _Lanes(LaneFunctions):
    """The lines of a function whose arrays are rows of eight lanes, except one that they share.

    Args:
        builder: at the end of the function.
        rows: addresses of the first element of each lane by name.
        shared: address of the first element of the array that is the same for all of them, by name.
    """

    def __init__(
        self, builder: ir.IRBuilder, rows: dict[str, list[ir.Value]], shared: dict[str, ir.Value]
    ) -> None:
        super().__init__(builder, shared)
        self._rows = rows
        self._read: dict[tuple[str, int], ir.Value] = {}

    def _got(self, array: str, number: int) -> ir.Value:
        if (array, number) not in self._read:
            rows = self._rows.get(array)
            if rows is None:
                value = self.spread(self.builder.load(self._address(self._arrays[array], number)))
            else:
                value = ir.Constant(VECTOR, ir.Undefined)
                for lane, row in enumerate(rows):
                    value = self.with_lane(value, lane, self.builder.load(self._address(row, number)))
            self._read[array, number] = value
        return self._read[array, number]

    def _put(self, value: ir.Value, array: str, number: int) -> None:
        for lane, row in enumerate(self._rows[array]):
            self.builder.store(self.lane(value, lane), self._address(row, number))


def _written_for_rows(module: ir.Module, function: ast.FunctionDef, shared: str) -> ir.Function:
    """Return the function of addresses, the number of rows and the length of each; written where it is not.

    Args:
        module: in which it stands.
        function: of one row.
        shared: name of the argument that is the same for all of them.
    """
    names = [argument.arg for argument in function.args.args]
    symbol = f"rows.{function.name}"
    known = module.globals.get(symbol)
    if known is not None:
        return known
    kind = ir.FunctionType(ir.VoidType(), [REAL.as_pointer()] * len(names) + [WHOLE] * len(names))
    made = ir.Function(module, kind, symbol)
    made.linkage = "internal"
    arrays = dict(zip(names, made.args, strict=False))
    count, *lengths = made.args[len(names) :]
    start, turn, end = (made.append_basic_block(name) for name in ("start", "turn", "end"))
    builder = ir.IRBuilder(start)
    builder.cbranch(builder.icmp_signed(">", count, ir.Constant(WHOLE, 0)), turn, end)
    builder.position_at_end(turn)
    first = builder.phi(WHOLE)
    last = builder.sub(count, ir.Constant(WHOLE, 1))
    numbers = []
    for lane in range(LANES):  # behind the last row all lanes write that one
        row = builder.add(first, ir.Constant(WHOLE, lane))
        numbers.append(builder.select(builder.icmp_signed("<", row, last), row, last))
    own = zip((name for name in names if name != shared), lengths, strict=True)
    rows = {
        name: [builder.gep(arrays[name], [builder.mul(row, length)]) for row in numbers]
        for name, length in own
    }
    lines: Instructions = _Lanes(builder, rows, {shared: arrays[shared]})
    for line in function.body:
        lines.write(line)
    following = builder.add(first, ir.Constant(WHOLE, LANES))
    first.add_incoming(ir.Constant(WHOLE, 0), start)
    first.add_incoming(following, builder.block)
    builder.cbranch(builder.icmp_signed("<", following, count), turn, end)
    builder.position_at_end(end)
    builder.ret_void()
    return made
