"""Where an arm on a path of its joints leaves a zone with its tool, in a loop that numba compiles."""

from ropsim.codegen import kernel
from ropsim.kinematics import POSES, forward_rows
from ropsim.motion import (
    LOOK_COUNT,
    LOOK_FOUND,
    LOOK_SQUARES,
    LOOK_STATE,
    LOOK_WAYS,
    SYNCHRONISED,
    joint_rows,
    line_points,
    look_further,
)
from ropsim.spatial import Array

LENGTH, ZONE, CLIP, FROM_END, KIND, BEGIN, WHOLE, FIRST, LAST = range(9)
"""What is asked for, see `zone_of_arm`; the last two see `zones_of_arm`."""
PLACE, DISTANCE = range(2)
"""What becomes of it."""


@kernel(
    "void(f8[::1], f8[:,::1], f8[:,::1], f8[::1], f8[:,::1], f8[::1], f8[::1],"
    " f8[:,::1], f8[:,:,::1], f8[:,::1], f8[:,:,::1], f8[::1])"
)
def zone_of_arm(
    shares: Array,
    nodes: Array,
    rows: Array,
    chain: Array,
    spread: Array,
    tcp: Array,
    asked: Array,
    looks: Array,
    points: Array,
    steps: Array,
    X: Array,
    poses: Array,
) -> None:
    """Search for the place at which the TCP is in a distance from where it is at an end of the path.

    Args:
        shares: as for `look_further`, and so are nodes.
        nodes: see there.
        rows: of the path, see `PathRows`, shape (l, n).
        chain: `ChainArrays.flat` of the arm, of m steps.
        spread: `ChainArrays.spread`, shape (m or 0, n + 1).
        tcp: in the frame of the interface [m], shape (3,).
        asked: length of the path, the zone [m], how far from that end it may be found at most, 1.0 for the
            end of the path, 0.0 for its start; then kind, begin and length of `PathRows`; becomes the place,
            and the distance of the TCP there [m]; shape (7,).
        looks: room to work in, shape (5, `MOST_LOOKS`).
        points: room to work in, shape (3, `MOST_LOOKS`, n).
        steps: room to work in, shape (`MOST_LOOKS`, m).
        X: room to work in, shape (`MOST_LOOKS`, 4, 4).
        poses: room to work in, shape (`POSES`,).
    """
    places, state = looks[3], looks[4]
    for i in range(LOOK_STATE):
        state[i] = 0.0
    for i in range(POSES):
        poses[i] = 0.0
    length, from_end, begin = asked[LENGTH], asked[FROM_END] != 0.0, asked[BEGIN]
    x = y = z = 0.0
    first, last = True, False
    while not last:
        look_further(shares, nodes, asked[ZONE], asked[CLIP], looks, state)
        count = int(state[LOOK_COUNT])
        last = count == 0
        if last:  # how far it is at the place that was found
            count = 1
            looks[LOOK_WAYS, 0] = state[LOOK_FOUND]
        for i in range(count):
            places[i] = length - looks[LOOK_WAYS, i] if from_end else looks[LOOK_WAYS, i]
        asked[PLACE] = places[0]
        for i in range(count):
            places[i] += begin
        if asked[KIND] == SYNCHRONISED:
            joint_rows(rows[0], rows[1], rows[2:], asked[WHOLE], places[:count], points)
        else:
            line_points(rows[0], rows[1], places[:count], points)
        _move_steps(spread, points[0], count, steps)
        forward_rows(chain, steps[:count], X[:count], poses)
        for i in range(count):
            u = X[i, 0, 0] * tcp[0] + X[i, 0, 1] * tcp[1] + X[i, 0, 2] * tcp[2] + X[i, 0, 3]
            v = X[i, 1, 0] * tcp[0] + X[i, 1, 1] * tcp[1] + X[i, 1, 2] * tcp[2] + X[i, 1, 3]
            w = X[i, 2, 0] * tcp[0] + X[i, 2, 1] * tcp[1] + X[i, 2, 2] * tcp[2] + X[i, 2, 3]
            if first:
                x, y, z, first = u, v, w, False
            looks[LOOK_SQUARES, i] = (u - x) * (u - x) + (v - y) * (v - y) + (w - z) * (w - z)
    asked[DISTANCE] = looks[LOOK_SQUARES, 0] ** 0.5


@kernel(
    "void(f8[::1], f8[:,::1], f8[::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[:,::1],"
    " f8[:,::1], f8[:,:,::1], f8[:,::1], f8[:,:,::1], f8[::1])"
)
def zones_of_arm(
    shares: Array,
    nodes: Array,
    chain: Array,
    spread: Array,
    rows: Array,
    tcps: Array,
    asked: Array,
    looks: Array,
    points: Array,
    steps: Array,
    X: Array,
    poses: Array,
) -> None:
    """Do the same for k paths of one arm, one after the other.

    Args:
        shares: as for `zone_of_arm`, and so are all that are not named here.
        nodes: see there.
        chain: see there.
        spread: see there.
        rows: of all paths, shape (r, n).
        tcps: in the frame of the interface [m], shape (k, 3).
        asked: as there, and behind that the first row of each path and that after its last one, shape (k, 9).
        looks: see there.
        points: see there.
        steps: see there.
        X: see there.
        poses: see there.
    """
    for k in range(asked.shape[0]):
        own = rows[int(asked[k, FIRST]) : int(asked[k, LAST])]
        zone_of_arm(shares, nodes, own, chain, spread, tcps[k], asked[k], looks, points, steps, X, poses)


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
