"""Running maxima of the judged quantities, in plain loops that numba compiles."""

from ropsim.codegen import Array1, Array2, kernel


@kernel
def enter_rows(
    q: Array2,
    qd: Array2,
    limits: Array2,
    table: Array2,
    tick: float,
    worst: Array2,
    log: Array2,
    row: int,
    first: int,
    every: int,
) -> None:
    """Enter the ways beyond the ranges of the joints, and their speeds, into the table of a tally, and log.

    Args:
        q: coordinates at ticks in a row [rad | m], shape (ticks, n).
        qd: speeds at these [rad/s | m/s], shape (ticks, n).
        limits: of the coordinates, the lower ones first [rad | m], shape (2, n).
        table: of the tally, ways and then speeds, shape (4, 2·n); see `Tally.table`.
        tick: of the first row.
        worst: room to work in, shape (2, n).
        log: coordinates and speeds side by side, shape (rows, 2·n).
        row: of the log, the first one that is written.
        first: which tick stands there, counted from 0; `ticks` or more for no row of the log.
        every: ticks from one row of the log to the next.
    """
    n = q.shape[1]
    for j in range(n):
        worst[0, j], worst[1, j] = table[0, j], table[0, n + j]
    for k in range(q.shape[0]):
        for j in range(n):
            beyond, speed = max(q[k, j] - limits[1, j], limits[0, j] - q[k, j]), abs(qd[k, j])
            worst[0, j] = beyond if beyond > worst[0, j] else worst[0, j]
            worst[1, j] = speed if speed > worst[1, j] else worst[1, j]
        if k == first:
            for j in range(n):
                log[row, j], log[row, n + j] = q[k, j], qd[k, j]
            row, first = row + 1, first + every
    for j in range(n):
        if worst[0, j] > table[0, j]:
            table[0, j] = worst[0, j]
            k = 0
            while max(q[k, j] - limits[1, j], limits[0, j] - q[k, j]) != worst[0, j]:
                k += 1
            table[1, j] = tick + k
        if worst[1, j] > table[0, n + j]:
            table[0, n + j] = worst[1, j]
            k = 0
            while abs(qd[k, j]) != worst[1, j]:
                k += 1
            table[1, n + j] = tick + k


@kernel
def merge_tables(table: Array2, other: Array2, tick: float) -> None:
    """Enter the table of another tally, of later ticks.

    Args:
        table: of the tally, shape (4, width); see `Tally.table`.
        other: of the other one, its ticks counted from its beginning, shape (4, width).
        tick: of that beginning.
    """
    for j in range(table.shape[1]):
        if other[0, j] > table[0, j]:
            table[0, j] = other[0, j]
            table[1, j] = tick + other[1, j]
        table[2, j] += other[2, j]
        if other[2, j] > 0.0:
            table[3, j] = tick + other[3, j]


@kernel
def greatest(values: Array1, spans: Array2, found: Array1) -> None:
    """Write the greatest of some values in a row, again and again.

    Args:
        values: none of them below 0; NaN counts as 0, shape (k,).
        spans: number of the first value to check, and behind the last one, shape (m, 2).
        found: where the answers go, 0 if there are none to check, shape (m,).
    """
    for m in range(spans.shape[0]):
        most = 0.0
        for k in range(int(spans[m, 0]), int(spans[m, 1])):
            most = values[k] if values[k] > most else most
        found[m] = most


@kernel
def peaks(rows: Array2, found: Array1) -> None:
    """Write the largest magnitudes in the columns of rows (k, n), shape (n,), 0 without a row."""
    for j in range(rows.shape[1]):
        found[j] = 0.0
    for k in range(rows.shape[0]):
        for j in range(rows.shape[1]):
            size = abs(rows[k, j])
            found[j] = size if size > found[j] else found[j]
