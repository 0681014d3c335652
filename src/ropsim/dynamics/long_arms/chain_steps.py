"""Steps of the loops over a chain: each is compiled from its text, in the order of this file.

Spatial vectors have their angular part first and are taken in the frame of a joint, about its origin. `chain`
is explained in `chain_loop`; `b` is the place of a joint in it.
"""

import math

import numpy as np

from ropsim.spatial import Array


def place_joint(chain: Array, b: int, q: float, R: Array, p: Array) -> None:
    """Enter rotation and origin of the frame of a joint, in the frame before it, as the joint stands."""
    slides, moved = chain[b] != 0.0, q + chain[b + 1]
    s, c = (0.0, 1.0) if slides else (math.sin(moved), math.cos(moved))
    for r in range(3):
        x, y, z = chain[b + 2 + 3 * r], chain[b + 3 + 3 * r], chain[b + 4 + 3 * r]
        R[r, 0], R[r, 1], R[r, 2] = x * c + y * s, y * c - x * s, z
        p[r] = chain[b + 11 + r] + (z * moved if slides else 0.0)


def carry_motion(R: Array, p: Array, v: Array) -> None:
    """Turn a motion of the frame before a joint into the same motion in the frame of the joint, in place."""
    x = v[3] + v[1] * p[2] - v[2] * p[1]
    y = v[4] + v[2] * p[0] - v[0] * p[2]
    z = v[5] + v[0] * p[1] - v[1] * p[0]
    a, b, c = v[0], v[1], v[2]
    for k in range(3):
        v[k] = R[0, k] * a + R[1, k] * b + R[2, k] * c
        v[3 + k] = R[0, k] * x + R[1, k] * y + R[2, k] * z


def carry_force(R: Array, p: Array, f: Array, into: Array) -> None:
    """Add a force in the frame of a joint to one in the frame before it."""
    for r in range(3):
        into[r] += R[r, 0] * f[0] + R[r, 1] * f[1] + R[r, 2] * f[2]
    x, y, z = (
        R[0, 0] * f[3] + R[0, 1] * f[4] + R[0, 2] * f[5],
        R[1, 0] * f[3] + R[1, 1] * f[4] + R[1, 2] * f[5],
        R[2, 0] * f[3] + R[2, 1] * f[4] + R[2, 2] * f[5],
    )
    into[0] += p[1] * z - p[2] * y
    into[1] += p[2] * x - p[0] * z
    into[2] += p[0] * y - p[1] * x
    into[3] += x
    into[4] += y
    into[5] += z


def move_joint(chain: Array, b: int, qd: float, v: Array, c: Array) -> None:
    """Add the speed of a joint to the motion of its frame; add the acceleration v × S·q̇ to `c`."""
    if chain[b] != 0.0:
        v[5] += qd
        c[3] += v[1] * qd
        c[4] -= v[0] * qd
    else:
        v[2] += qd
        c[0] += v[1] * qd
        c[1] -= v[0] * qd
        c[3] += v[4] * qd
        c[4] -= v[3] * qd


def momentum(chain: Array, b: int, v: Array, h: Array) -> None:
    """Enter the momentum of the body of a joint that moves with `v`."""
    m, x, y, z = chain[b + 14], chain[b + 15], chain[b + 16], chain[b + 17]
    xx, yy, zz = chain[b + 18], chain[b + 19], chain[b + 20]
    xy, xz, yz = chain[b + 21], chain[b + 22], chain[b + 23]
    h[0] = xx * v[0] + xy * v[1] + xz * v[2] + y * v[5] - z * v[4]
    h[1] = xy * v[0] + yy * v[1] + yz * v[2] + z * v[3] - x * v[5]
    h[2] = xz * v[0] + yz * v[1] + zz * v[2] + x * v[4] - y * v[3]
    h[3] = m * v[3] + v[1] * z - v[2] * y
    h[4] = m * v[4] + v[2] * x - v[0] * z
    h[5] = m * v[5] + v[0] * y - v[1] * x


def turn_momentum(v: Array, h: Array, f: Array) -> None:
    """Add v ×* h to a force: the rate of a momentum that turns with its body."""
    f[0] += v[1] * h[2] - v[2] * h[1] + v[4] * h[5] - v[5] * h[4]
    f[1] += v[2] * h[0] - v[0] * h[2] + v[5] * h[3] - v[3] * h[5]
    f[2] += v[0] * h[1] - v[1] * h[0] + v[3] * h[4] - v[4] * h[3]
    f[3] += v[1] * h[5] - v[2] * h[4]
    f[4] += v[2] * h[3] - v[0] * h[5]
    f[5] += v[0] * h[4] - v[1] * h[3]


def spatial_inertia(chain: Array, b: int, A: Array) -> None:
    """Enter the inertia of the body of a joint, shape (6, 6): columns are momenta of unit motions."""
    unit, h = np.zeros(6), np.zeros(6)
    for k in range(6):
        unit[k] = 1.0
        momentum(chain, b, unit, h)
        unit[k] = 0.0
        for r in range(6):
            A[r, k] = h[r]


def carry_inertia(R: Array, p: Array, A: Array, into: Array) -> None:
    """Add an inertia in the frame of a joint to one in the frame before it: Xᵀ·A·X."""
    X, B = np.zeros((6, 6)), np.zeros((6, 6))
    unit = np.zeros(6)
    for k in range(6):
        unit[:] = 0.0
        unit[k] = 1.0
        carry_motion(R, p, unit)
        for r in range(6):
            X[r, k] = unit[r]
    for r in range(6):
        for k in range(6):
            for j in range(6):
                B[r, k] += A[r, j] * X[j, k]
    for r in range(6):
        for k in range(6):
            for j in range(6):
                into[r, k] += X[j, r] * B[j, k]
