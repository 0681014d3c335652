"""The PUMA 560 whose wrist leads the torch: chain, moves through joint coordinates, what they are to keep."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ropsim.flow import ModalState, MotionKind, MoveInstruction, Origin
from ropsim.kinematics import forward_batch
from ropsim.model import OrientationMode
from ropsim.planning.testing import PlannedMove, planned_move_of
from ropsim.spatial import Array, Pose
from support.cells import chain_of, with_station
from support.motion import CELL, LINE, PASS, PUMA, interface_pose

TORCH = ModalState(tool="torch")
X_MT = CELL.first.tools["torch"].X_MT
CHAINS = {
    mode: chain_of(with_station(CELL, controller=replace(CELL.first.controller, orientation=mode)))
    for mode in OrientationMode
}
LEADING = CHAINS[OrientationMode.WRIST_ANGLES]


def torch_at(q: Array) -> Pose:
    """Return X_BT of the torch at joint coordinates (6,)."""
    return interface_pose(q) @ X_MT


def torch_places(Q: Array) -> Array:
    """Return where the TCP of the torch is at rows of joint coordinates (k, 6) [m], shape (k, 3)."""
    return np.asarray((forward_batch(PUMA, Q) @ X_MT.matrix())[:, :3, 3])


def move_through(kind: str, points: Sequence[Array], modal: ModalState = TORCH) -> MoveInstruction:
    """Return the move of the torch through poses that it has at joint coordinates (6,), to the last one."""
    *via, end = (torch_at(q) for q in points)
    return MoveInstruction(kind, end, modal, Origin(LINE, PASS), via=tuple(via))


def moves_from(
    q_start: Array, random: np.random.Generator
) -> dict[MotionKind, tuple[MoveInstruction, list[Array]]]:
    """Return a move of each kind with the joint coordinates at its points, the start aside.

    The arm goes on a little from point to point, the wrist turns to and fro by up to 0.6 rad.
    """
    way = np.append(random.uniform(-0.2, 0.2, 3), np.zeros(3))
    bend = np.append(random.uniform(-0.04, 0.04, (4, 3)), random.uniform(-0.6, 0.6, (4, 3)), axis=1)
    points = [q_start + (k + 1) / 4.0 * way + bend[k] for k in range(4)]
    counts = {MotionKind.LIN: 1, MotionKind.CIRC: 2, MotionKind.SPLINE: 4}
    return {kind: (move_through(kind, points[:count]), points[:count]) for kind, count in counts.items()}


def led(move: MoveInstruction, q_start: Array) -> PlannedMove:
    """Return the leg of a move that the wrist leads; fail where it is refused."""
    found = planned_move_of(LEADING, move, q_start)
    assert isinstance(found, PlannedMove), found
    return found
