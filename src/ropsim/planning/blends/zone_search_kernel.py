"""Where an arm on paths of its joints leaves zones with its tool, in a loop that numba compiles."""

from typing import NamedTuple

import numpy as np

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.kinematics import POSES, forward_rows
from ropsim.motion import (
    FOUND_PARAMETER,
    MOST_SAMPLES,
    SAMPLE_COUNT,
    SAMPLE_PARAMETERS,
    SAMPLE_SQUARES,
    SEARCH_STATE,
    SYNCHRONISED,
    joint_rows,
    line_points,
    next_samples,
)
from ropsim.spatial import Array

LENGTH, ZONE, CLIP, FROM_END, KIND, BEGIN, WHOLE, FIRST, LAST = range(9)
"""Columns of requests, see `zones_of_arm`."""
PARAMETER, DISTANCE = range(2)
"""Columns of results."""
PARAMETERS, STATE = 3, 4
"""Rows of samples, behind those of `next_samples`."""
COUNT, ENDS, CENTRED, X, Y, Z, HELD = range(7)
"""State of a search: the number of samples, 0 at its end; 1 once the path parameter is found, and once the
centre of the zone is known; that centre [m]; the size of the state.
"""


class SearchPaths(NamedTuple):
    """Paths of the joints of an arm, and the nodes of a search.

    Attributes:
        shares: as for `next_samples`.
        nodes: as for `next_samples`.
        chain: `ChainArrays.flat` of the arm, of m steps.
        spread: `ChainArrays.spread`, shape (m or 0, n + 1).
        rows: of all paths, see `PathRows`, shape (r, n).
        tcps: in the frame of the interface [m], shape (k, 3).
    """

    shares: Array1
    nodes: Array2
    chain: Array1
    spread: Array2
    rows: Array2
    tcps: Array2


class SearchWork(NamedTuple):
    """Work buffers of s searches side by side.

    Attributes:
        samples: shape (s, 5, `MOST_SAMPLES`).
        held: shape (s, `HELD`).
        points: shape (3, `MOST_SAMPLES`, n).
        steps: shape (s·`MOST_SAMPLES`, m).
        poses_at: shape (s·`MOST_SAMPLES`, 4, 4).
        poses: shape (`POSES`,).
    """

    samples: Array3
    held: Array2
    points: Array3
    steps: Array2
    poses_at: Array3
    poses: Array1

    @classmethod
    def of(cls, searches: int, n: int, m: int) -> "SearchWork":
        """Return buffers for searches side by side with an arm of n joints and m steps."""
        total = searches * MOST_SAMPLES
        return cls(
            np.empty((searches, 5, MOST_SAMPLES)),
            np.empty((searches, HELD)),
            np.empty((3, MOST_SAMPLES, n)),
            np.empty((total, m)),
            np.empty((total, 4, 4)),
            np.empty(POSES),
        )


@kernel
def zones_of_arm(paths: SearchPaths, requested: Array2, work: SearchWork) -> None:
    """Search on k paths for the path parameters at which the TCP is at a distance from an end of each.

    Args:
        paths: of the arm.
        requested: length of each path, the zone [m], greatest distance from that end along the path, 1.0 for
            the end of the path, 0.0 for its start; then kind, begin and length of `PathRows`, the first row
            of the path and that after its last one; becomes the path parameter, and the distance of the TCP
            there [m]; shape (k, 9).
        work: buffers.
    """
    samples, held, poses_at, poses = work.samples, work.held, work.poses_at, work.poses
    for i in range(POSES):
        poses[i] = 0.0
    for first in range(0, requested.shape[0], samples.shape[0]):
        beyond = min(first + samples.shape[0], requested.shape[0])
        own, tools = requested[first:beyond], paths.tcps[first:beyond]
        for k in range(own.shape[0]):
            held[k, COUNT], held[k, ENDS], held[k, CENTRED] = 1.0, 0.0, 0.0
            for i in range(SEARCH_STATE):
                samples[k, STATE, i] = 0.0
        count = _ask(paths, own, work)
        while count > 0:
            forward_rows(paths.chain, work.steps[:count], poses_at[:count], poses)
            _answer(tools, poses_at, own, samples, held)
            count = _ask(paths, own, work)


def _ask(paths: SearchPaths, requested: Array, work: SearchWork) -> int:
    """Write coordinates at the next samples of all searches, and return the number of these."""
    samples, held, points, total = work.samples, work.held, work.points, 0
    for k in range(requested.shape[0]):
        if held[k, ENDS] != 0.0:
            held[k, COUNT] = 0.0
        if held[k, COUNT] == 0.0:
            continue
        one, parameters, state = requested[k], samples[k, PARAMETERS], samples[k, STATE]
        next_samples(paths.shares, paths.nodes, one[ZONE], one[CLIP], samples[k], state)
        count = int(state[SAMPLE_COUNT])
        if count == 0:  # the distance at the path parameter that was found
            count, held[k, ENDS] = 1, 1.0
            samples[k, SAMPLE_PARAMETERS, 0] = state[FOUND_PARAMETER]
        held[k, COUNT] = count
        for i in range(count):
            s = samples[k, SAMPLE_PARAMETERS, i]
            parameters[i] = one[LENGTH] - s if one[FROM_END] != 0.0 else s
        if held[k, ENDS] != 0.0:
            one[PARAMETER] = parameters[0]
        for i in range(count):
            parameters[i] += one[BEGIN]
        path = paths.rows[int(one[FIRST]) : int(one[LAST])]
        if one[KIND] == SYNCHRONISED:
            joint_rows(path[0], path[1], path[2:], one[WHOLE], parameters[:count], points)
        else:
            line_points(path[0], path[1], parameters[:count], points)
        _move_steps(paths.spread, points[0], count, work.steps[total:])
        total += count
    return total


def _answer(tcps: Array, poses_at: Array, requested: Array, samples: Array, held: Array) -> None:
    """Write the squared distances of the TCP from the centre, which is its position at the first sample."""
    at = 0
    for k in range(requested.shape[0]):
        tcp, count = tcps[k], int(held[k, COUNT])
        for i in range(count):
            pose = poses_at[at + i]
            u = pose[0, 0] * tcp[0] + pose[0, 1] * tcp[1] + pose[0, 2] * tcp[2] + pose[0, 3]
            v = pose[1, 0] * tcp[0] + pose[1, 1] * tcp[1] + pose[1, 2] * tcp[2] + pose[1, 3]
            w = pose[2, 0] * tcp[0] + pose[2, 1] * tcp[1] + pose[2, 2] * tcp[2] + pose[2, 3]
            if held[k, CENTRED] == 0.0:
                held[k, CENTRED], held[k, X], held[k, Y], held[k, Z] = 1.0, u, v, w
            x, y, z = u - held[k, X], v - held[k, Y], w - held[k, Z]
            samples[k, SAMPLE_SQUARES, i] = x * x + y * y + z * z
        if held[k, ENDS] != 0.0 and count:
            requested[k, DISTANCE] = samples[k, SAMPLE_SQUARES, 0] ** 0.5
        at += count


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
