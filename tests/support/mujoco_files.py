"""The independent oracle of robot files: MuJoCo reads the same text."""

from typing import Any

import mujoco
import numpy as np

from ropsim.exchange.testing import written_tree
from ropsim.model import JointType, RobotModel
from ropsim.spatial import Array


class MujocoFile:
    """A file in MuJoCo, with its joints by name; constraints, limits and dry friction are switched off."""

    def __init__(self, text: str) -> None:
        self.model: Any = mujoco.MjModel.from_xml_string(text)
        self._data: Any = mujoco.MjData(self.model)
        off = mujoco.mjtDisableBit
        self.model.opt.disableflags |= (
            off.mjDSBL_CONTACT | off.mjDSBL_EQUALITY | off.mjDSBL_LIMIT | off.mjDSBL_FRICTIONLOSS
        )

    def rows(self, robot: RobotModel) -> tuple[Array, Array]:
        """Return matrix and shift from the axes of a robot to the coordinates of the file, joint by joint."""
        rows, shift = np.zeros((self.model.nv, robot.n)), np.zeros(self.model.nv)
        for one in written_tree(robot).joints:
            if one.type is not JointType.FIXED:
                at = int(self.model.joint(one.name).qposadr[0])
                axis, factor = (one.axis, 1.0) if one.axis is not None else one.follows or (0, 0.0)
                rows[at, axis], shift[at] = factor, one.constant
        return rows, shift

    def frame(self, qpos: Array, name: str, kind: str = "site") -> Array:
        """Return the frame of a site or body in the world, shape (4, 4)."""
        self._data.qpos[:] = qpos
        mujoco.mj_kinematics(self.model, self._data)
        part = getattr(self._data, kind)(name)
        X = np.eye(4)
        X[:3, :3], X[:3, 3] = part.xmat.reshape(3, 3), part.xpos
        return X

    def mass_matrix(self, qpos: Array) -> Array:
        """Return the mass matrix of the coordinates of the file, rotors included, shape (nv, nv)."""
        self._data.qpos[:] = qpos
        self._data.qvel[:] = 0.0
        mujoco.mj_forward(self.model, self._data)
        M = np.zeros((self.model.nv, self.model.nv))
        mujoco.mj_fullM(self.model, self._data, M)
        return M

    def inverse(self, qpos: Array, qvel: Array, qacc: Array) -> Array:
        """Return the efforts [N·m | N] with rotors and viscous friction, shape (nv,)."""
        self._data.qpos[:], self._data.qvel[:], self._data.qacc[:] = qpos, qvel, qacc
        mujoco.mj_inverse(self.model, self._data)
        return np.array(self._data.qfrc_inverse)
