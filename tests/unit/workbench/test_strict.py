"""`simulate(strict=True)`: a run that left out moves is not taken for a good one."""

from dataclasses import replace
from pathlib import Path

import pytest

from ropsim.core import RopsimError
from ropsim.flow import MotionKind, SkipEvent
from ropsim.simulation import Fidelity, RunOptions
from ropsim.workbench import FailedRunError, Project, new_project, open_project

KINEMATIC = RunOptions(Fidelity.KINEMATIC)


def project(folder: Path, *statements: str) -> Project:
    made = new_project(folder / "cell")
    (made / "programs" / "main.task").write_text("\n".join(["units mm, deg", *statements, ""]))
    return open_project(made)


def test_a_run_with_a_move_out_of_reach_is_not_ok_and_goes_on(tmp_path: Path) -> None:
    recording = project(tmp_path, "mov (2000, 0, 300)", "mov joints (0, 0, 0, 0, 0, 0)").simulate(
        None, KINEMATIC
    )
    assert not recording.ok
    assert [event.kind for event in recording.events if event.kind in {"move", "skip"}] == ["skip", "move"]


def test_strict_raises_the_first_error_with_the_whole_recording(tmp_path: Path) -> None:
    bad = project(
        tmp_path, "mov (2000, 0, 300)", "mov joints (0, 0, 900, 0, 0, 0)", "mov joints (0, 0, 0, 0, 0, 0)"
    )
    with pytest.raises(FailedRunError) as caught:
        bad.simulate(None, KINEMATIC, strict=True)
    assert isinstance(caught.value, RopsimError)
    assert caught.value.diagnostic.code == "M501"
    assert caught.value.diagnostic == caught.value.recording.first_error
    assert [one.code for one in caught.value.recording.findings] == ["M501", "M502"]
    assert "out of reach" in str(caught.value) or "M501" in str(caught.value)


def test_strict_gives_a_good_run_back(tmp_path: Path) -> None:
    recording = project(tmp_path, "mov joints (0, 0, 0, 0, 0, 0)").simulate(None, KINEMATIC, strict=True)
    assert recording.ok


def test_skipped_moves_without_an_error_are_an_error_all_the_same(tmp_path: Path) -> None:
    recording = project(tmp_path, "mov joints (0, 0, 0, 0, 0, 0)").simulate(None, KINEMATIC)
    skipped = replace(recording, events=(*recording.events, SkipEvent(0.0, motion=MotionKind.PTP)))
    error = FailedRunError(skipped)
    assert error.diagnostic.code == "X895"
    assert error.diagnostic.message.startswith("the run left out 1 of ")
    assert error.recording is skipped
