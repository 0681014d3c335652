"""Straight lines of Python for eight columns at a time, as instructions of LLVM."""

import ast
from collections.abc import Callable

from llvmlite import ir

from ropsim.codegen.instructions import REAL, WHOLE
from ropsim.codegen.intrinsics import COUNT, NUMBER, ROW, ROWS, Row, made
from ropsim.codegen.lane_values import LANES, VECTOR, LaneValues

_MASK = ir.VectorType(ir.IntType(1), LANES)
_ALIGNED = ir.Constant(ir.IntType(32), 8)
"""Bytes."""


class _Lines(LaneValues):
    """Lines in which arrays are rows and the lanes their columns.

    Args:
        builder: at the end of the function.
        rows: address of each row in the first of the columns, by name and number.
        values: of scalars by name.
        inside: the lanes that are columns.
    """

    def __init__(
        self,
        builder: ir.IRBuilder,
        rows: Callable[[str, int], ir.Value],
        values: dict[str, ir.Value],
        inside: ir.Value,
    ) -> None:
        super().__init__(builder, {}, values)
        self._row, self._inside = rows, inside

    def _got(self, array: str, number: int) -> ir.Value:
        kind = ir.FunctionType(VECTOR, [REAL.as_pointer(), ir.IntType(32), _MASK, VECTOR])
        load = self.builder.module.declare_intrinsic(f"llvm.masked.load.{self.suffix}.p0", (), kind)
        return self.builder.call(load, [self._row(array, number), _ALIGNED, self._inside, self.number(0.0)])

    def _put(self, value: ir.Value, array: str, number: int) -> None:
        kind = ir.FunctionType(ir.VoidType(), [VECTOR, REAL.as_pointer(), ir.IntType(32), _MASK])
        store = self.builder.module.declare_intrinsic(f"llvm.masked.store.{self.suffix}.p0", (), kind)
        self.builder.call(store, [value, self._row(array, number), _ALIGNED, self._inside])


def column_lines(text: str, known: dict[str, float]) -> Callable[..., None]:
    """Return a function for code that numba compiles, see `ropsim.codegen.columns`.

    Args:
        text: its source.
        known: floats by name.
    """
    (function,) = ast.parse(text).body
    assert isinstance(function, ast.FunctionDef)
    names = [argument.arg for argument in function.args.args]
    (loop,) = [line for line in function.body if isinstance(line, ast.For)]
    assert isinstance(loop.target, ast.Name)
    lines = [_Numbered(loop.target.id).visit(line) for line in loop.body]

    def write(builder: ir.IRBuilder, values: dict[str, ir.Value], arrays: dict[str, Row]) -> None:
        count = values.pop(names[0])
        before = builder.block
        turn, end = (builder.append_basic_block(name) for name in ("columns", "end"))
        builder.cbranch(builder.icmp_signed(">", count, ir.Constant(WHOLE, 0)), turn, end)
        builder.position_at_end(turn)
        first = builder.phi(WHOLE)
        spread = LaneValues(builder, {})
        scalars = {name: spread.number(value) for name, value in known.items()}
        scalars |= {name: spread.spread(value) for name, value in values.items()}
        wholes = ir.VectorType(WHOLE, LANES)
        left = ir.Constant(wholes, ir.Undefined)
        for lane in range(LANES):
            left = spread.with_lane(left, lane, builder.sub(count, first))
        inside = builder.icmp_signed("<", ir.Constant(wholes, list(range(LANES))), left)

        def row(name: str, number: int) -> ir.Value:
            array, place = arrays[name], first
            if number:
                length = builder.extract_value(array.shape, 1)
                place = builder.add(first, builder.mul(length, ir.Constant(WHOLE, number)))
            return builder.gep(array.data, [place])

        writer = _Lines(builder, row, scalars, inside)
        for line in lines:
            writer.write(line)
        following = builder.add(first, ir.Constant(WHOLE, LANES))
        first.add_incoming(ir.Constant(WHOLE, 0), before)
        first.add_incoming(following, builder.block)
        builder.cbranch(builder.icmp_signed("<", following, count), turn, end)
        builder.position_at_end(end)

    takes = {name: (NUMBER, ROW, ROWS) for name in names[1:]}
    return made(function.name, {names[0]: (COUNT,), **takes}, write)


class _Numbered(ast.NodeTransformer):
    """Writes `x[2]` for `x[2, j]` and `x[0]` for `x[j]`: the number of the row.

    Args:
        column: name of the number of a column.
    """

    def __init__(self, column: str) -> None:
        self._column = column

    def visit_Subscript(self, node: ast.Subscript) -> ast.Subscript:  # as ast calls it
        """Return the subscript with the number of the row alone."""
        match node.slice:
            case ast.Name(id=self._column):
                number = ast.Constant(0)
            case ast.Tuple(elts=[ast.Constant(value=int()) as number, ast.Name(id=self._column)]):
                pass
            case _:
                raise ValueError(f"`{ast.unparse(node)}` is none of a row at column {self._column}")
        return ast.Subscript(node.value, number, node.ctx)
