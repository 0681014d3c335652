"""Lines one behind another and the joints that are led along all of them, in one loop."""

from ropsim.codegen import kernel
from ropsim.controller.density import MOST_DENSITY, SMOOTH
from ropsim.controller.lead_kernel import follow_wrist
from ropsim.controller.move_check import MAX_COORDINATE
from ropsim.controller.part_times_kernel import longest_cell
from ropsim.controller.samples_kernel import line_samples
from ropsim.kinematics import POSES, ROOM_OF_ROWS, write_pose_product, write_tool_pose
from ropsim.motion import LINE_LENGTH, line_numbers, rows_with_roughness
from ropsim.spatial import Array

SHEETS = 8
"""So many tables of rows are room to work in."""
ROOM = max(POSES, ROOM_OF_ROWS + 2)
"""So many numbers are room to work in, besides two for each row that a line has at most."""


@kernel(
    "void(f8[::1], f8[::1], f8[:,::1], f8[:,::1], f8[:,:,::1], f8[::1], f8, f8, f8, f8, i8,"
    " f8[::1], f8[::1], f8[:,::1],"
    " f8[:,::1], f8[::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[::1], f8[:,::1],"
    " f8[:,:,::1], f8[:,:,::1], f8[::1])"
)
def lead_lines(
    chain: Array,
    arm: Array,
    axes: Array,
    inner: Array,
    sided: Array,
    max_speeds: Array,
    close: float,
    slack: float,
    way: float,
    turn: float,
    drives: int,
    X_BK: Array,
    X_MT: Array,
    X_TM: Array,
    targets: Array,
    q_start: Array,
    poses: Array,
    numbers: Array,
    q: Array,
    derivatives: Array,
    told: Array,
    sheets: Array,
    T: Array,
    work: Array,
) -> None:
    """Write lines to targets, each from that before, and the joints of an arm with spherical wrist on them.

    What is written of a line is what `line_numbers`, `line_samples`, `lead_wrist` and `longest_cell` write.
    It ends at the first one that has no length, is not followed, is not smooth with the rows for which there
    is room, or ends where no cell is.

    Args:
        chain: of the arm, as `write_tool_pose` takes it; its steps are the axes.
        arm: as `inverse_rows` takes it.
        axes: as for `follow_row`.
        inner: as for `rows_with_roughness`.
        sided: likewise.
        max_speeds: of the joints [rad/s], shape (6,).
        close: as for `follow_row`.
        slack: likewise.
        way: as for `line_samples`.
        turn: likewise.
        drives: as for `line_numbers`.
        X_BK: task frame, position [m] and unit quaternion (w, x, y, z), shape (7,); without numbers (0,)
            where targets are in the base frame.
        X_MT: tool, likewise, shape (7,).
        X_TM: its inverse, shape (4, 4).
        targets: X_KT, likewise, shape (m, 7).
        q_start: joint coordinates at the start [rad], shape (6,).
        poses: where X_BT of the start and of the targets go, likewise, shape (m + 1, 7).
        numbers: where those of the lines go, shape (m, SIZE).
        q: where the rows of all lines go, one behind the other [rad], shape (r, 6).
        derivatives: where those of each line go, twelve numbers for each of its rows: first all first ones by
            the number of the row, then the second ones; shape (12·r,).
        told: becomes the number of rows of each line, 0 for one that is not led, behind which nothing is
            written, and the time that `longest_cell` tells [s], shape (m, 2).
        sheets: room to work in, shape (SHEETS, most, 6), most > LOOKS, most >= 8.
        T: room for poses, shape (most, 4, 4).
        work: room to work in, shape (ROOM + 2·most,).
    """
    single, d, at = sheets[7], sheets[2:4], 0
    for j in range(6):
        single[0, j] = q_start[j]
    write_tool_pose(chain, single[:1], X_MT[:3], X_MT[3:], T[:1], work, poses[0])
    for i in range(targets.shape[0]):
        told[i, 0] = 0.0
        X, line = poses[i + 1], numbers[i]
        for j in range(3):
            if not abs(targets[i, j]) <= MAX_COORDINATE:
                return
        if X_BK.shape[0] > 0:
            write_pose_product(X_BK, targets[i], X)
        else:
            for j in range(7):
                X[j] = targets[i, j]
        line_numbers(poses[i][:3], poses[i][3:], X[:3], X[3:], drives, line)
        begin = q_start if at == 0 else q[at - 1]
        count = _lead_line(
            arm, axes, inner, sided, close, slack, way, turn, X_TM, line, begin, q[at:], sheets, T, work
        )
        if count == 0:
            return
        longest_cell(q[at : at + count], d, max_speeds, told[i, 1:])
        for order in range(2):
            for k in range(count):
                first = 12 * at + 6 * (count * order + k)
                for j in range(6):
                    derivatives[first + j] = d[order, k, j]
        told[i, 0] = count
        at += count


def _lead_line(
    arm: Array,
    axes: Array,
    inner: Array,
    sided: Array,
    close: float,
    slack: float,
    way: float,
    turn: float,
    X_TM: Array,
    line: Array,
    q_start: Array,
    q: Array,
    sheets: Array,
    T: Array,
    work: Array,
) -> int:
    """Write the rows of one line to q, their derivatives to the third and fourth sheet; return their number.

    It is 0 where the line is not led.
    """
    most, length, density = T.shape[0], line[LINE_LENGTH], 1
    s, rough, free, answer = (
        work[:most],
        work[most : 2 * most],
        work[2 * most :],
        work[2 * most + ROOM_OF_ROWS :],
    )
    while length > 0.0:
        line_samples(way, turn, X_TM, density, length, line, s, sheets[:2], T, answer)
        count, density = int(answer[0]), int(answer[1])
        if count == 0 or count > min(most, q.shape[0]):
            return 0
        rows, half = q[:count], count // 2
        follow_wrist(arm, axes, close, slack, T[:count], q_start, rows, sheets[7:8], free, answer)
        if answer[0] == 0.0 or answer[1] == 0.0:
            return 0
        coarse = sheets[4][: half + 1]
        rows_with_roughness(rows, inner, sided, sheets[2:4], coarse, sheets[5:7], rough[:half])
        worst = 0.0
        for k in range(half):
            worst = max(worst, rough[k])
        if worst <= SMOOTH:
            return count
        density = _denser(density, worst) if density < MOST_DENSITY else 0
        if density == 0:
            return 0
    return 0


def _denser(density: int, rough: float) -> int:
    """Return what `density.denser` does."""
    half, left = 1, rough / SMOOTH
    while left > 64.0 and half < MOST_DENSITY:
        half, left = 2 * half, left / 64.0
    return min(2 * half * density, MOST_DENSITY)
