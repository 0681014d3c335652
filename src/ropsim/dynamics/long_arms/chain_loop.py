"""Dynamics of serial chains of any length as loops over the joints, where straight code would be too long.

R. Featherstone: Rigid Body Dynamics Algorithms, Springer 2008: recursive Newton-Euler (section 5.3) and
articulated bodies (7.3), whose cost is in proportion to the number of joints.

`chain` holds minus free fall, 3 numbers; then 24 for each joint: 1 for a prismatic and 0 for a revolute one,
offset, rotation by rows and origin of its frame at coordinate 0, barycentric parameters of its body; then
rotation and origin of the mechanical interface. The functions are compiled from their text.
"""

import numpy as np

from ropsim.dynamics.long_arms.chain_steps import (
    carry_force,
    carry_inertia,
    carry_motion,
    momentum,
    move_joint,
    place_joint,
    spatial_inertia,
    turn_momentum,
)
from ropsim.spatial import Array


def chain_torques(q: Array, qd: Array, qdd: Array, wrench: Array, chain: Array, tau: Array) -> None:
    """Enter the joint torques of the rigid bodies, without friction and motor inertia.

    Args:
        q: joint coordinates [rad | m], shape (n,).
        qd: joint speeds, shape (n,).
        qdd: joint accelerations, shape (n,).
        wrench: force and moment that the mechanical interface exerts on its surroundings, in its own frame.
        chain: see above.
        tau: gets the torques [N·m | N], shape (n,).
    """
    n = q.shape[0]
    R, p, f = np.zeros((n, 3, 3)), np.zeros((n, 3)), np.zeros((n, 6))
    v, a, h = np.zeros(6), np.zeros(6), np.zeros(6)
    a[3:] = chain[:3]
    for i in range(n):
        b = 3 + 24 * i
        place_joint(chain, b, q[i], R[i], p[i])
        carry_motion(R[i], p[i], v)
        carry_motion(R[i], p[i], a)
        move_joint(chain, b, qd[i], v, a)
        a[5 if chain[b] != 0.0 else 2] += qdd[i]
        momentum(chain, b, a, f[i])
        momentum(chain, b, v, h)
        turn_momentum(v, h, f[i])
    end, tip = 3 + 24 * n, np.zeros(6)
    tip[:3], tip[3:] = wrench[3:], wrench[:3]
    R_tip = np.zeros((3, 3))
    for r in range(3):
        R_tip[r] = chain[end + 3 * r : end + 3 * r + 3]
    carry_force(R_tip, chain[end + 9 :], tip, f[n - 1])
    for i in range(n - 1, -1, -1):
        tau[i] = f[i, 5 if chain[3 + 24 * i] != 0.0 else 2]
        if i > 0:
            carry_force(R[i], p[i], f[i], f[i - 1])


def chain_accelerations(q: Array, qd: Array, tau: Array, inertia: Array, chain: Array, qdd: Array) -> None:
    """Enter the joint accelerations, by articulated bodies.

    Args:
        q: joint coordinates [rad | m], shape (n,).
        qd: joint speeds, shape (n,).
        tau: joint efforts: drives less friction [N·m | N], shape (n,).
        inertia: that the drives add at the joints [kg·m² | kg], shape (n,).
        chain: see above.
        qdd: gets the accelerations, shape (n,).
    """
    n = q.shape[0]
    R, p = np.zeros((n, 3, 3)), np.zeros((n, 3))
    A, f = np.zeros((n, 6, 6)), np.zeros((n, 6))
    c, U, D = np.zeros((n, 6)), np.zeros((n, 6)), np.zeros(n)
    v, h = np.zeros(6), np.zeros(6)
    for i in range(n):
        b = 3 + 24 * i
        place_joint(chain, b, q[i], R[i], p[i])
        carry_motion(R[i], p[i], v)
        move_joint(chain, b, qd[i], v, c[i])
        spatial_inertia(chain, b, A[i])
        momentum(chain, b, v, h)
        turn_momentum(v, h, f[i])
    for i in range(n - 1, -1, -1):
        axis = 5 if chain[3 + 24 * i] != 0.0 else 2
        U[i] = A[i, :, axis]
        D[i] = U[i, axis] + inertia[i]
        qdd[i] = tau[i] - f[i, axis]
        if i > 0:
            for r in range(6):
                for k in range(6):
                    A[i, r, k] -= U[i, r] * U[i, k] / D[i]
            for r in range(6):
                f[i, r] += U[i, r] * qdd[i] / D[i]
                for k in range(6):
                    f[i, r] += A[i, r, k] * c[i, k]
            carry_inertia(R[i], p[i], A[i], A[i - 1])
            carry_force(R[i], p[i], f[i], f[i - 1])
    v[:] = 0.0
    v[3:] = chain[:3]
    for i in range(n):
        carry_motion(R[i], p[i], v)
        for r in range(6):
            v[r] += c[i, r]
            qdd[i] -= U[i, r] * v[r]
        qdd[i] /= D[i]
        v[5 if chain[3 + 24 * i] != 0.0 else 2] += qdd[i]


def chain_mass_matrix(q: Array, chain: Array, M: Array) -> None:
    """Enter the mass matrix of the rigid bodies by rows: column j are the torques of a unit acceleration.

    Args:
        q: joint coordinates [rad | m], shape (n,).
        chain: see above; free fall is left out.
        M: gets the entries, shape (n·n,).
    """
    n = q.shape[0]
    rest, unit, column = np.zeros(n), np.zeros(n), np.zeros(n)
    weightless, nothing = chain.copy(), np.zeros(6)
    weightless[:3] = 0.0
    for j in range(n):
        unit[j] = 1.0
        chain_torques(q, rest, unit, nothing, weightless, column)
        unit[j] = 0.0
        for i in range(n):
            M[n * i + j] = column[i]
