"""A fault of a diagram, and where it is."""

from collections.abc import Iterator

from ropsim.blockdiagram.blocks import Block
from ropsim.blockdiagram.diagram import Diagram
from ropsim.core import Diagnostic, Kind, Span, frozen_dataclass

Part = tuple[str, int]
"""`signal`, `block` or `link` with its number, or `controller` and 0."""
CONTROLLER: Part = ("controller", 0)


@frozen_dataclass
class Fault:
    """A fault.

    Attributes:
        kind: of the finding.
        part: of the diagram that it is in.
        message: found and allowed.
        hint: next step.
    """

    kind: Kind
    part: Part
    message: str
    hint: str = ""

    def finding(self, span: Span | None = None) -> Diagnostic:
        """Return the finding at a place."""
        return self.kind.at(span, self.message, hint=self.hint)


def called(block: Block) -> str:
    """Return a block in words, such as `block `pi``."""
    return f"block `{block.name[:60]}`"


def blocks_of(diagram: Diagram) -> Iterator[tuple[Part, Block]]:
    """Yield the blocks of a diagram with their places."""
    for number, block in enumerate(diagram.blocks):
        yield ("block", number), block
