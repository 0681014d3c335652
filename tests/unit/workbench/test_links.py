"""One rule for links: each kind of file of a project stays in its folder, else there is the one finding."""

import shutil
import sys
from collections.abc import Iterable
from pathlib import Path

import pytest

from ropsim.core import Diagnostic
from ropsim.meshes import load_meshes
from ropsim.tasks import read_point_lists
from ropsim.workbench import Project, new_project, open_overlaid, open_project

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="links need rights there")
POINTS = "name,x,y,z,pitch,roll\n,mm,mm,mm,deg,deg\na,1,2,3,0,0\n"
MESH = '\n[[objects]]\nname = "part"\nposition = [0, 0, 0]\nshapes = [{ mesh = "geometry/part.stl" }]\n'
PLACES = {
    "cell.toml": "",
    "programs/main.task": "",
    "robots/arm.toml": "name = 'x'\n",
    "geometry/part.stl": "solid s\nendsolid s\n",
    "points/list.csv": POINTS,
    "kb/own.pl": "part(bolt).\n",
    "kb/manifest.toml": "order = []\n",
}


@pytest.fixture
def project(tmp_path: Path) -> Path:
    return new_project(tmp_path / "cell", "first_cell")


def found_in(project: Path) -> Iterable[Diagnostic]:
    """Yield the findings of whatever reads files of a project."""
    for read in (open_project, opened_in_studio):
        opened = read(project)
        yield from opened.diagnostics
        yield from opened.compile().diagnostics
        yield from opened.tasks.findings
        if opened.cell is not None:
            yield from load_meshes(project, opened.cell).diagnostics
    yield from read_point_lists(project)[1]


def opened_in_studio(project: Path) -> Project:
    return open_overlaid(project, {})


def linked(project: Path, name: str, target: Path) -> None:
    """Let a file of a project be a link to a copy of it elsewhere."""
    place = project / name
    place.parent.mkdir(exist_ok=True)
    if not place.exists():
        place.write_text(PLACES[name], "utf-8")
    cell = project / "cell.toml"
    if name == "robots/arm.toml":
        cell.write_text(cell.read_text("utf-8").replace('"puma560"', '"robots/arm.toml"', 1), "utf-8")
    if name == "geometry/part.stl":
        cell.write_text(cell.read_text("utf-8") + MESH, "utf-8")
    target.parent.mkdir(parents=True, exist_ok=True)
    shutil.move(place, target)
    place.symlink_to(target)


@pytest.mark.parametrize("name", PLACES)
def test_a_link_out_of_the_project_is_refused_with_the_one_finding(project: Path, name: str) -> None:
    linked(project, name, project.parent / "elsewhere" / Path(name).name)
    outside = [one for one in found_in(project) if one.code == "U962"]
    assert outside
    assert all("is a link that leads out of the project folder" in one.message for one in outside)
    assert all(Path(name).name in one.message for one in outside)


@pytest.mark.parametrize("name", PLACES)
def test_a_link_inside_of_the_project_is_followed(project: Path, name: str) -> None:
    linked(project, name, project / "shared" / Path(name).name)
    assert "U962" not in [one.code for one in found_in(project)]


def test_a_project_that_is_reached_by_a_link_has_no_links_out(project: Path) -> None:
    link = project.parent / "link"
    link.symlink_to(project, target_is_directory=True)
    assert "U962" not in [one.code for one in found_in(link)]
