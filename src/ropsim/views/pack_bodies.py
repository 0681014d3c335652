"""Bodies of a pack: links have world poses, parts ride on what carries them, all else stays in place."""

from ropsim.flow import Recording
from ropsim.kinematics import frames_batch
from ropsim.model import Cell
from ropsim.spatial import Array, quaternions_from_matrices
from ropsim.views.pack_channels import QUATERNION_STEP, continuous, resampled
from ropsim.views.pack_columns import Body, Code, smooth
from ropsim.views.part_journeys import Placement, Stay, part_journeys
from ropsim.views.scene_bodies import WORLD, SceneIndex, scene_bodies
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
    index = SceneIndex.of(cell)
    entries: list[dict[str, object]] = [{"name": one.name, "track": "fixed"} for one in scene_bodies(cell)]
    for place, columns in zip(index.links, _link_columns(recording, cell, times, body), strict=True):
        entries[place] |= {"track": "poses", "columns": columns}
    for name, journey in part_journeys(recording, cell).items():
        placements = [_placement(one, cell, index) for one in journey]
        entries[index.parts[name]] |= {"track": "placed", "placements": placements}
    return entries


def _link_columns(recording: Recording, cell: Cell, times: Array, body: Body) -> list[list[Code]]:
    """Return seven column codes for each link: its joint's frame in W."""
    q = resampled(recording.channels["q"].values, recording, times)
    frames = cell.X_WB.matrix() @ frames_batch(cell.robot, q)[:, : cell.robot.n]
    found = []
    for i in range(cell.robot.n):
        position = frames[:, i, :3, 3]
        turned = continuous(quaternions_from_matrices(frames[:, i, :3, :3]))
        found.append(
            [
                *(smooth(column, POSITION_STEP, body) for column in position.T),
                *(smooth(column, QUATERNION_STEP, body) for column in turned.T),
            ]
        )
    return found


def _placement(one: Placement, cell: Cell, index: SceneIndex) -> dict[str, object]:
    """Return a placement relative to the last link, or in W."""
    carried = one.stay is Stay.CARRIED
    pose = cell.robot.X_nM @ one.pose if carried else one.pose
    return {
        "time": one.time,
        "parent": index.links[-1] if carried else WORLD,
        "pose": plain_pose(pose),
        "visible": one.stay in {Stay.CARRIED, Stay.RESTING},
    }
