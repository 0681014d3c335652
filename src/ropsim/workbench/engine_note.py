"""The note that simulations are slow, where no compiled code can run."""

from ropsim.codegen import numba_available


def engine_note() -> str:
    """Return a line for the user of a simulation in plain Python; empty where compiled code runs."""
    if numba_available():
        return ""
    return "numba is not installed or is switched off: plain Python simulates, many times slower"
