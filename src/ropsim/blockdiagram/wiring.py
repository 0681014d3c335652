"""The wiring of a diagram: where each element of a signal comes from, and the order of its blocks."""

from collections.abc import Iterable, Mapping
from graphlib import CycleError, TopologicalSorter

from ropsim.blockdiagram.diagram import Diagram
from ropsim.blockdiagram.forms import passes_at_once
from ropsim.core import frozen_dataclass

Element = tuple[str, int]
"""Name of a signal, and number of an element, from 0."""


@frozen_dataclass
class Wiring:
    """The wiring of a diagram that is right.

    Attributes:
        origins: where the elements come from that links set: an element of an input or of a block.
        order: numbers of the blocks, each after those whose output it needs at the same tick.
    """

    origins: Mapping[Element, Element]
    order: tuple[int, ...]

    def origin(self, signal: str, element: int) -> Element:
        """Return where an element comes from: itself where a block or the outside sets it."""
        return self.origins.get((signal, element), (signal, element))


class LoopError(Exception):
    """Elements or blocks need each other: their numbers in order, the first one twice.

    Attributes:
        blocks: numbers of blocks; empty for links.
        element: of a loop of links.
    """

    def __init__(self, blocks: tuple[int, ...], element: Element | None = None) -> None:
        super().__init__()
        self.blocks = blocks
        self.element = element


def wiring_of(diagram: Diagram) -> Wiring:
    """Return the wiring of a diagram in which each element is set once.

    Raises:
        LoopError: links or blocks go round.
    """
    direct: dict[Element, Element] = {}
    for link in diagram.links:
        for k in range(link.count):
            direct[link.target, link.target_first + k] = (link.source, link.source_first + k)
    origins = {element: _followed(direct, element) for element in direct}
    sizes = {one.name: one.size for one in diagram.signals}
    makers = {one.output: number for number, one in enumerate(diagram.blocks)}
    graph: dict[int, set[int]] = {}
    for number, block in enumerate(diagram.blocks):
        needed = block.inputs if passes_at_once(block) else ()
        graph[number] = set(_makers(needed, sizes, origins, makers))
    try:
        return Wiring(origins, tuple(TopologicalSorter(graph).static_order()))
    except CycleError as error:
        raise LoopError(tuple(error.args[1])) from None


def _makers(
    needed: Iterable[str],
    sizes: Mapping[str, int],
    origins: Mapping[Element, Element],
    makers: Mapping[str, int],
) -> Iterable[int]:
    for name in dict.fromkeys(needed):
        for k in range(sizes[name]):
            signal, _ = origins.get((name, k), (name, k))
            if signal in makers:
                yield makers[signal]


def _followed(direct: Mapping[Element, Element], start: Element) -> Element:
    element, seen = start, {start}
    while element in direct:
        element = direct[element]
        if element in seen:
            raise LoopError((), start)
        seen.add(element)
    return element
