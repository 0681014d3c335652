"""The independent oracle of closed chains: trees in MuJoCo, and their loops as equations of rigid bodies."""

from typing import Any

import mujoco
import numpy as np

from ropsim.model import BASE_LINK, Direction, LoopCut, Mechanism
from ropsim.spatial import Array, Pose
from support.mujoco_tree import MujocoTree

ALONG = (Direction.X, Direction.Y, Direction.Z)
ABOUT = (Direction.ABOUT_X, Direction.ABOUT_Y)


class MujocoLoops(MujocoTree):
    """A tree with loops: mass matrix, bias and Jacobians of MuJoCo, and constraint forces by elimination."""

    def __init__(self, mechanism: Mechanism) -> None:
        super().__init__(mechanism)
        self._cuts = mechanism.cuts

    def accelerations(self, Q: Array, Qd: Array, efforts: Array) -> Array:
        """Return the accelerations of all joint coordinates (N,) under efforts at them (N,).

        With rows A of the loops: M·y'' + h = f + Aᵀ·λ and A·y'' = -γ, solved for y'' and λ at once by least
        squares, as rows may be redundant.
        """
        model, data, T = self._model, self._data, self._rows
        data.qpos[:], data.qvel[:] = T @ Q + self._offsets, T @ Qd
        mujoco.mj_forward(model, data)
        M = np.zeros((model.nv, model.nv))
        mujoco.mj_fullM(model, data, M)
        rows = [row for cut in self._cuts for row in self._cut(cut)]
        A = np.array([row for row, _ in rows]) @ T
        drift = np.array([one for _, one in rows])
        n, r = T.shape[1], len(A)
        whole = np.block([[T.T @ M @ T, -A.T], [A, np.zeros((r, r))]])
        right = np.concatenate((efforts - T.T @ data.qfrc_bias, -drift))
        return np.asarray(np.linalg.lstsq(whole, right, rcond=1e-13)[0][:n])

    def _cut(self, cut: LoopCut) -> list[tuple[Array, float]]:
        """Return rows (nv,) of a cut that is closed, and what they have without accelerations.

        The origins of both frames stay together, and where a turn is held the z axis of the second frame at
        right angles to x and y of the first one.
        """
        (p1, R1, J1, K1), (p2, R2, J2, K2) = (
            self._end(cut.first, cut.X_first),
            self._end(cut.second, cut.X_second),
        )
        assert np.abs(p2 - p1).max() < 1e-9
        v = self._data.qvel
        found = []
        for direction, axis in zip(ALONG, R1.T, strict=True):
            if direction in cut.held:
                turning = np.cross(J1[3:] @ v, axis) @ ((J2[:3] - J1[:3]) @ v)
                found.append((axis @ (J2[:3] - J1[:3]), axis @ (K2[:3] - K1[:3]) @ v + 2.0 * turning))
        z, w1, w2 = R2[:, 2], J1[3:] @ v, J2[3:] @ v
        for direction, axis in zip(ABOUT, (R1[:, 1], R1[:, 0]), strict=True):
            if direction in cut.held:
                u = np.cross(z, axis)
                rate = np.cross(np.cross(w2, z), axis) + np.cross(z, np.cross(w1, axis))
                found.append((u @ (J2[3:] - J1[3:]), u @ (K2[3:] - K1[3:]) @ v + (w2 - w1) @ rate))
        return found

    def _end(self, link: int, X: Pose) -> tuple[Array, Array, Array, Array]:
        """Return place, rotation, Jacobian (6, nv) and its derivative of a frame on a link."""
        J, K = np.zeros((6, self._model.nv)), np.zeros((6, self._model.nv))
        if link == BASE_LINK:
            return X.position, X.rotation(), J, K
        body = self.bodies[link]
        R = self._data.xmat[body].reshape(3, 3)
        place = self._data.xpos[body] + R @ X.position
        mujoco.mj_jac(self._model, self._data, J[:3], J[3:], place, body)
        mujoco.mj_jacDot(self._model, self._data, K[:3], K[3:], place, body)
        return place, R @ X.rotation(), J, K


def swung(
    tree_text: str, cuts: tuple[LoopCut, ...], start: tuple[Array, Array], step: float, count: int
) -> Any:
    """Return the coordinates after steps of MuJoCo's own integration with `connect` constraints.

    Args:
        tree_text: MJCF of the tree.
        cuts: of two bodies each.
        start: coordinates and speeds.
        step: [s].
        count: number of steps.
    """
    ends = "".join(
        f'<connect body1="body{cut.first}" body2="body{cut.second}" '
        f'anchor="{" ".join(map(repr, cut.X_first.position.tolist()))}" '
        f'solref="{2.0 * step!r} 1" solimp=".9999 .9999 .001 .5 2"/>'
        for cut in cuts
    )
    option = f'<option timestep="{step!r}" integrator="RK4" tolerance="1e-14" iterations="200"/>'
    text = tree_text.replace("</mujoco>", f"{option}<equality>{ends}</equality></mujoco>")
    model: Any = mujoco.MjModel.from_xml_string(text)
    for number, cut in enumerate(cuts):  # its compiler takes these from the tree at 0, which is open
        model.eq_data[number, 3:6] = cut.X_second.position
    data: Any = mujoco.MjData(model)
    data.qpos[:], data.qvel[:] = start
    for _ in range(count):
        mujoco.mj_step(model, data)
    return data.qpos.copy()
