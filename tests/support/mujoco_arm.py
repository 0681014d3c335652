"""The independent oracle: the same arm in MuJoCo."""

from typing import Any

import mujoco
import numpy as np

from ropsim.model import JointType, RobotModel
from ropsim.spatial import Array, quaternion_from_matrix

SMALLEST_MASS = 1e-12  # MuJoCo refuses massless moving bodies; adds less than its rounding


class MujocoArm:
    """Rigid bodies and motor inertia of an arm; no friction."""

    def __init__(self, robot: RobotModel) -> None:
        self._n = robot.n
        self._model: Any = mujoco.MjModel.from_xml_string(_mjcf(robot))
        self._data: Any = mujoco.MjData(self._model)
        for k, link in enumerate(robot.links):
            # the compiler refuses inertias that break A + B >= C, as Armstrong's link 3 does
            moments, axes = np.linalg.eigh(link.inertia)
            axes[:, 0] *= np.sign(np.linalg.det(axes))
            self._model.body_inertia[k + 1] = moments
            self._model.body_iquat[k + 1] = quaternion_from_matrix(axes)
            self._model.body_ipos[k + 1] = link.com
            self._model.body_mass[k + 1] = max(link.mass, SMALLEST_MASS)
            self._model.qpos0[k] = 0.0
        mujoco.mj_setConst(self._model, self._data)
        self._offsets = np.array([joint.offset for joint in robot.joints])

    def inverse(self, q: Array, qd: Array, qdd: Array) -> Array:
        """Return the joint torques [N·m | N], shape (n,)."""
        self._data.qpos[:] = q + self._offsets
        self._data.qvel[:] = qd
        self._data.qacc[:] = qdd
        mujoco.mj_inverse(self._model, self._data)
        return np.array(self._data.qfrc_inverse)

    def forward(self, q: Array, qd: Array, tau: Array) -> Array:
        """Return the joint accelerations, shape (n,)."""
        self._data.qpos[:] = q + self._offsets
        self._data.qvel[:] = qd
        self._data.qfrc_applied[:] = tau
        mujoco.mj_forward(self._model, self._data)
        return np.array(self._data.qacc)


def _mjcf(robot: RobotModel) -> str:
    bodies = ""
    for k, joint in enumerate(robot.joints):
        inertia = (
            robot.drives[k].motor.rotor_inertia * robot.drives[k].ratio_at(0.0) ** 2 if robot.drives else 0.0
        )
        kind = "hinge" if joint.type is JointType.REVOLUTE else "slide"
        position = " ".join(map(repr, joint.placement.position.tolist()))
        turn = " ".join(map(repr, joint.placement.orientation.tolist()))
        bodies += (
            f'<body pos="{position}" quat="{turn}"><joint type="{kind}" axis="0 0 1" armature="{inertia!r}"/>'
            f'<inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>'
        )
    gravity = " ".join(map(repr, robot.gravity.tolist()))
    return (
        '<mujoco><compiler angle="radian" boundmass="1e-12" boundinertia="1e-12"/>'
        f'<option gravity="{gravity}"><flag contact="disable"/></option>'
        f"<worldbody>{bodies}{'</body>' * robot.n}</worldbody></mujoco>"
    )
