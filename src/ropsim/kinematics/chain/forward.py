"""Forward kinematics: from joint coordinates to poses."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from ropsim.kinematics.chain.arrays import ChainArrays, chain_arrays, joint_rows, joint_vector
from ropsim.kinematics.chain.closure import closed_states
from ropsim.kinematics.chain.linear_loops import without_linear_loops
from ropsim.kinematics.chain.tree_arrays import TreeArrays, moved_steps, placed_steps, tree_arrays
from ropsim.model import BASE_LINK, Mechanism
from ropsim.spatial import Array, Pose


def forward(robot: Mechanism, q: npt.ArrayLike) -> Pose:
    """Return the pose X_BM of the mechanical interface in the base frame.

    The TCP of a tool is `forward(robot, q) @ tool.X_MT`.

    Args:
        robot: mechanism with n axes.
        q: coordinates of the axes [rad | m], shape (n,).

    Raises:
        ArrayShapeError: M551, q has another shape.
        NotFiniteError: M552, q holds NaN or infinity.
    """
    return Pose.from_matrix(joint_frames(robot, q)[-1])


def tool_pose(robot: Mechanism, q: Array, X_MT: Pose) -> Pose:
    """Return X_BT of a tool, to the bit that of a row of `forward_batch` behind which it is; looks not at q.

    Args:
        robot: mechanism with n axes.
        q: finite coordinates of the axes [rad | m], shape (n,).
        X_MT: of the tool.
    """
    from ropsim.kinematics.chain.chain_kernel import POSES
    from ropsim.kinematics.chain.tool_pose_kernel import write_tool_pose

    linear = without_linear_loops(robot)
    if linear.cuts or X_MT.is_identity:
        return Pose.from_matrix(forward_batch(robot, q[np.newaxis])[0]) @ X_MT
    chain = chain_arrays(linear)
    X_BM, room, pose = np.empty((1, 4, 4)), np.empty(POSES), np.empty(7)
    rows = chain.steps(q[np.newaxis])
    write_tool_pose(chain.flat, rows, X_MT.position, X_MT.orientation, X_BM, room, pose)
    return Pose.of_units(pose)


def tool_places(robot: Mechanism, Q: Array, tools: Sequence[Pose]) -> Array:
    """Return where tools are in the base frame [m], shape (k, 3).

    Args:
        robot: mechanism with n axes.
        Q: coordinates of the axes, one behind the other [rad | m], without gaps, shape (k, n) or (k·n,).
        tools: X_MT of each of the k.
    """
    from ropsim.kinematics.chain.chain_kernel import POSES
    from ropsim.kinematics.chain.tool_pose_kernel import write_tool_places

    rows = Q.reshape(len(tools), robot.n)
    points = np.concatenate([one.position for one in tools]).reshape(len(tools), 3)
    linear = without_linear_loops(robot)
    if linear.cuts:
        X_BM = forward_batch(robot, rows)
        return np.asarray((X_BM[:, :3, :3] @ points[:, :, None])[:, :, 0] + X_BM[:, :3, 3])
    chain = chain_arrays(linear)
    steps = np.ascontiguousarray(chain.steps(rows))
    write_tool_places(chain.flat, steps, points, np.empty((len(rows), 4, 4)), np.empty(POSES))
    return points


def forward_batch(robot: Mechanism, Q: npt.ArrayLike) -> Array:
    """Return X_BM of many configurations as homogeneous matrices, shape (k, 4, 4); compiled.

    Args:
        robot: mechanism with n axes.
        Q: coordinates of the axes [rad | m], shape (k, n); a row with NaN yields a matrix with NaN.

    Raises:
        ArrayShapeError: M551, Q has another shape.
    """
    from ropsim.kinematics.chain.chain_kernel import POSES, forward_rows

    linear = without_linear_loops(robot)
    if linear.cuts:
        return np.ascontiguousarray(frames_batch(robot, Q)[:, -1])
    chain = chain_arrays(linear)
    rows = np.ascontiguousarray(chain.steps(joint_rows(robot, Q)))
    out = np.empty((len(rows), 4, 4))
    forward_rows(chain.flat, rows, out, np.empty(POSES))
    return out


def joint_frames(robot: Mechanism, q: npt.ArrayLike) -> Array:
    """Return the frames of all links, moved by q, and of the mechanical interface.

    Args:
        robot: mechanism with n axes.
        q: coordinates of the axes [rad | m], shape (n,).

    Returns:
        Homogeneous matrices in the base frame, shape (links + 1, 4, 4); row i belongs to link i, from 0, and
        has the axis of the joint that moves it as z; the last row is X_BM.

    Raises:
        ArrayShapeError: M551, q has another shape.
        NotFiniteError: M552, q holds NaN or infinity.
        MechanismError: the mechanism cannot be.
    """
    frames: Array = _link_frames(
        tree_arrays(without_linear_loops(robot)), joint_vector(robot, q)[np.newaxis]
    )[0]
    return frames


def frames_batch(robot: Mechanism, Q: npt.ArrayLike) -> Array:
    """Return `joint_frames` of many configurations Q (k, n), shape (k, links + 1, 4, 4).

    Raises:
        ArrayShapeError: M551, Q has another shape.
        MechanismError: the mechanism cannot be.
    """
    return _link_frames(tree_arrays(without_linear_loops(robot)), joint_rows(robot, Q))


def frames_of_steps(robot: Mechanism, Q: npt.ArrayLike) -> Array:
    """Return the frames of all steps of a mechanism (`model.JointTree`) for Q (k, n), shape (k, m, 4, 4).

    Raises:
        ArrayShapeError: M551, Q has another shape.
        MechanismError: the mechanism cannot be.
    """
    return _step_frames(tree_arrays(without_linear_loops(robot)), joint_rows(robot, Q))


def frames_of(chain: ChainArrays, rows: Array) -> Array:
    """Return the frames of all steps to the interface, and its own, for axes at rows (k, n).

    Returns:
        Homogeneous matrices in the base frame, shape (k, m + 1, 4, 4).
    """
    moved = chain.steps(rows) + chain.offset
    m = moved.shape[1]
    steps = np.zeros((len(rows), m + 1, 4, 4))  # each frame in the one before it
    steps[:, :m] = moved_steps(chain.R, chain.p, chain.slides, moved)
    steps[:, m, :3], steps[:, m, 3, 3] = chain.X_nM, 1.0
    for i in range(1, m + 1):
        steps[:, i] = steps[:, i - 1] @ steps[:, i]  # now in the base frame
    return steps


def _step_frames(tree: TreeArrays, rows: Array) -> Array:
    """Return the frames of all steps for axes at rows (k, n), shape (k, m, 4, 4).

    Where a closed chain cannot reach, it is left open.
    """
    moved = tree.steps(rows)
    if tree.loops is not None:
        n = tree.loops.n
        moved = moved + closed_states(tree.loops, rows)[0][:, n:] @ tree.loops.spread[:, n:-1].T
    return placed_steps(tree, moved)


def _link_frames(tree: TreeArrays, rows: Array) -> Array:
    """Return the frames of all links and of the interface, shape (k, links + 1, 4, 4)."""
    frames = _step_frames(tree, rows)
    if tree.direct and tree.interface != BASE_LINK:
        last = frames[:, tree.interface] @ tree.X_LM
        return np.concatenate((frames, last[:, np.newaxis]), axis=1)
    links = np.empty((len(rows), len(tree.carriers) + 1, 4, 4))
    for number, step in enumerate(tree.carriers):
        links[:, number] = np.eye(4) if step == BASE_LINK else frames[:, step]
    for number in tree.moved:
        links[:, number] = links[:, number] @ tree.X_SL[number]
    links[:, -1] = tree.X_LM if tree.interface == BASE_LINK else links[:, tree.interface] @ tree.X_LM
    return links
