"""Derivatives of traced formulas, operation by operation (forward differentiation)."""

from collections.abc import Mapping, Sequence

from ropsim.codegen.formulas.tracer import Scalar, cos, reachable, sin


def rates_of(values: Sequence[Scalar], rates: Mapping[Scalar, Scalar]) -> list[Scalar]:
    """Return how fast scalars of one tracer change.

    Args:
        values: sums, products, quotients, roots and elementary functions of variables; at least one.
        rates: of the variables that change; all others stay as they are.

    Raises:
        ValueError: a value is no smooth function, or one whose derivative nobody has needed yet.
    """
    zero = values[0].tracer.constant(0.0)
    known = {node.index: rate for node, rate in rates.items()}
    found: dict[int, Scalar] = {}
    for node in reachable(values):
        if node.index in known:
            found[node.index] = known[node.index]
        elif not node.args:
            found[node.index] = zero
        else:
            found[node.index] = _rate(node, [found[arg.index] for arg in node.args], zero)
    return [found[value.index] for value in values]


def _rate(node: Scalar, rates: list[Scalar], zero: Scalar) -> Scalar:
    """Return the rate of an operation from those of its operands."""
    if all(rate is zero for rate in rates):
        return zero
    args, first = node.args, rates[0]
    match node.op:
        case "add":
            return first + rates[1]
        case "sub":
            return first - rates[1]
        case "mul":
            return first * args[1] + args[0] * rates[1]
        case "div":
            return (first - node * rates[1]) / args[1]
        case "neg":
            return -first
        case "sin":
            return cos(args[0]) * first
        case "cos":
            return -(sin(args[0]) * first)
        case "sqrt":
            return first / (2.0 * node)
        case _:
            raise ValueError(f"`{node.op}` has no derivative here")
