"""The control ticks at which moves, pieces and overlaps of a motion come, in a loop that numba compiles."""

from ropsim.codegen import kernel
from ropsim.controller.stretch_kernel import END, FIRST_PIECE, OVERLAP, START
from ropsim.spatial import Array


@kernel("void(f8[:,::1], f8[::1], f8[::1], f8[::1], f8, f8[:,::1], f8[:,::1], f8[::1])")
def ticks_come(
    runs: Array,
    piece_ends: Array,
    move_ends: Array,
    phi: Array,
    slack: float,
    pieces: Array,
    overlaps: Array,
    moves: Array,
) -> None:
    """Write at which control ticks what comes; a piece counts as far as no other run overlaps it.

    Args:
        runs: see `Course.table`, shape (r, 7).
        piece_ends: see `Course.piece_ends`, shape (p,).
        move_ends: motion times at which moves end [s], shape (m,).
        phi: motion times at the control ticks 1, 2, … [s], shape (ticks,).
        slack: by which motion times may be off [s].
        pieces: where the last tick before each piece goes, and the last one on it, shape (p, 2).
        overlaps: the same for the overlap of each run with the one before, shape (r, 2).
        moves: where the first tick goes, 0 for the start, at which each move has ended, shape (m,).
    """
    count, ticks = runs.shape[0], phi.shape[0]
    for r in range(count):
        start, together = runs[r, START], runs[r, OVERLAP]
        overlaps[r, 0], overlaps[r, 1] = _come(phi, start + slack), _come(phi, start + together + slack)
        begin, end, beyond = start + together, runs[r, END], piece_ends.shape[0]
        if r + 1 < count:
            end, beyond = end - runs[r + 1, OVERLAP], int(runs[r + 1, FIRST_PIECE])
        first, tick = int(runs[r, FIRST_PIECE]), _come(phi, min(max(start, begin), end) + slack)
        for p in range(first, beyond):
            pieces[p, 0] = tick
            time = end if p + 1 == beyond else min(max(start + piece_ends[p], begin), end)
            tick = _come(phi, time + slack)
            pieces[p, 1] = tick
        if r + 1 == count:
            pieces[beyond - 1, 1] = ticks
    for m in range(move_ends.shape[0]):
        time = move_ends[m] - slack
        moves[m] = min(_before(phi, time) + (1 if time > 0.0 else 0), ticks)


def _come(phi: Array, time: float) -> int:
    """Return the number of motion times that are no later than a time."""
    low, high = 0, phi.shape[0]
    while low < high:
        middle = (low + high) // 2
        if phi[middle] <= time:
            low = middle + 1
        else:
            high = middle
    return low


def _before(phi: Array, time: float) -> int:
    """Return the number of motion times before a time."""
    low, high = 0, phi.shape[0]
    while low < high:
        middle = (low + high) // 2
        if phi[middle] < time:
            low = middle + 1
        else:
            high = middle
    return low
