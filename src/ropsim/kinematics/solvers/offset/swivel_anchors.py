"""Swivel angles at which a joint of an arm with spherical shoulder and wrist meets a limit, in closed form.

With the bend of the elbow given by the pose, the turns of shoulder and wrist are linear in sine and cosine of
the swivel angle ψ: N(ψ) = N₀ + N_c·cos ψ + N_s·sin ψ, each with three angles by Rz(A)·Ry(B)·Rz(C). An angle
at a limit is one equation a + b·cos ψ + c·sin ψ = 0 with at most two roots (Shimizu et al. 2008, section IV):
    A = α:  N₁₂·cos α - N₀₂·sin α = 0,    B = β:  N₂₂ - cos β = 0,    C = γ:  N₂₀·sin γ + N₂₁·cos γ = 0.
"""

import numpy as np

from ropsim.spatial import Array, frozen

THIRDS: Array = frozen(2.0 * np.pi / 3.0 * np.arange(3))
"""Swivel angles from which the coefficients are computed [rad]."""
TOUCHING = 1e-4
"""A cosine of a root so far beyond 1 is a limit that is nearly touched: an arm near to its class may."""
TRIED = np.pi / 4.0 * np.arange(8)
"""Swivel angles for branches that meet no limit [rad]."""
JOINTS = ((0, 1, 2), (4, 5, 6))
"""Joints of shoulder and wrist."""


def swivels_at(turns: Array, place: int, angle: float) -> list[float]:
    """Return the swivel angles at which one of the angles of a shoulder or wrist has a value.

    Args:
        turns: N at the swivel angles `THIRDS`, shape (3, 3, 3).
        place: 0, 1 or 2 for A, B or C; a flip of the joint, A + π, -B, C + π, counts as the same.
        angle: its value [rad].

    Returns:
        Up to two angles [rad].
    """
    s, c = np.sin(angle), np.cos(angle)
    if place == 0:
        values = turns[:, 1, 2] * c - turns[:, 0, 2] * s
    elif place == 1:
        values = turns[:, 2, 2] - c
    else:
        values = turns[:, 2, 0] * s + turns[:, 2, 1] * c
    constant = float(values.mean())
    cosine, sine = (float(values @ part(THIRDS)) * 2.0 / 3.0 for part in (np.cos, np.sin))
    size = float(np.hypot(cosine, sine))
    if not abs(constant) <= size * (1.0 + TOUCHING):  # true for NaN
        return []
    if size == 0.0:
        return [0.0]
    middle, half = np.arctan2(sine, cosine), np.arccos(np.clip(-constant / size, -1.0, 1.0))
    return [float(middle + half), float(middle - half)] if half > 0.0 else [float(middle)]


def straight_swivels(turns: Array) -> list[float]:
    """Return the two swivel angles at which B of a shoulder or wrist is least and greatest [rad]."""
    values = turns[:, 2, 2]
    middle = float(np.arctan2(values @ np.sin(THIRDS), values @ np.cos(THIRDS)))
    return [middle, middle + np.pi]
