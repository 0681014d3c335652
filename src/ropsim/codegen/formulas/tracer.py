"""Symbolic scalars: run a formula once with them and get its operations as a graph.

Operations fold where the result is certain (constants, 0, 1, -1, double signs) and equal
operations become one node, so that zeros and right angles of an arm cost nothing at run time.
"""

import math
from collections.abc import Callable, Mapping, Sequence

UNARY: Mapping[str, Callable[[float], float]] = {
    "neg": lambda x: -x,
    "abs": abs,
    "sin": math.sin,
    "cos": math.cos,
    "exp": math.exp,
    "tanh": math.tanh,
    "sqrt": math.sqrt,
}


class Tracer:
    """The graph under construction; every scalar of one formula belongs to the same tracer."""

    def __init__(self) -> None:
        self._nodes: dict[tuple[object, ...], Scalar] = {}

    def constant(self, value: float) -> "Scalar":
        """Return the scalar of a number; -0.0 counts as 0.0."""
        value = float(value) + 0.0
        return self._node("const", (), value)

    def variable(self, text: str) -> "Scalar":
        """Return the scalar that the generated code reads from `text`, such as `q[2]`."""
        return self._node("var", (), text)

    def variables(self, name: str, count: int) -> list["Scalar"]:
        """Return the scalars `name[0]` to `name[count - 1]`."""
        return [self.variable(f"{name}[{k}]") for k in range(count)]

    def operation(self, op: str, *args: "Scalar") -> "Scalar":
        """Return the node of an operation, the same one for the same arguments."""
        return self._node(op, args, None)

    def _node(self, op: str, args: tuple["Scalar", ...], leaf: str | float | None) -> "Scalar":
        key = (op, leaf, *(arg.index for arg in args))
        node = self._nodes.get(key)
        if node is None:
            node = Scalar(self, op, args, leaf, len(self._nodes))
            self._nodes[key] = node
        return node


class Scalar:
    """A number that is not known yet.

    Attributes:
        tracer: the graph it belongs to.
        index: order of creation; arguments always come before their operation.
        op: `const`, `var`, `add`, `sub`, `mul`, `div`, `min`, `max`, `pow` or a key of `UNARY`.
        args: operands.
        text: where a variable is read from.
        value: the number of a constant, else None.
    """

    __slots__ = ("args", "index", "op", "text", "tracer", "value")

    def __init__(
        self, tracer: Tracer, op: str, args: tuple["Scalar", ...], leaf: str | float | None, index: int
    ) -> None:
        self.tracer = tracer
        self.index = index
        self.op = op
        self.args = args
        self.text = leaf if isinstance(leaf, str) else ""
        self.value = leaf if isinstance(leaf, float) else None

    def __add__(self, other: "Scalar | float") -> "Scalar":
        b = self._lift(other)
        if self.value is not None and b.value is not None:
            return self.tracer.constant(self.value + b.value)
        if self.value == 0.0:
            return b
        if b.value == 0.0:
            return self
        if b.op == "neg":
            return self - b.args[0]
        if self.op == "neg":
            return b - self.args[0]
        return self.tracer.operation("add", *_ordered(self, b))

    def __radd__(self, other: float) -> "Scalar":
        return self + other

    def __sub__(self, other: "Scalar | float") -> "Scalar":
        b = self._lift(other)
        if self.value is not None and b.value is not None:
            return self.tracer.constant(self.value - b.value)
        if self is b:
            return self.tracer.constant(0.0)
        if b.value == 0.0:
            return self
        if self.value == 0.0:
            return -b
        if b.op == "neg":
            return self + b.args[0]
        if self.op == "neg":
            return -(self.args[0] + b)
        return self.tracer.operation("sub", self, b)

    def __rsub__(self, other: float) -> "Scalar":
        return self._lift(other) - self

    def __mul__(self, other: "Scalar | float") -> "Scalar":
        b = self._lift(other)
        if self.value is not None and b.value is not None:
            return self.tracer.constant(self.value * b.value)
        for x, y in ((self, b), (b, self)):
            if x.value == 0.0:
                return x
            if x.value == 1.0:
                return y
            if x.op == "neg":
                return -(x.args[0] * y)
            if x.value is not None and x.value < 0.0:
                return -(-x * y)
        return self.tracer.operation("mul", *_ordered(self, b))

    def __rmul__(self, other: float) -> "Scalar":
        return self * other

    def __truediv__(self, other: "Scalar | float") -> "Scalar":
        b = self._lift(other)
        if self.value is not None and b.value is not None and b.value != 0.0:
            return self.tracer.constant(self.value / b.value)
        if self.value == 0.0:
            return self
        if b.value == 1.0:
            return self
        if b.op == "neg":
            return -(self / b.args[0])
        if self.op == "neg":
            return -(self.args[0] / b)
        return self.tracer.operation("div", self, b)

    def __rtruediv__(self, other: float) -> "Scalar":
        return self._lift(other) / self

    def __neg__(self) -> "Scalar":
        if self.op == "neg":
            return self.args[0]
        if self.op == "sub":
            return self.args[1] - self.args[0]
        return self._unary("neg")

    def __abs__(self) -> "Scalar":
        return self.args[0].__abs__() if self.op == "neg" else self._unary("abs")

    def _unary(self, op: str) -> "Scalar":
        if self.value is not None:
            return self.tracer.constant(UNARY[op](self.value))
        return self.tracer.operation(op, self)

    def _lift(self, other: "Scalar | float") -> "Scalar":
        return other if isinstance(other, Scalar) else self.tracer.constant(other)


def sin(x: Scalar) -> Scalar:
    """Return the sine of an angle [rad]."""
    return x._unary("sin")


def cos(x: Scalar) -> Scalar:
    """Return the cosine of an angle [rad]."""
    return x._unary("cos")


def exp(x: Scalar) -> Scalar:
    """Return the exponential function."""
    return x._unary("exp")


def tanh(x: Scalar) -> Scalar:
    """Return the hyperbolic tangent."""
    return x._unary("tanh")


def sqrt(x: Scalar) -> Scalar:
    """Return the square root of a number that is not negative, to the last bit."""
    return x._unary("sqrt")


def minimum(a: Scalar, b: Scalar) -> Scalar:
    """Return the smaller of two numbers as Python's `min` does: the first unless the second is smaller."""
    return a.tracer.operation("min", a, b)


def maximum(a: Scalar, b: Scalar) -> Scalar:
    """Return the larger of two numbers as Python's `max` does: the first unless the second is larger."""
    return a.tracer.operation("max", a, b)


def power(base: Scalar, exponent: Scalar) -> Scalar:
    """Return a number that is not negative to a power that is positive."""
    return base.tracer.operation("pow", base, exponent)


def reachable(roots: Sequence[Scalar]) -> list[Scalar]:
    """Return the nodes that the roots need, the roots included; arguments first."""
    found: dict[int, Scalar] = {}
    stack = list(roots)
    while stack:
        node = stack.pop()
        if node.index not in found:
            found[node.index] = node
            stack.extend(node.args)
    return [found[index] for index in sorted(found)]


def _ordered(a: Scalar, b: Scalar) -> tuple[Scalar, Scalar]:
    """Return constants first, then in order of creation: either way round the result is the same, exactly."""
    return (a, b) if (a.value is None, a.index) <= (b.value is None, b.index) else (b, a)
