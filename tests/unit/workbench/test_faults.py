"""The system fails at any call while a project is opened, run and reported: no file is half."""

import contextlib
import shutil
from collections.abc import Callable
from itertools import count
from pathlib import Path

import pytest

from ropsim.core import RopsimError, replace_file
from ropsim.flow import Fidelity
from ropsim.records import read_recording, write_recording
from ropsim.simulation import RunOptions
from ropsim.workbench import new_project, open_project
from support.counted_system import counted, number


def test_a_project_that_cannot_be_read_at_a_call_is_told(tmp_path: Path) -> None:
    project = new_project(tmp_path / "cell", "first_cell")
    (project / "kb").mkdir()
    (project / "kb" / "own.pl").write_text("part(bolt).\n", "utf-8")
    for at in count(1):
        with counted(project, number(at)) as counting, contextlib.suppress(RopsimError):
            opened = open_project(project)
            opened.compile()
        if not counting.acted:
            assert at > 8
            assert not opened.is_broken
            return


@pytest.mark.parametrize("write", ["recording", "report"])
def test_a_result_that_cannot_be_written_at_a_call_leaves_the_one_before(tmp_path: Path, write: str) -> None:
    project = new_project(tmp_path / "cell", "first_cell")
    opened = open_project(project)
    run = opened.simulate(options=RunOptions(fidelity=Fidelity.KINEMATIC))
    place = project / "out" / "run"
    writers: dict[str, Callable[[], None]] = {
        "recording": lambda: write_recording(run, place),
        "report": lambda: replace_file(place, opened.report(run).html().encode()),
    }
    for at in count(1):
        shutil.rmtree(place.parent, ignore_errors=True)
        place.parent.mkdir()
        place.write_bytes(b"before")
        with counted(place.parent, number(at)) as counting:
            try:
                writers[write]()
                failed = False
            except (OSError, RopsimError):
                failed = True
        assert (place.read_bytes() == b"before") == failed
        if not failed and write == "recording":
            assert read_recording(place).duration == run.duration
        if not (counting.acted and counting.names[at - 1] == "unlink"):
            assert [one.name for one in place.parent.iterdir()] == ["run"]
        if not counting.acted:
            assert at > 4
            return
