"""Arrays that kernels see in another shape."""

import numpy as np

from ropsim.codegen import Array1, Array3, as_row, as_table, kernel
from support.in_python import in_python


@kernel
def turned_over(room: Array1, rows: Array3, told: Array1) -> None:
    """Write the numbers of the second table backwards to a table that begins behind the first number."""
    numbers, table = as_row(rows[1]), as_table(room[1:], 2, 3)
    told[0], told[1], told[2] = numbers.shape[0], table.shape[0], table.shape[1]
    for i in range(2):
        for j in range(3):
            table[i, j] = numbers[5 - 3 * i - j]


def test_an_array_in_another_shape_has_the_same_memory() -> None:
    for write in (turned_over, in_python(turned_over)):
        room, rows, told = np.zeros(9), np.arange(12.0).reshape(2, 3, 2), np.zeros(3)
        write(room, rows, told)
        assert told.tolist() == [6.0, 2.0, 3.0]
        assert room.tolist() == [0.0, 11.0, 10.0, 9.0, 8.0, 7.0, 6.0, 0.0, 0.0]
