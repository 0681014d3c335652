"""Six turning joints reduced to one unknown, of which the joint coordinates are eigenvalues.

Raghavan & Roth, Inverse Kinematics of the General 6R Manipulator, 1993, with the eigenvalue problem of
Manocha & Canny, Efficient Inverse Kinematics for General 6R Manipulators, 1994. Base and interface are joined
to a ring of six joints, which may be cut open anywhere and traversed in either sense. In the order of the
traversal, with fixed steps C0 to C5, of which one holds the pose,

    Rz(c)·C3·Rz(d)·C4·Rz(e)·C5·Rz(f) = C2⁻¹·Rz(-b)·C1⁻¹·Rz(-a)·C0⁻¹.

f changes neither origin p nor z axis l of these frames. From p and l follow 14 equations, p, l, p·p, p·l, p ×
l, (p·p)·l - 2·(p·l)·p, which are linear in the products of (sin d, cos d, 1) and (sin e, cos e, 1) on the
left and of a and b on the right. With the right sides eliminated, six equations in d and e are left, with
coefficients linear in sin c and cos c; in tangents x of half angles, and each also multiplied by x_d, they
are (A·x² + B·x + C)·v = 0 of order 12. Where the geometry makes that singular for all poses, as parallel and
meeting axes often do, another cut does not.
"""

from collections.abc import Sequence

import numpy as np

from ropsim.kinematics.chain.arrays import ChainArrays
from ropsim.spatial import Array, frozen, record

OFFSETS = (0.7391, 1.2137, -0.5713)
"""Added to c, d and e [rad]: angles of ±π, frequent in programs, have no finite tangent of their half."""
THIRDS = 2.0 * np.pi / 3.0 * np.arange(3)
TURN = np.diag([1.0, -1.0, -1.0, 1.0])  # Rx(π): turns about z become their opposites


@record
class Elimination:
    """One way to cut the ring of an arm open, with the data common to all poses.

    Attributes:
        order: joints a to f, from 0.
        forwards: 1.0 if the ring is traversed from base to interface, else 0.0.
        steps: C0 to C5; the one that holds the pose has no meaning, shape (6, 4, 4).
        posed: place of that among them, 0, 1 or 2.
        before: interface in the frame of joint 6, shape (4, 4).
        after: frame of joint 1 in the base frame, shape (4, 4).
        left: coefficients of the 14 equations for (1, cos c, sin c), in half tangents, shape (3, 14, 9).
    """

    order: tuple[int, ...]
    forwards: float
    steps: Array
    posed: int
    before: Array
    after: Array
    left: Array

    def loop(self, T: Array) -> Array:
        """Return C0, C1, C2 for poses X_BM (k, 4, 4), shape (k, 3, 4, 4)."""
        C = np.repeat(self.steps[np.newaxis, :3], len(T), axis=0)
        closing = self.before @ inverse_pose(T) @ self.after
        C[:, self.posed] = closing if self.forwards > 0.0 else TURN @ inverse_pose(closing) @ TURN
        return C


WAYS = 6
"""Number of cuts with the pose on the right side, so that the left one is computed once."""


def steps_of(chain: ChainArrays) -> Array:
    """Return the steps between the joints of an arm and to its interface, offsets included, (n + 1, 4, 4)."""
    C = np.zeros((chain.n + 1, 4, 4))
    C[:, 3, 3] = 1.0
    C[:-1, :3, :3], C[:-1, :3, 3], C[-1, :3] = chain.R, chain.p, chain.X_nM
    C[:-1] = C[:-1] @ about_z(chain.offset)
    return C


def without_joint(chain: ChainArrays, joint: int, value: float) -> ChainArrays:
    """Return a chain of turning joints with one of them held at a value [rad]."""
    C = steps_of(chain)
    held = C[joint] @ about_z(np.array([value]))[0] @ C[joint + 1]
    return turning_chain(np.concatenate((C[:joint], held[np.newaxis], C[joint + 2 :])))


def turning_chain(C: Array) -> ChainArrays:
    """Return the chain of turning joints with steps between them and to its interface, (n + 1, 4, 4)."""
    n = len(C) - 1
    R, p, zeros = C[:-1, :3, :3], C[:-1, :3, 3], np.zeros(n)
    rows = np.column_stack((R.reshape(-1, 9), p, zeros, zeros))
    return ChainArrays(
        R=frozen(R),
        p=frozen(p),
        slides=frozen(zeros),
        offset=frozen(zeros),
        X_nM=frozen(C[-1, :3]),
        spread=frozen(np.empty((0, n + 1))),
        turning=frozen(np.ones(n)),
        flat=frozen(np.concatenate((rows.ravel(), C[-1, :3, :3].ravel(), C[-1, :3, 3]))),
    )


