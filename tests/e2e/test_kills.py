"""Whatever is written is killed in the midst: nothing is lost or half-written, and the next start works.

`python -m tools.kills` does it more often; docs/explanation/robustness.md tells what that found.
"""

import sys
from collections.abc import Iterator

import pytest

from support.kills.family import killed_job, nursery
from support.nursery import Nursery

KILLS = {"save": 5, "journal": 4, "report": 3, "recording": 3, "cache": 2, "trust": 3}
SEED = 3

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(sys.platform == "win32", reason="processes are forked and killed as POSIX does"),
]


@pytest.fixture(scope="module")
def copies() -> Iterator[Nursery]:
    """Return what makes the processes that kill."""
    with nursery() as running:
        yield running


@pytest.mark.parametrize("job", list(KILLS))
def test_a_kill_loses_nothing_and_the_next_start_works(job: str, copies: Nursery) -> None:
    found = killed_job(copies, job, KILLS[job], SEED)
    assert found.faults == []
    assert found.killed == KILLS[job]  # each at a moment within the job
    assert found.moments >= 4
