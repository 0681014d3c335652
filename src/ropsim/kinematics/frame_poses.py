"""Where the task frames of a cell are when a run starts."""

from ropsim.kinematics.body_poses import body_poses
from ropsim.model import WORLD, Cell, body_tree, start_of
from ropsim.spatial import Pose


def frame_poses(cell: Cell) -> dict[str, Pose]:
    """Return X_WK of each task frame by name; of one that moves with all axes at their start positions."""
    parents = {frame.parent for frame in cell.frames.values() if frame.parent != WORLD}
    X_WP = {WORLD: Pose()}
    if parents:
        start = {name: q[None] for name, q in start_of(cell).items()}
        found = body_poses(body_tree(cell), start, sorted(parents))
        X_WP |= {name: Pose.from_matrix(rows[0]) for name, rows in found.items()}
    return {
        name: X_WP[frame.parent] @ frame.X_PK if frame.parent != WORLD else frame.X_PK
        for name, frame in cell.frames.items()
    }
