"""The system fails at any call of the cache: an entry is whole or absent, and the next use keeps anew."""

import sys
from collections.abc import Iterator
from functools import partial
from itertools import count
from pathlib import Path

import pytest

from ropsim.core import KeptFiles
from ropsim.core.disk import kept_files
from support.counted_system import FAULTS, counted, number

OLD, ENTRY = b"old entry" * 100, b"new entry" * 300


def used(kept: KeptFiles) -> tuple[bytes | None, bytes | None]:
    """Find an entry, keep one in its place in turn with other processes, find that; return both answers."""
    before = kept.find("name")
    with kept.turn(7):
        kept.keep("name", ENTRY)
    return before, kept.find("name")


@pytest.fixture(autouse=True)
def nothing_said() -> Iterator[None]:
    """Forget what was said of the cache folder."""
    kept_files._findings.clear()
    yield
    kept_files._findings.clear()


def open_handles() -> int:
    """Return how many files this process has open; 0 where the system does not list them."""
    return len(list(Path("/proc/self/fd").iterdir())) if sys.platform.startswith("linux") else 0


@pytest.mark.slow
@pytest.mark.parametrize("fault", FAULTS)
@pytest.mark.parametrize("is_filled", [True, False], ids=["filled", "empty"])
def test_an_entry_is_whole_or_absent_at_whatever_call_the_system_fails(
    tmp_path: Path, fault: str, is_filled: bool
) -> None:
    for at in count(1):
        folder = tmp_path / f"{at}" / "cache"
        kept = KeptFiles("room", 5_000, 4_000, partial(Path, folder))
        if is_filled:
            kept.keep("name", OLD)
            kept.keep("other", OLD)
            kept.keep("larger", bytes(2_500))  # so that place must be made
        handles = open_handles()
        with counted(folder, number(at), FAULTS[fault](folder)) as counting:
            before, after = used(kept)
        assert open_handles() == handles, counting.names[at - 1]
        assert before in ((OLD, None) if is_filled else (None,))
        assert after in (ENTRY, OLD, None)
        if not counting.acted:
            assert at > 20
            assert after == ENTRY
            return
        assert used(kept)[1] == ENTRY
        left = [one.name for one in (folder / "room").iterdir() if one.name.startswith(".")]
        assert left == [] or counting.names[at - 1] == "unlink"
