"""Parts in a live run: messages at the moment when one is taken, left, supplied or gone."""

from collections.abc import Mapping
from dataclasses import dataclass

from ropsim.model import Cell, body_tree, link_name
from ropsim.simulation import PartsState
from ropsim.spatial import Pose
from ropsim.studio.jobs import LiveMessage
from ropsim.views import plain_pose

WORLD = -1


@dataclass(frozen=True, slots=True)
class Place:
    """Where a part is: on the last link or in W; or nowhere to be seen."""

    parent: int
    pose: Pose
    visible: bool


def placed(cell: Cell, before: PartsState, after: PartsState, time: float) -> list[LiveMessage]:
    """Return a message for every part that has another place now.

    Args:
        cell: the cell.
        before: parts as they were told last.
        after: parts as they are.
        time: when that came to be [s].
    """
    old, new, index = places(cell, before), places(cell, after), body_tree(cell).places()
    return [
        LiveMessage(
            {
                "type": "placed",
                "time": time,
                "body": index[name],
                "parent": new[name].parent,
                "pose": plain_pose(new[name].pose),
                "visible": new[name].visible,
            }
        )
        for name in new
        if new[name] != old[name]
    ]


def places(cell: Cell, parts: PartsState) -> Mapping[str, Place]:
    """Return the place of every part by name; a part in its supply or gone keeps the pose of its supply."""
    link = body_tree(cell).places()[link_name(cell.robot.n)]
    found: dict[str, Place] = {}
    for part in cell.parts:
        if parts.grasp is not None and parts.grasp.part.name == part.name:
            found[part.name] = Place(link, cell.robot.X_nM @ parts.grasp.X_MO, visible=True)
        elif part.name in parts.resting:
            found[part.name] = Place(WORLD, parts.resting[part.name], visible=True)
        else:
            found[part.name] = Place(WORLD, part.X_WO, visible=False)
    return found
