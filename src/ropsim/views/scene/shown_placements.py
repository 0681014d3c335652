"""Placements as a page takes them: relative to the link that carries a body, else in the world."""

from collections import defaultdict
from collections.abc import Iterator

from ropsim.flow import Placement
from ropsim.model import WORLD, BodyTree, carrier
from ropsim.views.scene.bodies import NO_BODY
from ropsim.views.scene.shapes import plain_pose


class ShownPlacements:
    """Takes placements one after the other and yields the poses at which the page shows bodies.

    A page has the poses of links, not the attachments. So a body is sent again when one of its parents moves,
    and its pose is expressed in the frame of the link with which it moves.

    Args:
        tree: the bodies of the cell.

    Attributes:
        places: place of each body in the scene, by name.
    """

    def __init__(self, tree: BodyTree) -> None:
        self.places = tree.places()
        self._bodies = tree.by_name()
        self._parents = {body.name: body.parent for body in tree.bodies}
        self._poses = {body.name: body.X_PB for body in tree.bodies}
        self._seen = {body.name: body.visible for body in tree.bodies}
        self._on: dict[str, dict[str, None]] = defaultdict(dict)
        for name, parent in self._parents.items():
            self._on[parent][name] = None

    def take(self, placement: Placement) -> Iterator[tuple[str, dict[str, object]]]:
        """Yield the body, and each body attached to it, with the data for the page.

        `time` [s], `parent` (place of the link in the scene, -1 for none), `pose` in its frame or in the
        world, `visible`. Bodies that the cell does not have are passed over.
        """
        name = placement.body
        if name not in self._bodies or (placement.parent and placement.parent not in self._bodies):
            return
        self._on[self._parents[name]].pop(name, None)
        self._on[placement.parent][name] = None
        self._parents[name], self._poses[name] = placement.parent, placement.X_PB
        self._seen[name] = placement.visible
        family = [name]
        for one in family:
            if self._bodies[one].mover is None:  # the page has the poses of links and their bodies
                family += self._on[one]
                yield one, self._shown(one, placement.time)

    def _shown(self, name: str, time: float) -> dict[str, object]:
        link = carrier(self._bodies, self._parents, name)
        pose, above = self._poses[name], self._parents[name]
        while above != link:
            pose, above = self._poses[above] @ pose, self._parents[above]
        return {
            "time": time,
            "parent": NO_BODY if link == WORLD else self.places[link],
            "pose": plain_pose(pose),
            "visible": self._seen[name],
        }
