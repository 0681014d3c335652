"""What a law remembers at rest, and while an arm goes on slowly.

In motion a law may need an error to give the output that goes on with it: loops without speed fed forward
lag. Error and memory are found together, as where the memory stays and the output is that of the steady
drives, by Newton's method with steps of least squares, which leave alone what nothing depends on. Then the
arm goes on for some ticks, so that laws which take speeds from coordinates see them.
"""

from collections.abc import Callable

import numpy as np

from ropsim.simulation.servo.held_state import SMALL
from ropsim.spatial import Array

LONGEST_REST = 5000
"""Ticks in which what a law remembers comes to rest."""
_REST = 1e-12
"""Change in a tick, over a number, of what has come to rest."""
_STEPS, _HALVINGS = 12, 8
_STEADY, _NEARLY = 1e-9, 1e-6
"""What is left of a steady state, over its numbers: at the end of a search, and at the most."""
_TICKS = 50
"""For which the arm goes on."""
_LONGER = 2000
"""Ticks after which a law is tried again of which no steady state is found at once."""

Answer = Callable[[Array, Array, Array], Array]
"""From measured rows, memory and reference coordinates to outputs and next memory."""


def at_rest(after: Callable[[Array], Array], memory: Array, n: int) -> Array:
    """Return what a law remembers when it has come to rest; `after` gives outputs and next memory."""
    for _ in range(LONGEST_REST):
        before, memory = memory, after(memory)[n:]
        if (np.abs(memory - before) <= _REST * np.maximum(np.abs(memory), SMALL)).all():
            break
    return memory


def in_motion(
    answer: Answer, here: tuple[Array, Array], memory: Array, goes: tuple[Array, Array]
) -> tuple[Array, Array]:
    """Return what a law remembers in slow motion, and how far the reference is ahead of the arm.

    Args:
        answer: of the law.
        here: measured rows, and coordinates, at the place where it is looked at.
        memory: at rest.
        goes: way of the axes in a tick, and outputs of the law that go on with that.
    """
    (found, q), (way, outputs) = here, goes
    n, kept = len(q), memory
    is_found, memory, ahead = _steady(answer, here, kept, outputs)
    if not is_found:
        for _ in range(_LONGER):
            memory = answer(found, memory, q)[n:]
        is_found, memory, ahead = _steady(answer, here, memory, outputs)
    if not is_found:
        memory = kept
    for tick in range(_TICKS, 0, -1):
        rows = found.copy()
        rows[0] -= tick * way
        before, memory = memory, answer(rows, memory, q - tick * way + ahead)[n:]
        if tick == _TICKS and np.allclose(memory, before, rtol=_STEADY, atol=_STEADY * SMALL):
            break  # nothing in it goes along
    return memory, ahead


def _steady(
    answer: Answer, here: tuple[Array, Array], memory: Array, outputs: Array
) -> tuple[bool, Array, Array]:
    """Return whether a steady state is found, its memory, and how far the reference is ahead in it."""
    (found, q), n = here, len(outputs)
    start = np.concatenate((np.zeros(n), memory))
    wide = np.maximum(1.0, np.abs(np.concatenate((outputs, memory))))

    def left(z: Array) -> Array:
        return np.asarray((answer(found, z[n:], q + z[:n]) - np.concatenate((outputs, z[n:]))) / wide)

    units = np.concatenate((np.ones(n), wide[n:]))
    z, now = start, left(start)
    for _ in range(_STEPS):
        size = float(np.linalg.norm(now))
        if not np.isfinite(size) or size <= _STEADY:
            break
        slopes = np.array([(left(z + SMALL * h) - now) / SMALL for h in np.diag(units)]).T
        step = units * np.linalg.lstsq(slopes, -now, rcond=None)[0]
        for _ in range(_HALVINGS):
            tried = left(z + step)
            if float(np.linalg.norm(tried)) < size:
                break
            step = 0.5 * step
        else:
            break
        z, now = z + step, tried
    if float(np.linalg.norm(now)) <= _NEARLY:
        return True, z[n:], z[:n]
    return False, memory, np.zeros(n)
