"""Bounds along straight paths, one stage each, in loops that numba compiles."""

from math import nan, sqrt

from ropsim.codegen import kernel
from ropsim.controller.bends_kernel import TINY
from ropsim.controller.stages_kernel import straight_stage
from ropsim.motion import LINE_LENGTH, ROLL, VELOCITY, WAY
from ropsim.spatial import Array


@kernel("void(f8[:,:,::1], f8[:,:,::1], f8[::1], f8[::1], f8[:,::1])")
def joint_line_stages(ends: Array, limits: Array, whose: Array, d1: Array, out: Array) -> None:
    """Write the stages of k joint lines, see `straight_stage`.

    Args:
        ends: joint coordinates at both ends of each [rad | m], shape (k, 2, n).
        limits: of speed, acceleration and jerk of the joints, shape (l, 3, n).
        whose: which of them hold on each line, shape (k,).
        d1: room to work in, shape (n,).
        out: where length, speed, acceleration and jerk go, shape (k, 4).
    """
    for k in range(ends.shape[0]):
        own = limits[int(whose[k])]
        for j in range(d1.shape[0]):
            d1[j] = abs(ends[k, 1, j] - ends[k, 0, j])
        straight_stage(1.0, d1, own[0], own[1], own[2], out[k : k + 1])


@kernel("void(f8[:,::1], f8[::1], f8[:,::1], f8[::1], f8[:,::1])")
def line_stages(lines: Array, lengths: Array, limits: Array, whose: Array, out: Array) -> None:
    """Write the stages of parts of k lines of the tool; the speed is NaN where the tool rolls as it swings.

    Args:
        lines: numbers of each, see `Line`, shape (k, `LINE_SIZE`).
        lengths: of the parts, shape (k,).
        limits: of the tool, see `ToolLimits.all`, shape (l, 6).
        whose: which of them hold on each line, shape (k,).
        out: where length, speed, acceleration and jerk go, shape (k, 4).
    """
    for k in range(lines.shape[0]):
        line, own = lines[k], limits[int(whose[k])]
        share = 1.0 / line[LINE_LENGTH]
        way, turn = max(_size(line[WAY:], share), TINY), max(_size(line[VELOCITY:], share), TINY)
        out[k, 0] = lengths[k]
        for i in range(3):
            out[k, 1 + i] = min(own[i] / way, own[3 + i] / turn)
        if line[ROLL] != 0.0:
            out[k, 1] = nan


def _size(row: Array, share: float) -> float:
    """Return how long the first three numbers of a row are together, each times a share."""
    x, y, z = row[0] * share, row[1] * share, row[2] * share
    return sqrt(x * x + y * y + z * z)
