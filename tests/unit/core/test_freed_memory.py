"""Memory that is kept when arrays are freed."""

import subprocess
import sys

import pytest

SCRIPT = """
import resource
import numpy as np
from ropsim.core import keep_freed_memory
keep_freed_memory()
def pages():
    before = resource.getrusage(resource.RUSAGE_SELF).ru_minflt
    arrays = [np.ones(200_000) for _ in range(5)]
    del arrays
    return resource.getrusage(resource.RUSAGE_SELF).ru_minflt - before
pages()
print(max(pages() for _ in range(5)))
"""
PAGES = 1953
"""That five arrays of 200,000 numbers take, of 4 KiB each."""


@pytest.mark.skipif(sys.platform != "linux", reason="the C library of Linux")
def test_pages_of_freed_arrays_are_not_asked_for_again() -> None:
    done = subprocess.run([sys.executable, "-c", SCRIPT], capture_output=True, text=True, check=True)
    assert int(done.stdout) < 0.05 * PAGES
