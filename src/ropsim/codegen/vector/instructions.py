"""Lines of straight-line source as instructions of LLVM."""

import ast

from llvmlite import ir

REAL = ir.DoubleType()
WHOLE = ir.IntType(64)
LANES = 8
"""Numbers in a vector; where a processor takes four at a time, LLVM makes two instructions of one."""
VECTOR = ir.VectorType(REAL, LANES)
_LANE = ir.IntType(32)
_OPERATIONS = {ast.Add: "fadd", ast.Sub: "fsub", ast.Mult: "fmul", ast.Div: "fdiv"}
_FOREIGN = ("sin", "cos", "exp", "tanh", "atan2", "pow")
"""Functions of the C library, which Python's `math` also calls."""
_COMPARED = {"min": "<", "max": ">"}
_CONDITIONS = {ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=", ast.Eq: "=="}
_INTRINSIC = {"abs": "llvm.fabs", "sqrt": "llvm.sqrt", "rint": "llvm.rint"}
"""Functions that are an instruction of the processor, the result to the last bit."""
_CALLED = {"float", *_INTRINSIC, *_COMPARED, *_FOREIGN}


class Instructions:
    """The function that is being written.

    Args:
        builder: at its end.
        arrays: address of the first element by name.
        values: values of names that represent themselves.
    """

    kind: ir.Type = REAL
    """Of values."""
    suffix = "f64"
    """LLVM's word for it."""

    def __init__(
        self, builder: ir.IRBuilder, arrays: dict[str, ir.Value], values: dict[str, ir.Value] | None = None
    ) -> None:
        self.builder = builder
        self._arrays = arrays
        self._locals = dict(values or {})

    def write(self, line: ast.stmt) -> None:
        """Write a line: a local name or a result gets its value.

        Raises:
            ValueError: it is not straight-line code.
        """
        match line:
            case ast.Pass():
                return
            case ast.Assign(targets=[ast.Name(id=name)], value=value):
                self._locals[name] = self.value(value)
            case ast.Assign(targets=[ast.Subscript() as place], value=value):
                self._put(self.value(value), *_place(place))
            case _:
                raise _unknown(line)

    def value(self, node: ast.expr) -> ir.Value:
        """Return the value of an expression.

        Raises:
            ValueError: it is not straight-line code.
        """
        match node:
            case ast.Name(id=name) if name in self._locals:
                return self._locals[name]
            case ast.Constant(value=float(number)):
                return self.number(number)
            case ast.Subscript():
                return self._got(*_place(node))
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                return self.builder.fneg(self.value(operand))
            case ast.BinOp(left=left, op=op, right=right) if type(op) in _OPERATIONS:
                write = getattr(self.builder, _OPERATIONS[type(op)])
                return write(self.value(left), self.value(right))
            case ast.IfExp(test=ast.Compare(left=left, ops=[op], comparators=[right])) if (
                type(op) in _CONDITIONS
            ):
                holds = self.builder.fcmp_ordered(_CONDITIONS[type(op)], self.value(left), self.value(right))
                return self.builder.select(holds, self.value(node.body), self.value(node.orelse))
            case ast.Call(func=ast.Attribute(attr=name) | ast.Name(id=name), args=args) if name in _CALLED:
                return self._call(name, [self.value(one) for one in args])
            case _:
                raise _unknown(node)

    def number(self, number: float) -> ir.Value:
        """Return a number as a value."""
        return ir.Constant(REAL, number)

    def foreign(self, name: str, values: list[ir.Value]) -> ir.Value:
        """Return the result of a function of the C library."""
        found = self.builder.module.globals.get(name)
        if found is None:
            found = ir.Function(self.builder.module, ir.FunctionType(REAL, [REAL] * len(values)), name)
        return self.builder.call(found, values)

    def intrinsic(self, name: str, values: list[ir.Value]) -> ir.Value:
        """Return the result of an instruction of the processor."""
        kind = ir.FunctionType(self.kind, [self.kind] * len(values))
        return self.builder.call(
            self.builder.module.declare_intrinsic(f"{name}.{self.suffix}", (), kind), values
        )

    def _call(self, name: str, args: list[ir.Value]) -> ir.Value:
        if name == "float":
            return args[0]
        if name in _INTRINSIC:
            return self.intrinsic(_INTRINSIC[name], args)
        if name in _COMPARED:  # as Python has it: the first one unless the second one is smaller, or greater
            first, second = args
            return self.builder.select(
                self.builder.fcmp_ordered(_COMPARED[name], second, first), second, first
            )
        return self._elementary(name, args)

    def _elementary(self, name: str, args: list[ir.Value]) -> ir.Value:
        return self.foreign(name, args)

    def _got(self, array: str, number: int) -> ir.Value:
        return self.builder.load(self._address(self._arrays[array], number))

    def _put(self, value: ir.Value, array: str, number: int) -> None:
        self.builder.store(value, self._address(self._arrays[array], number))

    def _address(self, first: ir.Value, number: int) -> ir.Value:
        return self.builder.gep(first, [ir.Constant(WHOLE, number)])


class LaneValues(Instructions):
    """Lines whose values are vectors."""

    kind = VECTOR
    suffix = f"v{LANES}f64"

    def number(self, number: float) -> ir.Value:
        """Return a number in all lanes."""
        return ir.Constant(VECTOR, [number] * LANES)

    def lane(self, value: ir.Value, lane: int) -> ir.Value:
        """Return the number in one lane."""
        return self.builder.extract_element(value, ir.Constant(_LANE, lane))

    def with_lane(self, value: ir.Value, lane: int, number: ir.Value) -> ir.Value:
        """Return a vector with another number in one lane."""
        return self.builder.insert_element(value, number, ir.Constant(_LANE, lane))

    def spread(self, number: ir.Value) -> ir.Value:
        """Return a value in all lanes."""
        value = ir.Constant(VECTOR, ir.Undefined)
        for lane in range(LANES):
            value = self.with_lane(value, lane, number)
        return value


def _place(node: ast.Subscript) -> tuple[str, int]:
    """Return the name of an array and the number of one of its elements."""
    match node:
        case ast.Subscript(value=ast.Name(id=name), slice=ast.Constant(value=int(number))):
            return name, number
        case _:
            raise _unknown(node)


def _unknown(node: ast.AST) -> ValueError:
    return ValueError(f"`{ast.unparse(node)}` is not straight-line code")
