"""Placements: attachment of a body, recorded at each change, so that no replay is needed to find it."""

from ropsim.spatial import Pose, record


@record
class Placement:
    """From one time on, until the next placement of the same body.

    Attributes:
        time: [s], a whole control tick; 0 for where it is at the start.
        body: its name.
        parent: name of the body that it hangs on, empty for the world.
        X_PB: its frame in that of the parent; of a body that a joint moves, at joint coordinate 0.
        visible: False while it is absent: a tool not mounted, a part in its supply or removed by a sink.
    """

    time: float
    body: str
    parent: str
    X_PB: Pose
    visible: bool = True
