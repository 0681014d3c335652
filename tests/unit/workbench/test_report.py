"""Reports of projects: with the replay where there is one to show, and the reason where there is none."""

import json
import shutil
from pathlib import Path

import pytest

from ropsim.cli.testing import main
from ropsim.flow import Recording
from ropsim.simulation import Fidelity, RunOptions
from ropsim.workbench import Project, open_project
from ropsim.workbench.testing import NOT_BUILT, OTHER_ARM, Report, built_viewer
from support.meshes import ply
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
    other = Recording(recording.time, channels, recording.events, (), recording.duration, recording.facts)
    assert OTHER_ARM in project.report(other).html()


def test_the_same_run_gives_the_same_page(project: Project, recording: Recording) -> None:
    assert project.report(recording).html() == project.report(recording).html()


DAMAGED = """
[[objects]]
name = "fixture"
position = [500, 500, 0]
shapes = [{ mesh = "fixture.ply" }, { mesh = "gone.glb" }]
"""


@pytest.fixture
def damaged(tmp_path: Path) -> Path:
    """The first cell with a mesh whose faces are damaged, and one that is not there."""
    folder = tmp_path / "cell"
    shutil.copytree(EXAMPLES / "first_cell", folder, ignore=shutil.ignore_patterns("out"))
    with (folder / "cell.toml").open("a", encoding="utf-8") as stream:
        stream.write(DAMAGED)
    (folder / "fixture.ply").write_bytes(ply().replace(b"3 0 1 3", b"3 0 1 99"))
    return folder


def test_what_cannot_be_drawn_is_a_finding_and_the_report_is_written(
    damaged: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    page = tmp_path / "report.html"
    assert main(["run", str(damaged), "--kinematic", "--report", str(page)]) == 0
    said = capsys.readouterr().err
    assert "warning[X881] mesh-damaged: the mesh `fixture.ply` has a face at point 99" in said
    assert "warning[X880] mesh-missing" in said
    assert "cell.toml:" in said
    text = page.read_text("utf-8")
    assert text.endswith("</html>\n")
    assert "has a face at point 99" in text


def test_what_cannot_be_drawn_is_in_the_document(
    damaged: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    main(["run", str(damaged), "--kinematic", "--json", "--report", str(tmp_path / "report.html")])
    codes = [one["code"] for one in json.loads(capsys.readouterr().out)["diagnostics"]]
    assert {"X880", "X881"} <= set(codes)


def test_without_a_page_no_mesh_is_read(damaged: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["run", str(damaged), "--kinematic"]) == 0
    assert "X88" not in capsys.readouterr().err
