"""Tracks: for how long a body hangs on one and the same thing that moves, and where on it."""

from collections import defaultdict
from collections.abc import Iterable

from ropsim.flow import Placement
from ropsim.model import BodyTree, carrier
from ropsim.spatial import Array, Pose, record


@record
class Track:
    """A body that does not move on its carrier for a time.

    Attributes:
        body: its name.
        start: [s].
        end: [s]; inf for the last one.
        carrier: the body nearest to it that a joint moves, itself included; `WORLD` where none does.
        X_CB: its pose in the frame of that, shape (4, 4).
        hand: parent.
    """

    body: str
    start: float
    end: float
    carrier: str
    X_CB: Array
    hand: str


def tracks(tree: BodyTree, placements: Iterable[Placement]) -> list[Track]:
    """Return the tracks of all bodies while they are there, by body and in order of time.

    Args:
        tree: the bodies at time 0.
        placements: changes, in order of time.
    """
    playing = _Playing(tree)
    for one in placements:
        if one.body in playing.bodies and (not one.parent or one.parent in playing.bodies):
            playing.take(one)
    return playing.ended()


class _Playing:
    """Takes placements one after the other."""

    def __init__(self, tree: BodyTree) -> None:
        self.bodies = tree.by_name()
        self.parents = {body.name: body.parent for body in tree.bodies}
        self.poses = {body.name: body.X_PB for body in tree.bodies}
        self.seen = {body.name: body.visible for body in tree.bodies}
        self.since = dict.fromkeys(self.bodies, 0.0)
        self.made: dict[str, list[Track]] = defaultdict(list)

    def take(self, one: Placement) -> None:
        """Attach a body elsewhere from a time on, with the bodies attached to it."""
        family = [one.body]
        for name in family:
            family += [
                child
                for child, parent in self.parents.items()
                if parent == name and self.bodies[child].mover is None
            ]
        for name in family:
            self._end(name, one.time)
        self.parents[one.body], self.poses[one.body] = one.parent, one.X_PB
        self.seen[one.body] = one.visible

    def ended(self) -> list[Track]:
        """Return all tracks."""
        for name in self.bodies:
            self._end(name, float("inf"))
        return [track for name in self.bodies for track in self.made[name]]

    def _end(self, name: str, time: float) -> None:
        """End the track of a body; its next one begins."""
        start, self.since[name] = self.since[name], time
        if not self.seen[name] or not time > start:
            return
        on = carrier(self.bodies, self.parents, name)
        X_CB, above = Pose(), name
        while above != on:
            X_CB, above = self.poses[above] @ X_CB, self.parents[above]
        self.made[name].append(Track(name, start, time, on, X_CB.matrix(), self.parents[name]))
