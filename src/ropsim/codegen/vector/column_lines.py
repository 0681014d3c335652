"""Straight lines of Python for eight columns at a time, as instructions of LLVM."""

import ast
from collections.abc import Callable

from llvmlite import ir

from ropsim.codegen.machine.numba_stages import COUNT, NUMBER, ROW, ROWS, Row, instructions
from ropsim.codegen.vector.instructions import LANES, REAL, VECTOR, WHOLE, LaneValues
from ropsim.codegen.vector.lane_functions import LaneFunctions

_MASK = ir.VectorType(ir.IntType(1), LANES)
_BYTES = ir.IntType(32)
_ALIGNED = 8
"""Bytes."""


class _Lines(LaneFunctions):
    """Lines in which arrays are rows and the lanes their columns.

    Args:
        builder: at the end of the function.
        rows: address of each row in the first of the columns, by name and number.
        values: of scalars by name.
        inside: the lanes that are columns; None where all are.
    """

    def __init__(
        self,
        builder: ir.IRBuilder,
        rows: Callable[[str, int], ir.Value],
        values: dict[str, ir.Value],
        inside: ir.Value | None,
    ) -> None:
        super().__init__(builder, {}, values)
        self._row, self._inside = rows, inside

    def _got(self, array: str, number: int) -> ir.Value:
        row = self._row(array, number)
        if self._inside is None:
            return self.builder.load(self.builder.bitcast(row, VECTOR.as_pointer()), align=_ALIGNED)
        kind = ir.FunctionType(VECTOR, [REAL.as_pointer(), _BYTES, _MASK, VECTOR])
        load = self.builder.module.declare_intrinsic(f"llvm.masked.load.{self.suffix}.p0", (), kind)
        return self.builder.call(load, [row, _BYTES(_ALIGNED), self._inside, self.number(0.0)])

    def _put(self, value: ir.Value, array: str, number: int) -> None:
        row = self._row(array, number)
        if self._inside is None:
            self.builder.store(value, self.builder.bitcast(row, VECTOR.as_pointer()), align=_ALIGNED)
            return
        kind = ir.FunctionType(ir.VoidType(), [VECTOR, REAL.as_pointer(), _BYTES, _MASK])
        store = self.builder.module.declare_intrinsic(f"llvm.masked.store.{self.suffix}.p0", (), kind)
        self.builder.call(store, [value, row, _BYTES(_ALIGNED), self._inside])


