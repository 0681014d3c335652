"""Supports of a part where a task leaves it, by the same criteria as in a run."""

from collections.abc import Iterable

from ropsim.core import frozen_dataclass
from ropsim.kinematics import Blocks, bearing_at_start, height_above, part_blocks, stacked, standings
from ropsim.model import Cell, Part, lying_words, spoken_body
from ropsim.spatial import Pose

Lying = Iterable[tuple[Part, Pose]]
"""Parts with X_WO."""


@frozen_dataclass
class PartSupports:
    """Supports of parts in a cell; objects, devices and robots stand as at the start.

    Attributes:
        cell: the cell.
        bearing: supports except other parts; None if the surroundings are unknown.
    """

    cell: Cell
    bearing: Blocks | None

    @classmethod
    def of(cls, cell: Cell) -> "PartSupports":
        """Return the supports of parts in a cell."""
        return cls(cell, bearing_at_start(cell))

    def carries(self, part: Part, X_WO: Pose, others: Lying) -> bool:
        """Return whether a body is close enough below a part to support it; true if unknown.

        Args:
            part: that is left.
            X_WO: where.
            others: parts that lie in the cell.
        """
        if self.bearing is None:
            return True
        there = stacked([self.bearing, part_blocks(others)])
        (found,) = standings(part_blocks([(part, X_WO)]), there, self.cell.supports.gap)
        return found.on is not None

    def below(self, part: Part, X_WO: Pose, others: Lying) -> tuple[float, str]:
        """Return the height of a part above the nearest body below it [m], and the name of that body.

        Args:
            part: this and the others as with `carries`.
            X_WO: where.
            others: parts that lie in the cell.
        """
        there = part_blocks(others) if self.bearing is None else stacked([self.bearing, part_blocks(others)])
        height, name = height_above(part_blocks([(part, X_WO)]), 0, there)
        return height, spoken_body(self.cell, name)

    @property
    def words(self) -> str:
        """Return a clause with the height above which a part is unsupported."""
        return lying_words(self.cell.supports)
