"""Bodies of a pack: bodies on joints have world poses, parts move with their carriers, others are fixed."""

from collections import defaultdict

from ropsim.flow import Recording
from ropsim.kinematics import body_poses
from ropsim.model import BodyKind, BodyTree, Cell, body_tree
from ropsim.spatial import Array, quaternions_from_matrices
from ropsim.views.pack.channels import QUATERNION_STEP, continuous, resampled
from ropsim.views.pack.columns import Body, Code, smooth
from ropsim.views.scene.shown_placements import ShownPlacements

POSITION_STEP = 1e-5
"""Coarsest rounding of a body's position [m]."""


def packed_bodies(recording: Recording, cell: Cell, times: Array, body: Body) -> list[dict[str, object]]:
    """Return the entries of all bodies, in the order of the scene.

    Args:
        recording: of a run in this cell.
        cell: simulated cell.
        times: of the samples [s], shape (n,).
        body: gets the bytes of the columns.
    """
    tree = body_tree(cell)
    places = tree.places()
    entries: list[dict[str, object]] = [{"name": one.name, "track": "fixed"} for one in tree.bodies]
    for name, columns in _link_columns(recording, tree, times, body).items():
        entries[places[name]] |= {"track": "poses", "columns": columns}
    for name, placements in _placements(recording, tree).items():
        entries[places[name]] |= {"track": "placed", "placements": placements}
    return entries


def _link_columns(recording: Recording, tree: BodyTree, times: Array, body: Body) -> dict[str, list[Code]]:
    """Return seven column codes for each link of robots and devices: its joint's frame in W."""
    Q = {name: _coordinates(recording, name, times) for name in tree.mechanisms}
    poses = body_poses(tree, Q, tree.moving())
    found = {}
    for name, matrices in poses.items():
        turned = continuous(quaternions_from_matrices(matrices[:, :3, :3]))
        found[name] = [
            *(smooth(column, POSITION_STEP, body) for column in matrices[:, :3, 3].T),
            *(smooth(column, QUATERNION_STEP, body) for column in turned.T),
        ]
    return found


def _coordinates(recording: Recording, mechanism: str, times: Array) -> Array:
    """Return the joint coordinates of a mechanism at some times, shape (k, n)."""
    return resampled(recording.channels[recording.facts.channel("q", mechanism)].values, recording, times)


def _placements(recording: Recording, tree: BodyTree) -> dict[str, list[dict[str, object]]]:
    """Return the placements of every part in the recording, by name."""
    shown, parts = ShownPlacements(tree), set(tree.names(BodyKind.PART))
    found: dict[str, list[dict[str, object]]] = defaultdict(list)
    for placement in recording.placements:
        for name, shown_pose in shown.take(placement):
            if name in parts:
                found[name].append(shown_pose)
    return found
