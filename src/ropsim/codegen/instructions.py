"""Lines of straight-line source as instructions of LLVM."""

import ast

from llvmlite import ir

REAL = ir.DoubleType()
_OPERATIONS = {ast.Add: "fadd", ast.Sub: "fsub", ast.Mult: "fmul", ast.Div: "fdiv"}
_FOREIGN = ("sin", "cos", "tanh")
"""Functions of the C library, which Python's `math` calls, too."""
_COMPARED = {"min": "<", "max": ">"}
_INTRINSIC = {"abs": "llvm.fabs", "sqrt": "llvm.sqrt"}
"""Functions that are an instruction of the processor, the result to the last bit."""
_CALLED = {"float", *_INTRINSIC, *_COMPARED, *_FOREIGN}


class Instructions:
    """The function that is being written.

    Args:
        builder: at its end.
        arrays: address of the first element by name.
    """

    def __init__(self, builder: ir.IRBuilder, arrays: dict[str, ir.Value]) -> None:
        self.builder = builder
        self._arrays = arrays
        self._locals: dict[str, ir.Value] = {}

    def write(self, line: ast.stmt) -> None:
        """Write a line: a local name or a result gets its value.

        Raises:
            ValueError: it is not straight-line code.
        """
        match line:
            case ast.Pass():
                return
            case ast.Assign(targets=[ast.Name(id=name)], value=value):
                self._locals[name] = self._value(value)
            case ast.Assign(targets=[ast.Subscript() as place], value=value):
                self.builder.store(self._value(value), self._address(place))
            case _:
                raise _unknown(line)

    def _value(self, node: ast.expr) -> ir.Value:
        match node:
            case ast.Name(id=name) if name in self._locals:
                return self._locals[name]
            case ast.Constant(value=float(number)):
                return ir.Constant(REAL, number)
            case ast.Subscript():
                return self.builder.load(self._address(node))
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                return self.builder.fneg(self._value(operand))
            case ast.BinOp(left=left, op=op, right=right) if type(op) in _OPERATIONS:
                write = getattr(self.builder, _OPERATIONS[type(op)])
                return write(self._value(left), self._value(right))
            case ast.Call(func=ast.Attribute(attr=name) | ast.Name(id=name), args=args) if name in _CALLED:
                return self._call(name, [self._value(one) for one in args])
            case _:
                raise _unknown(node)

    def _call(self, name: str, args: list[ir.Value]) -> ir.Value:
        if name == "float":
            return args[0]
        if name in _INTRINSIC:
            return self.builder.call(self._module.declare_intrinsic(_INTRINSIC[name], [REAL]), args)
        if name in _COMPARED:  # as Python has it: the first one unless the second one is smaller, or greater
            first, second = args
            return self.builder.select(
                self.builder.fcmp_ordered(_COMPARED[name], second, first), second, first
            )
        foreign = self._module.globals.get(name)
        if foreign is None:
            foreign = ir.Function(self._module, ir.FunctionType(REAL, [REAL]), name)
        return self.builder.call(foreign, args)

    @property
    def _module(self) -> ir.Module:
        return self.builder.module

    def _address(self, place: ast.Subscript) -> ir.Value:
        match place:
            case ast.Subscript(value=ast.Name(id=name), slice=ast.Constant(value=int(number))):
                return self.builder.gep(self._arrays[name], [ir.Constant(ir.IntType(64), number)])
            case _:
                raise _unknown(place)


def _unknown(node: ast.AST) -> ValueError:
    return ValueError(f"`{ast.unparse(node)}` is not straight-line code")
