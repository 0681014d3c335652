"""Bodies of a pack: links have world poses, parts ride on what carries them, all else stays in place."""

from ropsim.flow import Recording
from ropsim.kinematics import body_poses
from ropsim.model import ROBOT, BodyKind, BodyTree, Cell, body_tree, link_name
from ropsim.spatial import Array, quaternions_from_matrices
from ropsim.views.pack_channels import QUATERNION_STEP, continuous, resampled
from ropsim.views.pack_columns import Body, Code, smooth
from ropsim.views.part_journeys import Placement, Stay, part_journeys
from ropsim.views.scene_bodies import NO_BODY
from ropsim.views.scene_shapes import plain_pose

POSITION_STEP = 1e-5
"""Coarsest rounding of a body's position [m]."""


def packed_bodies(recording: Recording, cell: Cell, times: Array, body: Body) -> list[dict[str, object]]:
    """Return the entries of all bodies, in the order of the scene.

    Args:
        recording: of a run in this cell.
        cell: as it was simulated.
        times: of the samples [s], shape (n,).
        body: gets the bytes of the columns.
    """
    tree = body_tree(cell)
    places = tree.places()
    entries: list[dict[str, object]] = [{"name": one.name, "track": "fixed"} for one in tree.bodies]
    for name, columns in _link_columns(recording, tree, times, body).items():
        entries[places[name]] |= {"track": "poses", "columns": columns}
    for name, journey in part_journeys(recording, cell).items():
        placements = [_placement(one, cell, places) for one in journey]
        entries[places[name]] |= {"track": "placed", "placements": placements}
    return entries


def _link_columns(recording: Recording, tree: BodyTree, times: Array, body: Body) -> dict[str, list[Code]]:
    """Return seven column codes for each link: its joint's frame in W."""
    q = resampled(recording.channels["q"].values, recording, times)
    poses = body_poses(tree, {ROBOT: q}, tree.names(BodyKind.LINK))
    found = {}
    for name, matrices in poses.items():
        turned = continuous(quaternions_from_matrices(matrices[:, :3, :3]))
        found[name] = [
            *(smooth(column, POSITION_STEP, body) for column in matrices[:, :3, 3].T),
            *(smooth(column, QUATERNION_STEP, body) for column in turned.T),
        ]
    return found


def _placement(one: Placement, cell: Cell, places: dict[str, int]) -> dict[str, object]:
    """Return a placement relative to the last link, or in W."""
    carried = one.stay is Stay.CARRIED
    pose = cell.robot.X_nM @ one.pose if carried else one.pose
    return {
        "time": one.time,
        "parent": places[link_name(cell.robot.n)] if carried else NO_BODY,
        "pose": plain_pose(pose),
        "visible": one.stay in {Stay.CARRIED, Stay.RESTING},
    }
