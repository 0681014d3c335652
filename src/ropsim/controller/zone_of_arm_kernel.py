"""Where an arm on a path of its joints leaves a zone with its tool, in a loop that numba compiles."""

from ropsim.codegen import kernel
from ropsim.controller.stretch_kernel import points_on
from ropsim.kinematics import forward_rows
from ropsim.motion import LOOK_COUNT, LOOK_FOUND, LOOK_SQUARES, LOOK_WAYS, look_further
from ropsim.spatial import Array

PLACES, NUMBERS, ROWS = 3, 4, 5
"""Rows of looks behind those of `look_further`: places to look at, and the numbers of their pieces."""


@kernel(
    "void(f8[::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[:,:,::1], f8[::1], f8[:,::1], f8[::1], f8[::1],"
    " f8[:,::1], f8[:,:,::1], f8[:,::1], f8[:,:,::1], f8[::1])"
)
def zone_of_arm(
    shares: Array,
    nodes: Array,
    piece: Array,
    rows: Array,
    slopes: Array,
    chain: Array,
    spread: Array,
    tcp: Array,
    asked: Array,
    looks: Array,
    points: Array,
    steps: Array,
    X: Array,
    state: Array,
) -> None:
    """Search for the place at which the TCP is in a distance from where it is at an end of the path.

    Args:
        shares: as for `look_further`, and so are nodes.
        nodes: see there.
        piece: the path as a piece of a `WalkTable`, shape (1, 6).
        rows: of the path, shape (l, n).
        slopes: likewise, shape (2, l or 0, n).
        chain: `ChainArrays.flat` of the arm.
        spread: `ChainArrays.spread`, shape (m or 0, n + 1).
        tcp: in the frame of the interface [m], shape (3,).
        asked: length of the path, the zone [m], how far from that end it may be found at most, and 1.0 for
            the end of the path, 0.0 for its start; becomes the place, and the distance of the TCP there [m].
        looks: room to work in, shape (`ROWS`, `MOST_LOOKS`).
        points: room to work in, shape (3, `MOST_LOOKS`, n).
        steps: room to work in, shape (`MOST_LOOKS`, m).
        X: room to work in, shape (`MOST_LOOKS`, 4, 4).
        state: of the search, zeros, shape (`LOOK_STATE`,).
    """
    length, ends = asked[0], asked[3] != 0.0
    for i in range(looks.shape[1]):
        looks[NUMBERS, i] = 0.0
    x = y = z = 0.0
    first = True
    look_further(shares, nodes, asked[1], asked[2], looks, state)
    while True:
        count = int(state[LOOK_COUNT])
        last = count == 0
        if last:  # how far it is at the place that was found
            count = 1
            looks[LOOK_WAYS, 0] = state[LOOK_FOUND]
        for i in range(count):
            looks[PLACES, i] = length - looks[LOOK_WAYS, i] if ends else looks[LOOK_WAYS, i]
        if last:
            asked[0] = looks[PLACES, 0]
        points_on(0, piece, rows, slopes, looks[NUMBERS, :count], looks[PLACES, :count], points[:, :count])
        _move_steps(spread, points[0], count, steps)
        forward_rows(chain, steps[:count], X[:count])
        for i in range(count):
            u = X[i, 0, 0] * tcp[0] + X[i, 0, 1] * tcp[1] + X[i, 0, 2] * tcp[2] + X[i, 0, 3]
            v = X[i, 1, 0] * tcp[0] + X[i, 1, 1] * tcp[1] + X[i, 1, 2] * tcp[2] + X[i, 1, 3]
            w = X[i, 2, 0] * tcp[0] + X[i, 2, 1] * tcp[1] + X[i, 2, 2] * tcp[2] + X[i, 2, 3]
            if first:
                x, y, z, first = u, v, w, False
            looks[LOOK_SQUARES, i] = (u - x) * (u - x) + (v - y) * (v - y) + (w - z) * (w - z)
        if last:
            break
        look_further(shares, nodes, asked[1], asked[2], looks, state)
    asked[1] = looks[LOOK_SQUARES, 0] ** 0.5


def _move_steps(spread: Array, Q: Array, count: int, steps: Array) -> None:
    """Write the coordinates of the steps of an arm for those of its axes; see `ChainArrays`."""
    n = Q.shape[1]
    for i in range(count):
        for k in range(steps.shape[1]):
            if spread.shape[0] == 0:
                steps[i, k] = Q[i, k]
            else:
                total = 0.0
                for j in range(n):
                    total += Q[i, j] * spread[k, j]
                steps[i, k] = total + spread[k, n]
