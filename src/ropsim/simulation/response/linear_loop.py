"""The servo loop of an arm about a rest or a slow motion: four matrices, and how its loops are closed."""

import numpy as np

from ropsim.spatial import Array, record


@record
class LinearLoop:
    """Plant and law about a rest or a slow motion: x⁺ = F·x + G·u, u = K·(x, m, q_ref), m⁺ = L·(x, m, q_ref).

    m is what the law remembers.

    Attributes:
        F: how the state of the plant follows from that a tick before, shape (s, s).
        G: and from the output of the law, shape (s, n).
        K: how that follows from state of the plant, state of the law, and reference, shape (n, s + m + n).
        L: how the state of the law follows from these, shape (m, s + m + n).
        period: control period [s].
        delay: control ticks between an output of the law and the moment when it acts.
    """

    F: Array
    G: Array
    K: Array
    L: Array
    period: float
    delay: int

    @property
    def n(self) -> int:
        """Return the number of axes."""
        return int(self.G.shape[1])

    def closed(self, late: int = 0) -> tuple[Array, Array]:
        """Return A and B of z⁺ = A·z + B·q_ref; z holds the plant, the law, and outputs on their way.

        Args:
            late: control ticks by which outputs act later than they do.

        Returns:
            Shapes (z, z) and (z, n); the coordinates of the joints are the first n numbers of z.
        """
        return self._joined(np.ones(self.n), self.delay + late)

    def given(self) -> Array:
        """Return C of u = C·z, the present inputs of the drives, shape (n, z)."""
        s, m, n = len(self.F), len(self.L), self.n
        C = np.zeros((n, s + m + self.delay * n))
        if self.delay:
            C[:, s + m : s + m + n] = np.eye(n)
        else:
            C[:, : s + m] = self.K[:, : s + m]
        return C

    def broken(self, axis: int) -> tuple[Array, Array, Array]:
        """Return A, b, c of the loop that is open between the law and the drive of one axis: z⁺ = A·z + b·v.

        v goes into that drive at once, c·z is what the law puts out for it; all other axes are controlled.

        Args:
            axis: its number, from 0.
        """
        through = np.ones(self.n)
        through[axis] = 0.0
        A, _ = self._joined(through, self.delay)
        s, m = len(self.F), len(self.L)
        b, c = np.zeros(len(A)), np.zeros(len(A))
        b[:s], c[: s + m] = self.G[:, axis], self.K[axis, : s + m]
        return A, b, c

    def _joined(self, through: Array, late: int) -> tuple[Array, Array]:
        """Return the loop with outputs of the law that pass by shares, some ticks late."""
        s, m, n = len(self.F), len(self.L), self.n
        first, size = s + m, s + m + late * n
        A, B = np.zeros((size, size)), np.zeros((size, n))
        A[:s, :s], A[s:first, :first], B[s:first] = self.F, self.L[:, :first], self.L[:, first:]
        gain, now, reference = self.G * through, self.K[:, :first], self.K[:, first:]
        if late:
            A[:s, first : first + n] = gain
            A[first:-n, first + n :] = np.eye((late - 1) * n)
            A[-n:, :first], B[-n:] = now, reference
        else:
            A[:s, :first] += gain @ now
            B[:s] = gain @ reference
        return A, B
