"""The system fails at a call to the cache during a run: the run gives the same, and so does the next one.

`tests/unit/core/disk/test_kept_faults.py` goes through all calls for one entry.
"""

import json
import random
import shutil
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, TypeAlias

import pytest

from ropsim.core.disk import user_folders
from support.cached_run import TEXTS, write_project
from support.counted_system import FAULTS
from support.nursery import Nursery

RUNNING = "support.cached_run"
NEVER = 1_000_000  # calls that no run makes
DAMAGING = ("folder removed", "files cut")
"""Faults after which everything is compiled anew that is not loaded yet: they come late, in one run."""
LATE = 20  # calls before the end of a run
Ran: TypeAlias = Callable[[Path, str, int], dict[str, Any]]

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(sys.platform == "win32", reason="processes are forked as POSIX does"),
]


@pytest.fixture(scope="module")
def ran(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Ran]:
    """Return what runs the project in a process of its own: with a cache folder, and a fault at a call."""
    project = write_project(tmp_path_factory.mktemp("project"), TEXTS)
    with Nursery([RUNNING, "numba"]) as copies:

        def run(cache: Path, fault: str, call: int) -> dict[str, Any]:
            ended = copies.run(RUNNING, [str(project), fault, str(call)], {"ROPSIM_CACHE_DIR": str(cache)})
            assert (ended.code, ended.complained) == (0, "")
            found: dict[str, Any] = json.loads(ended.printed)
            return found

        yield run


@pytest.fixture(scope="module")
def filled(ran: Ran, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a cache folder with what a run needs; machine code comes from the folder of the user."""
    usual, place = user_folders.cache_folder(), tmp_path_factory.mktemp("filled") / "cache"
    names = {one for one in ran(usual, "full disk", NEVER)["places"] if one.endswith((".code", ".door"))}
    (place / "generated").mkdir(parents=True, mode=0o700)
    for name in names:
        if (usual / "generated" / name).exists():
            shutil.copy(usual / "generated" / name, place / "generated")
    place.chmod(0o700)
    ran(place, "full disk", NEVER)
    return place


@pytest.mark.parametrize("fault", FAULTS)
def test_a_run_gives_the_same_at_whatever_call_its_cache_fails(
    ran: Ran, filled: Path, tmp_path: Path, fault: str
) -> None:
    cache = Path(shutil.copytree(filled, tmp_path / "cache"))
    warm = ran(cache, fault, NEVER)
    assert warm["why"] == []
    least = warm["calls"] - LATE if fault in DAMAGING else 1
    failing = ran(cache, fault, random.Random(fault).randint(least, warm["calls"]))
    assert results(failing) == results(warm)
    assert set(failing["why"]) <= {"X919"}
    if fault in DAMAGING:
        return
    healthy = ran(cache, fault, NEVER)
    assert results(healthy) == results(warm)
    assert healthy["why"] == []


def results(found: dict[str, Any]) -> tuple[object, object]:
    """Return the digest of the recording of a run and the codes of what was found of its text."""
    return found["digest"], found["codes"]