def column_lines(text: str, known: dict[str, float], places: dict[str, int]) -> Callable[..., None]:
    """Return a function for code that numba compiles, see `ropsim.codegen.vector.columns`.

    Args:
        text: its source.
        known: floats by name.
        places: whole numbers by name.

    Raises:
        ValueError: the lines do not have the form of columns, or a value shared by all columns belongs to an
            array that they change, or, for the generated function, to one with two axes.
    """
    (function,) = ast.parse(text).body
    assert isinstance(function, ast.FunctionDef)
    names = [argument.arg for argument in function.args.args]
    (loop,) = [line for line in function.body if isinstance(line, ast.For)]
    assert isinstance(loop.target, ast.Name)
    numbered = _Numbered(loop.target.id, places)
    lines = [numbered.visit(line) for line in loop.body]
    for name, (array, _) in numbered.shared.items():
        if array in numbered.changed:
            raise ValueError(f"`{name}` is the same for all columns, which change `{array}`")

    def write(builder: ir.IRBuilder, values: dict[str, ir.Value], arrays: dict[str, Row]) -> None:
        count = values.pop(names[0])
        before = builder.block
        whole, rest, part, end = (
            builder.append_basic_block(name) for name in ("whole", "rest", "part", "end")
        )
        spread = LaneValues(builder, {})
        scalars = {name: spread.number(value) for name, value in known.items()}
        scalars |= {name: spread.spread(value) for name, value in values.items()}
        for name, (array, place) in numbered.shared.items():
            if len(arrays[array].shape.type) != 1:
                raise ValueError(f"`{name}` is no number: `{array}` has two axes")
            address = builder.gep(arrays[array].data, [ir.Constant(WHOLE, place)])
            scalars[name] = spread.spread(builder.load(address))

        def turn(first: ir.Value, inside: ir.Value | None) -> None:
            def row(name: str, number: int) -> ir.Value:
                array, place = arrays[name], first
                if number:
                    length = builder.extract_value(array.shape, 1)
                    place = builder.add(first, builder.mul(length, ir.Constant(WHOLE, number)))
                return builder.gep(array.data, [place])

            writer = _Lines(builder, row, scalars, inside)
            for line in lines:
                writer.write(line)

        none, lanes = ir.Constant(WHOLE, 0), ir.Constant(WHOLE, LANES)
        builder.cbranch(builder.icmp_signed(">=", count, lanes), whole, rest)
        builder.position_at_end(whole)
        first = builder.phi(WHOLE)
        turn(first, None)
        following = builder.add(first, lanes)
        first.add_incoming(none, before)
        first.add_incoming(following, builder.block)
        done = builder.block
        builder.cbranch(builder.icmp_signed("<=", builder.add(following, lanes), count), whole, rest)
        builder.position_at_end(rest)
        last = builder.phi(WHOLE)
        last.add_incoming(none, before)
        last.add_incoming(following, done)
        builder.cbranch(builder.icmp_signed("<", last, count), part, end)
        builder.position_at_end(part)
        wholes = ir.VectorType(WHOLE, LANES)
        left = spread.with_lane(ir.Constant(wholes, ir.Undefined), 0, builder.sub(count, last))
        left = builder.shuffle_vector(left, left, ir.Constant(ir.VectorType(_BYTES, LANES), [0] * LANES))
        turn(last, builder.icmp_signed("<", ir.Constant(wholes, list(range(LANES))), left))
        builder.branch(end)
        builder.position_at_end(end)

    takes = {name: (NUMBER, ROW, ROWS) for name in names[1:]}
    return instructions(function.name, {names[0]: (COUNT,), **takes}, write)


class _Numbered(ast.NodeTransformer):
    """Writes `x[2]` for `x[2, j]` and `x[0]` for `x[j]`: the number of the row.

    Args:
        column: name of the number of a column.
        known: whole numbers by name.

    Attributes:
        shared: array and place of numbers that are the same for all columns, by names that are made for them.
        changed: names of arrays that are written.
    """

    def __init__(self, column: str, known: dict[str, int]) -> None:
        self._column, self._known = column, known
        self.shared: dict[str, tuple[str, int]] = {}
        self.changed: set[str] = set()

    def visit_Subscript(self, node: ast.Subscript) -> ast.Subscript | ast.Name:  # as ast calls it
        """Return the subscript with the number of the row alone, or the name of the shared value."""
        if isinstance(node.ctx, ast.Store) and isinstance(node.value, ast.Name):
            self.changed.add(node.value.id)
        match node.slice:
            case ast.Name(id=self._column):
                return ast.Subscript(node.value, ast.Constant(0), node.ctx)
            case ast.Tuple(elts=[row, ast.Name(id=self._column)]):
                number = self._number(row)
                if number is not None:
                    return ast.Subscript(node.value, ast.Constant(number), node.ctx)
            case place if isinstance(node.value, ast.Name) and isinstance(node.ctx, ast.Load):
                number = self._number(place)
                if number is not None:
                    name = f"{node.value.id}[{number}]"
                    self.shared[name] = node.value.id, number
                    return ast.Name(name)
        raise ValueError(f"`{ast.unparse(node)}` is none of a row at column {self._column}")

    def _number(self, node: ast.expr) -> int | None:
        """Return a whole number, a known one or the sum of two; None for others."""
        match node:
            case ast.Constant(value=int(number)):
                return number
            case ast.Name(id=name):
                return self._known.get(name)
            case ast.BinOp(left=left, op=ast.Add(), right=right):
                one, other = self._number(left), self._number(right)
                return None if one is None or other is None else one + other
        return None
