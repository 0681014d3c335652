"""Which machine runs generated code."""

from enum import Enum

from ropsim.codegen.kernel import numba_available


class Engine(Enum):
    """How a generated module is executed.

    Both run the same source; results agree to rounding of the elementary functions.
    """

    NUMBA = "numba"
    PYTHON = "python"


def default_engine() -> Engine:
    """Return NUMBA where it is installed, else PYTHON."""
    return Engine.NUMBA if numba_available() else Engine.PYTHON
