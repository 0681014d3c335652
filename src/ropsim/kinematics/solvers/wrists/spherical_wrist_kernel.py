"""Closed-form inverse kinematics of arms with spherical wrist, in loops that numba compiles.

The symbols are defined in `spherical_wrist.py`; the computation of each branch is in `wrist_columns.py`.
"""

from math import cos, sin

from ropsim.codegen import Array1, Array2, Array3, as_table, kernel
from ropsim.kinematics.solvers.wrists.wrist_columns import (
    ANGLES,
    COLUMNS,
    FOUND,
    FRONT,
    LENGTHS,
    MISS,
    PAIRS,
    PLACE,
    SHEET,
    SIDES,
    SIGNS,
    SLACKS,
    X_M,
    ZEROS,
    N,
    coordinate_in_columns,
    place_in_columns,
    reach_in_columns,
    turn_in_columns,
    wrist_in_columns,
)
from ropsim.spatial import Array

WRIST_SLACK = 1e-10
"""With sin β below this, axes 4 and 6 count as aligned; the error made stays below the promised accuracy."""
REACH_SLACK = 1e-10
"""A cosine or a squared length [m²] this far beyond its bound is rounding at the edge of reach."""
AXIS_SLACK = 1e-10
"""A wrist centre this near to axis 1 [m] lies on it."""

TIE = 1e-9
"""A singular configuration belongs to two branches; within this [m, rad] it is given the first one."""

ROOM_OF_ROWS = 6 + SHEET * COLUMNS
"""Size of the work array, the first six joint coordinates that a singular pose keeps."""
_EACH = 4
"""Branches of a pose, not counting the flip of the wrist, which is only a change of signs."""


@kernel
def inverse_rows(arm: Array1, room: Array1, T: Array3, out: Array3) -> None:
    """Write all branches of every pose X_BM in T (k, 4, 4) to out (k, 8, 6), NaN where absent.

    Args:
        arm: `WristArm.flat`.
        room: joint coordinates [rad] of which q1 and q4 hold where the pose leaves them free (6 numbers), and
            room to work in; shape (ROOM_OF_ROWS,).
        T: poses.
        out: row 4·shoulder + 2·elbow + wrist holds that posture, angles in (-π, π].
    """
    sheet = as_table(room[6:], SHEET, COLUMNS)
    together = COLUMNS // _EACH
    for first in range(0, T.shape[0], together):
        for k in range(together):
            for way in range(_EACH):
                _ask(arm, T[min(first + k, T.shape[0] - 1)], 2 * way, sheet, _EACH * k + way)
        _answer(arm, room, sheet)
        for k in range(min(together, T.shape[0] - first)):
            for way in range(_EACH):
                for flip in range(2):
                    _tell(sheet, _EACH * k + way, flip, out[first + k, 2 * way + flip])


@kernel
def inverse_branch(arm: Array1, room: Array1, T: Array3, row: int, out: Array2) -> None:
    """Write one branch of every pose, as `inverse_rows` does all of them.

    Args:
        arm: `WristArm.flat`.
        room: as there.
        T: poses X_BM, shape (k, 4, 4).
        row: of the branch.
        out: where it goes, NaN where absent, shape (k, 6).
    """
    sheet = as_table(room[6:], SHEET, COLUMNS)
    for first in range(0, T.shape[0], COLUMNS):
        for k in range(COLUMNS):
            _ask(arm, T[min(first + k, T.shape[0] - 1)], row, sheet, k)
        _answer(arm, room, sheet)
        for k in range(min(COLUMNS, T.shape[0] - first)):
            _tell(sheet, k, row % 2, out[first + k])


@kernel
def wrist_posture(arm: Array1, q: Array1, side: float, told: Array1) -> None:
    """Write to which branch joint coordinates belong, and how near they are to a singular place.

    Args:
        arm: `WristArm.flat`.
        q: joint coordinates [rad], shape (6,).
        side: added to all of them [rad].
        told: set to the row of the branch, and the least of the distance of the wrist centre from axis 1
            along e_x [m] and the sines of elbow and wrist, without their signs; shape (2,).
    """
    shoulder = (q[1] + side) * arm[SIGNS + 1] + arm[ZEROS + 1]
    elbow = (q[2] + side) * arm[SIGNS + 2] + arm[ZEROS + 2]
    wrist = (q[4] + side) * arm[SIGNS + 4] + arm[ZEROS + 4]
    front = arm[FRONT]
    ahead = arm[LENGTHS] + arm[LENGTHS + 3] * cos(shoulder) + arm[LENGTHS + 4] * cos(shoulder + elbow)
    bend, flip = sin(elbow), sin(wrist)
    above = -bend if ahead * front > TIE else bend
    row = 4 if ahead * front > TIE else 0
    row += 0 if above * front >= -TIE else 2
    told[0], told[1] = row + (1 if flip > TIE else 0), min(abs(ahead), abs(bend), abs(flip))


def _ask(arm: Array, X: Array, row: int, sheet: Array, column: int) -> None:
    """Write a pose and the signs of a branch to a column."""
    for i in range(3):
        for j in range(3):
            sheet[3 * i + j, column] = X[i, j]
        sheet[9 + i, column] = X[i, 3]
    front, shoulder, elbow = arm[FRONT], row // 4, row // 2 % 2
    sheet[SIDES, column] = front if shoulder == 1 else -front
    sheet[SIDES + 1, column] = front if elbow == shoulder else -front


def _answer(arm: Array, room: Array, sheet: Array) -> None:
    """Write the joint coordinates of the requested branches."""
    free1, free4 = arm[SIGNS] * room[0] + arm[ZEROS], arm[SIGNS + 3] * room[3] + arm[ZEROS + 3]
    for c in range(4):
        a, b, d = arm[X_M + c], arm[X_M + 4 + c], arm[X_M + 8 + c]
        x, y, z = (PLACE + c, PLACE + 3 + c, PLACE + 6 + c) if c < 3 else (PLACE + 9, PLACE + 10, PLACE + 11)
        centre = 1.0 if c == 3 else 0.0
        place_in_columns(COLUMNS, arm, a, b, d, centre, sheet, sheet[x], sheet[y], sheet[z])
    reach_in_columns(COLUMNS, arm, cos(free1), sin(free1), sheet)
    pairs = sheet[PAIRS : PAIRS + 4]
    for c in range(3):
        x, one = PLACE + c, N + c
        turn_in_columns(
            COLUMNS,
            arm,
            pairs,
            sheet[x],
            sheet[x + 3],
            sheet[x + 6],
            sheet[one],
            sheet[one + 3],
            sheet[one + 6],
        )
    wrist_in_columns(COLUMNS, arm, cos(free4), sin(free4), sheet)
    for i in range(9):
        j = i if i < 6 else i - 3
        coordinate_in_columns(
            COLUMNS,
            arm[SIGNS + j],
            arm[ZEROS + j],
            arm[SLACKS],
            sheet[ANGLES + i],
            sheet[MISS],
            sheet[FOUND + i],
        )


def _tell(sheet: Array, column: int, flip: int, q: Array) -> None:
    """Write the joint coordinates in a column."""
    for j in range(6):
        q[j] = sheet[FOUND + (j if flip == 1 or j < 3 else j + 3), column]