def eliminations(C: Array, wanted: Sequence[int]) -> tuple[Elimination, ...]:
    """Return the requested ones of the six ways, for steps C of `steps_of`, shape (7, 4, 4)."""
    forwards = [np.eye(4), *C[1:6]]
    backwards = [TURN @ inverse_pose(C[i]) @ TURN for i in (5, 4, 3, 2, 1)]
    senses = (forwards, (0, 1, 2, 3, 4, 5)), ([np.eye(4), *backwards], (5, 4, 3, 2, 1, 0))
    ways = []
    for number in wanted:
        (steps, joints), posed = senses[number // 3], number % 3
        turned = np.array([steps[i - posed] for i in range(6)])
        order = tuple(joints[i - posed] for i in range(6))
        left, sense = _left_sides(turned), 1.0 if number < 3 else 0.0
        ways.append(Elimination(order, sense, frozen(turned), posed, frozen(C[6]), frozen(C[0]), left))
    return tuple(ways)


def pencils(way: Elimination, C: Array) -> tuple[Array, Array]:
    """Return (A, B, C) of k poses, shape (3, k, 12, 12), and the right sides, shape (k, 14, 9)."""
    right = _right_sides(C)
    null = np.linalg.qr(right[:, :, :8], mode="complete")[0][:, :, 8:].swapaxes(1, 2)
    constant = right[:, :, 8:] * _HALF[8]  # of the monomial 1, in half tangents
    E = null @ (way.left[0] - constant), null @ way.left[1], null @ way.left[2]
    pencil = np.zeros((3, len(C), 12, 12))
    for part, six in zip(pencil, (E[0] - E[1], 2.0 * E[2], E[0] + E[1]), strict=True):
        part[:, :6, :9] = part[:, 6:, 3:] = six
    return pencil, right


def inverse_pose(T: Array) -> Array:
    """Return the inverse of poses, shape (..., 4, 4)."""
    X = np.zeros(T.shape)
    X[..., :3, :3] = T[..., :3, :3].swapaxes(-1, -2)
    X[..., :3, 3:] = -X[..., :3, :3] @ T[..., :3, 3:]
    X[..., 3, 3] = 1.0
    return X


def _left_sides(C: Array) -> Array:
    c, d, e = (axis.ravel() for axis in np.meshgrid(THIRDS, THIRDS, THIRDS, indexing="ij"))
    turns = [about_z(angles - off) for angles, off in zip((c, d, e), OFFSETS, strict=True)]
    X = turns[0] @ C[3] @ turns[1] @ C[4] @ turns[2] @ C[5]
    values = equations(X).reshape(3, 9, 14)
    rows = np.linalg.solve(terms(d[:9], e[:9]), values).swapaxes(1, 2)  # (3, 14, 9) by c
    parts = np.linalg.solve(
        np.column_stack((np.ones(3), np.cos(THIRDS), np.sin(THIRDS))), rows.reshape(3, -1)
    )
    return frozen(parts.reshape(3, 14, 9) @ _HALF)


def _right_sides(C: Array) -> Array:
    a, b = (axis.ravel() for axis in np.meshgrid(THIRDS, THIRDS, indexing="ij"))
    C0, C1, C2 = inverse_pose(C).swapaxes(0, 1)[:, :, np.newaxis]
    X = C2 @ about_z(-b) @ C1 @ about_z(-a) @ C0
    values = equations(X)
    return np.asarray(np.linalg.solve(terms(a, b), values).swapaxes(1, 2), dtype=np.float64)


def equations(X: Array) -> Array:
    """Return the 14 values of frames (..., 4, 4), shape (..., 14)."""
    p, z = X[..., :3, 3], X[..., :3, 2]
    pp, pz = (p * p).sum(axis=-1, keepdims=True), (p * z).sum(axis=-1, keepdims=True)
    return np.concatenate((p, z, pp, pz, np.cross(p, z), pp * z - 2.0 * pz * p), axis=-1)


def terms(one: Array, other: Array) -> Array:
    """Return s·s, s·c, c·s, c·c, s, c of the one, s, c of the other, 1, shape (k, 9)."""
    s, c, t, d = np.sin(one), np.cos(one), np.sin(other), np.cos(other)
    return np.stack((s * t, s * d, c * t, c * d, s, c, t, d, np.ones(len(s))), axis=-1)


def _half() -> Array:
    """Return the nine terms in half tangents x, y, times (1 + x²)·(1 + y²), over x²y², x²y, x², xy², …, 1."""
    s, c, one = np.array([0.0, 2.0, 0.0]), np.array([-1.0, 0.0, 1.0]), np.array([1.0, 0.0, 1.0])
    pairs = ((s, s), (s, c), (c, s), (c, c), (s, one), (c, one), (one, s), (one, c), (one, one))
    return np.array([np.outer(x, y).ravel() for x, y in pairs])


_HALF = _half()


def about_z(angles: Array) -> Array:
    """Return the turns about z by angles (k,), shape (k, 4, 4)."""
    X = np.zeros((len(angles), 4, 4))
    X[:, 0, 0] = X[:, 1, 1] = np.cos(angles)
    X[:, 1, 0] = np.sin(angles)
    X[:, 0, 1] = -X[:, 1, 0]
    X[:, 2, 2] = X[:, 3, 3] = 1.0
    return X
