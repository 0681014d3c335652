"""The part of a traced graph that some results need."""

from collections.abc import Sequence

from ropsim.codegen.tracer import Scalar


def reachable(roots: Sequence[Scalar]) -> list[Scalar]:
    """Return what the roots need, themselves included; arguments first."""
    found: dict[int, Scalar] = {}
    stack = list(roots)
    while stack:
        node = stack.pop()
        if node.index not in found:
            found[node.index] = node
            stack.extend(node.args)
    return [found[index] for index in sorted(found)]
