"""Hoisting: operations of a formula on given numbers alone are done once, as constants of generated code.

A formula reads numbers of a model and arguments that change at every call. Its operations on those numbers
alone move into a formula of their own, which is evaluated when the numbers are known; in the generated code
their results stand as `constants[k]`. So other numbers need no other code, and cost nearly nothing while it
runs.
"""

from collections.abc import Mapping, Sequence

from ropsim.codegen.formulas.emit import SourceFunction, emit
from ropsim.codegen.formulas.tracer import Scalar, Tracer, reachable
from ropsim.core import frozen_dataclass

NUMBERS = "numbers"
"""Name of the array from which a formula reads the given numbers."""
CONSTANTS = "constants"
"""Name of the array from which generated code reads the constants."""


@frozen_dataclass
class Hoisted:
    """A formula in two parts.

    Attributes:
        results: the same results, reading `constants` where the formula read `numbers`.
        prologue: `prologue(numbers, constants)`, the part that is done once.
        count: length of `constants`.
    """

    results: list[Scalar]
    prologue: SourceFunction
    count: int


def given(tracer: Tracer, present: Sequence[bool]) -> list[Scalar]:
    """Return the given numbers as scalars: numbers that are not `present` are the constant 0."""
    zero = tracer.constant(0.0)
    return [tracer.variable(f"{NUMBERS}[{k}]") if there else zero for k, there in enumerate(present)]


def hoisted(results: Sequence[Scalar]) -> Hoisted:
    """Split a formula into the part that depends on given numbers alone and the rest.

    Args:
        results: of the formula; all of one tracer.
    """
    nodes = reachable(results)
    known = _known(nodes)
    wanted = {arg.index for node in nodes if node.index not in known for arg in node.args}
    wanted |= {value.index for value in results}
    moved = [node for node in nodes if node.index in known and node.index in wanted and node.value is None]
    places = {node.index: f"{CONSTANTS}[{k}]" for k, node in enumerate(moved)}
    prologue = emit("prologue", (NUMBERS, CONSTANTS), [(places[node.index], node) for node in moved])
    return Hoisted(_rebuilt(nodes, known, places, results), prologue, len(moved))


def _known(nodes: Sequence[Scalar]) -> set[int]:
    """Return the nodes that read only given numbers."""
    found: set[int] = set()
    for node in nodes:
        leaf = node.value is not None or node.text.startswith(f"{NUMBERS}[")
        if leaf or (node.args and all(arg.index in found for arg in node.args)):
            found.add(node.index)
    return found


def _rebuilt(
    nodes: Sequence[Scalar], known: set[int], places: Mapping[int, str], results: Sequence[Scalar]
) -> list[Scalar]:
    """Return the results over a graph in which the moved nodes are read from `constants`."""
    copies: dict[int, Scalar] = {}
    for node in nodes:
        if node.index in places:
            copies[node.index] = node.tracer.variable(places[node.index])
        elif node.index not in known and node.args:
            copies[node.index] = node.tracer.operation(node.op, *(copies[arg.index] for arg in node.args))
        else:
            copies[node.index] = node
    return [copies[value.index] for value in results]
