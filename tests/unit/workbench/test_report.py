"""Reports of projects: with the replay where there is one to show, and the reason where there is none."""

from pathlib import Path

import pytest

from ropsim.flow import Recording
from ropsim.simulation import Fidelity, RunOptions
from ropsim.workbench import Project, open_project
from ropsim.workbench.report import NOT_BUILT, OTHER_ARM, Report
from ropsim.workbench.viewer import built_viewer
from support.recordings import pick_and_place

EXAMPLES = Path(__file__).parents[3] / "examples"


@pytest.fixture(scope="module")
def project() -> Project:
    return open_project(EXAMPLES / "first_cell")


@pytest.fixture(scope="module")
def recording(project: Project) -> Recording:
    return project.simulate(None, RunOptions(Fidelity.KINEMATIC))


def test_the_report_of_a_project_has_a_replay_or_says_why_not(project: Project, recording: Recording) -> None:
    page = project.report(recording).html()
    assert ('<section id="replay"' in page) != (NOT_BUILT in page)
    assert ('<section id="replay"' in page) == (built_viewer() is not None)


def test_a_recording_without_its_cell_has_none(project: Project, recording: Recording) -> None:
    page = Report.of(recording, project.texts).html()
    assert "replay" not in page.lower()


def test_a_recording_of_another_arm_is_not_shown(project: Project) -> None:
    recording = pick_and_place()
    channels = {name: channel for name, channel in recording.channels.items() if name != "q"}
    other = Recording(recording.time, channels, recording.events, (), recording.duration, recording.header)
    assert OTHER_ARM in project.report(other).html()


def test_the_same_run_gives_the_same_page(project: Project, recording: Recording) -> None:
    assert project.report(recording).html() == project.report(recording).html()
