"""Closed chains in MJCF: sites on two bodies that equality constraints hold together."""

from collections.abc import Iterable, Sequence

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.exchange.files.xml_text import Tag, tag
from ropsim.exchange.mjcf.text import placed
from ropsim.model import ALL_DIRECTIONS, BASE_LINK, Direction, LoopCut
from ropsim.spatial import Pose

_POINT = {Direction.X, Direction.Y, Direction.Z}
_HINGE = set(ALL_DIRECTIONS) - {Direction.ABOUT_Z}
_ALONG = Pose(np.array([0.0, 0.0, 0.1]))  # the second point on the axis of a hinge


@frozen_dataclass
class HeldPoint:
    """Two frames that a constraint holds together.

    Attributes:
        name: of the constraint; that of its sites begins with it.
        kind: `connect` for their origins, `weld` for all.
        links: numbers of the links that carry them.
        frames: on these.
    """

    name: str
    kind: str
    links: tuple[int, int]
    frames: tuple[Pose, Pose]

    def site(self, place: int) -> Tag:
        """Return the site on the first or second link."""
        return tag("site", [("name", f"{self.name}_{place}"), *placed(self.frames[place])])

    @property
    def constraint(self) -> Tag:
        """Return the equality of the two sites."""
        sites = [("site1", f"{self.name}_0"), ("site2", f"{self.name}_1")]
        return tag(self.kind, [("name", self.name), *sites])


def held_points(cuts: Sequence[LoopCut]) -> tuple[HeldPoint, ...]:
    """Return the constraints of closed chains of the kinds that MJCF has."""
    return tuple(point for number, cut in enumerate(cuts, start=1) for point in _points(f"cut_{number}", cut))


def lost_cuts(cuts: Sequence[LoopCut]) -> list[int]:
    """Return the numbers, from 1, of the cuts that MJCF has no constraint for."""
    return [number for number, cut in enumerate(cuts, start=1) if not list(_points("", cut))]


def _points(name: str, cut: LoopCut) -> Iterable[HeldPoint]:
    links, frames = (max(cut.first, BASE_LINK), cut.second), (cut.X_first, cut.X_second)
    held = set(cut.held)
    if held == set(ALL_DIRECTIONS):
        yield HeldPoint(name, "weld", links, frames)
    if held in (_POINT, _HINGE):
        yield HeldPoint(name, "connect", links, frames)
    if held == _HINGE:
        yield HeldPoint(f"{name}_axis", "connect", links, (frames[0] @ _ALONG, frames[1] @ _ALONG))
