"""Poses of the tool at the rows of a recording, in plain loops that numba compiles."""

import math

from ropsim.codegen import Array1, Array2, Array3, kernel


@kernel
def tool_poses(poses: Array3, tools: Array3, which: Array1, square: Array2, quaternions: Array2) -> None:
    """Compute poses of the tool from poses of the flange, and write their orientations as unit quaternions.

    The largest of the four components is found first and divides the others (Shepperd 1978), so that no
    rotation loses accuracy.

    Args:
        poses: X_BM at each row, becomes X_BT, shape (k, 4, 4).
        tools: the tool frames X_MT, shape (m, 4, 4).
        which: number of the one that is in force at each row, shape (k,).
        square: room to work in, for 4·q·qᵀ in the end, shape (4, 4).
        quaternions: becomes (w, x, y, z), w >= 0, shape (k, 4).
    """
    for row in range(poses.shape[0]):
        r, tool = poses[row], tools[int(which[row])]
        for i in range(4):
            a, b, c, d = r[i, 0], r[i, 1], r[i, 2], r[i, 3]
            for j in range(4):
                r[i, j] = a * tool[0, j] + b * tool[1, j] + c * tool[2, j] + d * tool[3, j]
        trace = r[0, 0] + r[1, 1] + r[2, 2]
        square[0, 0] = 1.0 + trace
        for i in range(3):
            j, k = (i + 1) % 3, (i + 2) % 3
            square[i + 1, i + 1] = 1.0 + 2.0 * r[i, i] - trace
            square[0, i + 1] = square[i + 1, 0] = r[k, j] - r[j, k]
            square[j + 1, k + 1] = square[k + 1, j + 1] = r[k, j] + r[j, k]
        largest = 0
        for i in range(1, 4):
            if square[i, i] > square[largest, largest]:
                largest = i
        length = 0.0
        for i in range(4):
            length += square[largest, i] * square[largest, i]
        length = math.sqrt(length)
        if square[largest, 0] < 0.0:
            length = -length
        for i in range(4):
            quaternions[row, i] = square[largest, i] / length
