"""How long a test waits for what must come, one number for all: it ends a hang and decides nothing else."""

import time
from collections.abc import Callable

PATIENCE = 120.0
"""Longer than anything takes on shared cores, compiling an arm for the first time included [s]."""
GLANCE = 0.01
"""Between two looks at what is waited for [s]."""


def until(condition: Callable[[], bool], what: str) -> None:
    """Wait until something holds."""
    end = time.monotonic() + PATIENCE
    while not condition():
        assert time.monotonic() < end, f"{what} has not come"
        time.sleep(GLANCE)
