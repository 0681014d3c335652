"""Another project takes the place of the open one, new ones are made; a toy stands in for the simulator."""

import asyncio
import json
import sys
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any

import pytest

from ropsim import robots
from ropsim.studio.testing import Place, Tab, Workplace, place_of
from ropsim.userfiles import recent_projects
from ropsim.workbench import new_project
from support.patience import PATIENCE

TOY = "support.toy_worker:main"
PLACE = Place(40123, 32 * "s", made=1_800_000_000.0)


@pytest.fixture
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("ROPSIM_STATE_HOME", str(tmp_path / "state"))
    monkeypatch.setenv("ROPSIM_CONFIG_HOME", str(tmp_path / "config"))
    monkeypatch.setattr(sys, "path", list(sys.path))
    monkeypatch.setenv("PYTHONPATH", "")
    new_project(tmp_path / "first")
    return tmp_path


async def said(workplace: Workplace, *messages: dict[str, Any]) -> list[dict[str, Any]]:
    """Say hello and then messages as a page, and return what the page has heard until nothing more comes."""
    session, tab = workplace.session, Tab()
    heard: list[dict[str, Any]] = []

    async def take(text: str) -> None:
        heard.append(json.loads(text))

    async def take_frame(frame: bytes) -> None:
        del frame

    pump = asyncio.create_task(tab.pump(take, take_frame))
    for message in ({"type": "hello", "tab": "a"}, *messages):
        await session.receive(tab, json.dumps(message))
    for _ in range(10):
        await asyncio.sleep(0)
    tab.close()
    await pump
    await session.leave(tab)
    return heard


def at(folder: Path, play: Callable[[Workplace], Awaitable[None]]) -> None:
    async def run() -> None:
        workplace = Workplace(folder, folder.parent, PLACE, TOY)
        await workplace.open()
        try:
            await asyncio.wait_for(play(workplace), PATIENCE)
        finally:
            await workplace.close()
            workplace.kill()

    asyncio.run(run())


async def switched(workplace: Workplace, folder: Path) -> None:
    """Wait until another project is open."""
    while True:
        welcome = (await said(workplace))[0]
        if welcome["folder"] == str(folder):
            return
        await asyncio.sleep(0.01)


def test_a_project_that_is_opened_takes_the_place_of_the_one_before(home: Path) -> None:
    new_project(home / "second")

    async def play(workplace: Workplace) -> None:
        before = workplace.session
        await said(workplace, {"type": "open_project", "path": "second"})
        await switched(workplace, home / "second")
        assert workplace.session is not before

    at(home / "first", play)
    assert recent_projects() == (home / "second", home / "first")


def test_a_project_that_was_opened_here_is_found_at_the_same_place_by_the_next_start(home: Path) -> None:
    new_project(home / "second")

    async def play(workplace: Workplace) -> None:
        await said(workplace, {"type": "open_project", "path": "second"})
        await switched(workplace, home / "second")

    at(home / "first", play)
    assert place_of(home / "second", PLACE.made) == PLACE


@pytest.mark.parametrize("origin", [{"example": "fig5"}, {"example": "", "robot": "two_link"}])
def test_a_new_project_is_made_where_it_was_typed_and_opened(home: Path, origin: dict[str, str]) -> None:
    async def play(workplace: Workplace) -> None:
        await said(workplace, {"type": "new_project", "path": "third", **origin})
        await switched(workplace, home / "third")

    at(home / "first", play)
    assert (home / "third" / "cell.toml").is_file()


def test_the_robots_are_told_for_which_projects_can_be_made(home: Path) -> None:
    async def play(workplace: Workplace) -> None:
        heard = await said(workplace, {"type": "list_robots"})
        assert [one["names"] for one in heard if one["type"] == "robots"] == [list(robots.names())]

    at(home / "first", play)


@pytest.mark.parametrize(
    ("message", "code"),
    [
        ({"type": "open_project", "path": "nowhere"}, "U950"),
        ({"type": "open_project", "path": "state"}, "U950"),
        ({"type": "open_project", "path": "a\0b"}, "U950"),
        ({"type": "new_project", "path": "first", "example": "fig5"}, "X849"),
        ({"type": "new_project", "path": "third", "example": "no such"}, "X848"),
        ({"type": "new_project", "path": "third", "example": "fig5", "robot": "puma650"}, "X860"),
    ],
)
def test_what_cannot_be_opened_or_made_is_said_and_the_project_stays(
    home: Path, message: dict[str, Any], code: str
) -> None:
    async def play(workplace: Workplace) -> None:
        before = workplace.session
        heard = await said(workplace, message)
        assert [one["refusal"]["code"] for one in heard if one["type"] == "answered"] == [code]
        assert workplace.session is before

    at(home / "first", play)


def test_a_tab_that_only_looks_on_opens_nothing(home: Path) -> None:
    async def play(workplace: Workplace) -> None:
        before, editor = workplace.session, Tab()
        await before.receive(editor, json.dumps({"type": "hello", "tab": "editor"}))
        heard = await said(workplace, {"type": "new_project", "path": "third", "example": "fig5"})
        assert [one["refusal"]["code"] for one in heard if one["type"] == "answered"] == ["U954"]
        assert workplace.session is before

    at(home / "first", play)
    assert not (home / "third").exists()
