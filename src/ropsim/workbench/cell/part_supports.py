"""What carries a part where a task leaves it, by the same lines as in a run."""

from collections.abc import Iterable

from ropsim.core import frozen_dataclass
from ropsim.kinematics import Blocks, bearing_at_start, height_above, part_blocks, stacked, standings
from ropsim.model import Cell, Part, lying_words, spoken_body
from ropsim.spatial import Pose

Lying = Iterable[tuple[Part, Pose]]
"""Parts with X_WO."""


@frozen_dataclass
class PartSupports:
    """What can carry parts in a cell; objects, devices and robots stand as at the start.

    Attributes:
        cell: the cell.
        bearing: what can carry parts, without other parts; None where it is not known what stands around.
    """

    cell: Cell
    bearing: Blocks | None

    @classmethod
    def of(cls, cell: Cell) -> "PartSupports":
        """Return what can carry parts in a cell."""
        return cls(cell, bearing_at_start(cell))

    def carries(self, part: Part, X_WO: Pose, others: Lying) -> bool:
        """Return whether something is so near below a part that it lies there; where nobody knows it does.

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
        """Return how high a part is above what is next below it [m], and what messages call that.

        Args:
            part: as with `carries`, likewise all else.
            X_WO: where.
            others: parts that lie in the cell.
        """
        there = part_blocks(others) if self.bearing is None else stacked([self.bearing, part_blocks(others)])
        height, name = height_above(part_blocks([(part, X_WO)]), 0, there)
        return height, spoken_body(self.cell, name)

    @property
    def words(self) -> str:
        """Return from what height on a part lies on nothing, as a clause."""
        return lying_words(self.cell.supports)
