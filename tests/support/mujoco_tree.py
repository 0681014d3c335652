"""The independent oracle of trees: bodies and joints of a mechanism in MuJoCo, without its couplings."""

from typing import Any

import mujoco
import numpy as np

from ropsim.model import JointType, Link, Mechanism
from ropsim.spatial import Array

_X, _Y, _Z = "1 0 0", "0 1 0", "0 0 1"
_PAIRS: dict[JointType, tuple[tuple[str, str], ...]] = {
    JointType.REVOLUTE: (("hinge", _Z),),
    JointType.PRISMATIC: (("slide", _Z),),
    JointType.SCREW: (("hinge", _Z), ("slide", _Z)),
    JointType.CYLINDRICAL: (("hinge", _Z), ("slide", _Z)),
    JointType.UNIVERSAL: (("hinge", _Z), ("hinge", _X)),
    JointType.SPHERICAL: (("hinge", _Z), ("hinge", _Y), ("hinge", _X)),
    JointType.PLANAR: (("slide", _X), ("slide", _Y), ("hinge", _Z)),
    JointType.FIXED: (),
}


class MujocoTree:
    """Rigid bodies of a tree with N joint coordinates, joint by joint; no friction, no couplings."""

    def __init__(self, mechanism: Mechanism) -> None:
        self._model: Any = mujoco.MjModel.from_xml_string(mjcf_of_tree(mechanism))
        self._data: Any = mujoco.MjData(self._model)
        self.bodies = [self._model.body(f"body{k}").id for k in range(len(mechanism.joints))]
        self._rows, self._offsets = self._lifted(mechanism)

    def _lifted(self, mechanism: Mechanism) -> tuple[Array, Array]:
        """Return the matrix and the shift from joint coordinates to those of MuJoCo."""
        total = sum(joint.type.freedoms for joint in mechanism.joints)
        rows, offsets = np.zeros((self._model.nv, total)), np.zeros(self._model.nv)
        first = 0
        for k, joint in enumerate(mechanism.joints):
            for place, _ in enumerate(_PAIRS[joint.type]):
                at = int(self._model.joint(f"joint{k}_{place}").qposadr[0])
                if joint.type is JointType.SCREW:
                    factor = joint.lead / (2.0 * np.pi) if place else 1.0
                    rows[at, first], offsets[at] = factor, factor * joint.offset
                else:
                    rows[at, first + place] = 1.0
                    offsets[at] = joint.offset if place == 0 else 0.0
            first += joint.type.freedoms
        return rows, offsets

    def frames(self, Q: Array) -> Array:
        """Return the frames of all links in the base frame, shape (links, 4, 4)."""
        self._data.qpos[:] = self._rows @ Q + self._offsets
        mujoco.mj_kinematics(self._model, self._data)
        found = np.tile(np.eye(4), (len(self.bodies), 1, 1))
        for k, body in enumerate(self.bodies):
            found[k, :3, :3] = self._data.xmat[body].reshape(3, 3)
            found[k, :3, 3] = self._data.xpos[body]
        return found

    def inverse(self, Q: Array, Qd: Array, Qdd: Array) -> Array:
        """Return the efforts at all joint coordinates [N·m | N], shape (N,)."""
        self._data.qpos[:] = self._rows @ Q + self._offsets
        self._data.qvel[:] = self._rows @ Qd
        self._data.qacc[:] = self._rows @ Qdd
        mujoco.mj_inverse(self._model, self._data)
        return np.asarray(self._rows.T @ self._data.qfrc_inverse)

    def energy(self, Q: Array, Qd: Array) -> tuple[float, float]:
        """Return potential and kinetic energy [J]."""
        self._model.opt.enableflags |= mujoco.mjtEnableBit.mjENBL_ENERGY
        self._data.qpos[:] = self._rows @ Q + self._offsets
        self._data.qvel[:] = self._rows @ Qd
        mujoco.mj_forward(self._model, self._data)
        return float(self._data.energy[0]), float(self._data.energy[1])


def _inertial(link: Link) -> str:
    (xx, xy, xz), (_, yy, yz), (_, _, zz) = link.inertia.tolist()
    inertia = " ".join(map(repr, (xx, yy, zz, xy, xz, yz)))
    com = " ".join(map(repr, link.com.tolist()))
    return f'<inertial pos="{com}" mass="{link.mass!r}" fullinertia="{inertia}"/>'


def mjcf_of_tree(mechanism: Mechanism) -> str:
    def children(parent: int) -> str:
        return "".join(body(k) for k, joint in enumerate(mechanism.joints) if joint.parent == parent)

    def body(k: int) -> str:
        joint = mechanism.joints[k]
        position = " ".join(map(repr, joint.placement.position.tolist()))
        turn = " ".join(map(repr, joint.placement.orientation.tolist()))
        pairs = "".join(
            f'<joint name="joint{k}_{place}" type="{kind}" axis="{axis}"/>'
            for place, (kind, axis) in enumerate(_PAIRS[joint.type])
        )
        return (
            f'<body name="body{k}" pos="{position}" quat="{turn}">{pairs}'
            f"{_inertial(mechanism.links[k])}{children(k)}</body>"
        )

    gravity = " ".join(map(repr, mechanism.gravity.tolist()))
    return (
        '<mujoco><compiler angle="radian" boundmass="1e-12" boundinertia="1e-12" fusestatic="false"/>'
        f'<option gravity="{gravity}"><flag contact="disable"/></option>'
        f"<worldbody>{children(-1)}</worldbody></mujoco>"
    )
