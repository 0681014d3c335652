"""The lines of a law while they are written: its numbers, its memory and its statements."""

from collections.abc import Iterable

from ropsim.blockdiagram import Block, Diagram, Wiring

Elements = list[str]
"""Expressions of the elements of a signal."""


class Written:
    """Statements of a law, with the numbers and places of the memory that they use.

    `p` are the parameters and `x` the memory of the law, both one behind the other. Statements come in four
    parts: outputs of blocks in their order, memory at the start before (`before`) and after (`after`) all
    outputs are known, and values kept for the next tick.

    Args:
        diagram: without faults.
        wiring: of it.
        first: place of the first number of the memory.
    """

    def __init__(self, diagram: Diagram, wiring: Wiring, first: int) -> None:
        self.diagram = diagram
        self.outputs: list[str] = []
        self.after: list[str] = []
        self.kept: list[str] = []
        self.numbers: list[float] = []
        self.size = first
        self._wiring = wiring
        self._sizes = {one.name: one.size for one in diagram.signals}
        self._signals = {one.name: number for number, one in enumerate(diagram.signals)}
        self._locals = 0

    def number(self, value: float) -> str:
        """Return the expression of a number; equal ones differ, so that other numbers have the same code."""
        self.numbers.append(float(value))
        return f"p[{len(self.numbers) - 1}]"

    def numbers_from(self, values: Iterable[float]) -> int:
        """Return where numbers begin that stand one behind the other."""
        first = len(self.numbers)
        self.numbers += map(float, values)
        return first

    def memory(self, count: int) -> int:
        """Reserve numbers of the memory and return the place of the first."""
        first = self.size
        self.size += count
        return first

    def local(self) -> str:
        """Return a new name."""
        self._locals += 1
        return f"v{self._locals}"

    def element(self, signal: str, k: int) -> str:
        """Return the expression of an element of a signal."""
        name, number = self._wiring.origin(signal, k)
        return f"s{self._signals[name]}_{number}"

    def elements(self, signal: str) -> Elements:
        """Return the expressions of a signal."""
        return [self.element(signal, k) for k in range(self._sizes[signal])]

    def inputs(self, block: Block) -> list[Elements]:
        """Return the expressions of the inputs of a block."""
        return [self.elements(name) for name in block.inputs]

    def flat(self, block: Block) -> Elements:
        """Return the expressions of all inputs of a block, one behind the other."""
        return [one for elements in self.inputs(block) for one in elements]

    def results(self, block: Block) -> Elements:
        """Return the names that the output of a block is given."""
        return [f"s{self._signals[block.output]}_{k}" for k in range(self._sizes[block.output])]

    def before(self, lines: Iterable[str]) -> None:
        """Add statements that fill the memory of a block at the start, ahead of its output."""
        self.outputs += _at_start(lines)

    def behind(self, lines: Iterable[str]) -> None:
        """Add statements that fill the memory of a block at the start, when all outputs are known."""
        self.after += _at_start(lines)


def _at_start(lines: Iterable[str]) -> list[str]:
    inner = list(lines)
    return ["if fresh:", *(f"    {line}" for line in inner)] if inner else []


def total(terms: Iterable[str]) -> str:
    """Return the expression of a sum."""
    written = list(terms)
    return " + ".join(written) if written else "0.0"
