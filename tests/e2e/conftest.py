"""The studio of the first example in the browser: one server for all, a page for the tests of a module.

And the bare studio, whose page is tiny, for tests without a browser.
"""

import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from ropsim.flow import Recording
from ropsim.workbench import Project, new_project, open_project
from support.browser import UNDRAWN, Pages
from support.studio_client import Lend, command, lending
from support.studio_page import StudioPage
from support.studio_process import Studio

if TYPE_CHECKING:
    from playwright.sync_api import Browser

FIRST_CELL = Path(__file__).parents[2] / "examples" / "first_cell"
TEXTS = ("cell.toml", "programs/main.task")


@pytest.fixture(scope="session")
def first_cell(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a copy of the example; whoever writes into it puts back what was there."""
    folder = tmp_path_factory.mktemp("project") / "first_cell"
    shutil.copytree(FIRST_CELL, folder, ignore=shutil.ignore_patterns("out"))
    return folder


@pytest.fixture(scope="module")
def pages(browser: "Browser") -> Iterator[Pages]:
    """Return where the tests of a module open pages that are not drawn."""
    pages = Pages(browser, UNDRAWN)
    yield pages
    pages.close()


@pytest.fixture(scope="session")
def first_project() -> Project:
    """Return the example as its file has it."""
    return open_project(FIRST_CELL)


@pytest.fixture(scope="session")
def first_run(first_project: Project) -> Recording:
    """Return the run of the example."""
    return first_project.simulate()


@pytest.fixture(scope="session")
def first_studio(first_cell: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Studio]:
    """Return the server with the example; pages are closed before it ends."""
    with Studio(first_cell, tmp_path_factory.mktemp("home")) as studio:
        yield studio


@pytest.fixture
def fresh(first_pages: Pages, first_tab: StudioPage, first_cell: Path) -> Iterator[StudioPage]:
    """Return the shared tab with the program in sight; what is done to the texts is undone after the test."""
    first_tab.rest()
    first_tab.document("main.task")
    first_tab.hear_nothing()
    yield first_tab
    for name in TEXTS:
        shutil.copyfile(FIRST_CELL / name, first_cell / name)
    first_tab.revert_all()
    first_tab.has_texts({name: (FIRST_CELL / name).read_text("utf-8") for name in TEXTS})
    assert first_pages.unexpected() == [], "the page complained"


@pytest.fixture(scope="module")
def first_pages(browser: "Browser", request: pytest.FixtureRequest) -> Iterator[Pages]:
    """Return what opens the shared tab; `GRAPHICS` of a module says how little is drawn."""
    pages = Pages(browser, getattr(request.module, "GRAPHICS", ""))
    yield pages
    pages.close()


@pytest.fixture(scope="module")
def first_tab(first_pages: Pages, first_studio: Studio) -> StudioPage:
    """Return a tab that a module shares."""
    return StudioPage.opened(first_pages, first_studio.url)


@pytest.fixture
def tab(first_pages: Pages, first_tab: StudioPage) -> Iterator[StudioPage]:
    """Return the shared tab, at time 0, with nothing but the run in sight; texts must not be edited there."""
    first_tab.rest()
    yield first_tab
    assert first_pages.unexpected() == [], "the page complained"


@pytest.fixture(scope="session")
def bare_project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the project that the bare studio has."""
    return new_project(tmp_path_factory.mktemp("bare") / "cell")


@pytest.fixture(scope="session")
def bare_studio(bare_project: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Studio]:
    """Return a studio for tests without a browser that leave it as it was."""
    place = tmp_path_factory.mktemp("bare")
    with Studio(bare_project, place / "home", command=command(place)) as running:
        yield running


@pytest.fixture
def lend_bare(bare_studio: Studio, bare_project: Path) -> Iterator[Lend]:
    """Return what gives the bare studio another project until the test ends."""
    with lending(bare_studio, bare_project) as lend:
        yield lend


@pytest.fixture
def project(tmp_path: Path) -> Path:
    """Return a new project that the test may spoil."""
    return new_project(tmp_path / "cell")


@pytest.fixture
def lent(lend_bare: Lend, project: Path) -> Studio:
    """Return the bare studio, which has the project of the test until it ends."""
    return lend_bare(project)


@pytest.fixture
def studio(project: Path, tmp_path: Path) -> Iterator[Studio]:
    """Return a studio that the test may end or damage."""
    with Studio(project, tmp_path / "home", command=command(tmp_path)) as running:
        yield running
