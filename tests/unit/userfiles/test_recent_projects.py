"""Projects that were open last are remembered outside of them."""

import os
import stat
from pathlib import Path

import pytest

from ropsim.userfiles import recent_projects, remember_project
from ropsim.workbench import new_project


@pytest.fixture(autouse=True)
def state(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    place = tmp_path / "state"
    monkeypatch.setenv("ROPSIM_STATE_HOME", str(place))
    return place


def test_the_newest_comes_first_and_each_once(tmp_path: Path) -> None:
    one, two = (new_project(tmp_path / name) for name in ("one", "two"))
    for folder in (one, two, one):
        remember_project(folder)
    assert recent_projects() == (one.resolve(), two.resolve())


def test_projects_that_are_gone_are_left_out(tmp_path: Path) -> None:
    folder = new_project(tmp_path / "gone")
    remember_project(folder)
    (folder / "cell.toml").unlink()
    assert recent_projects() == ()


@pytest.mark.parametrize(
    "content", [b"", b"[", b"[]", b'{"version": 9}', b'{"version": 1, "folders": 3}', b"\xff"]
)
def test_a_damaged_list_is_an_empty_one(state: Path, content: bytes) -> None:
    state.mkdir()
    (state / "recent.json").write_bytes(content)
    assert recent_projects() == ()


def test_a_state_folder_that_cannot_be_written_is_no_reason_to_fail(tmp_path: Path, state: Path) -> None:
    state.write_text("no folder", "utf-8")
    remember_project(tmp_path)
    assert recent_projects() == ()


def test_no_more_than_twelve_are_remembered(tmp_path: Path) -> None:
    folders = [new_project(tmp_path / f"cell{k}") for k in range(13)]
    for folder in folders:
        remember_project(folder)
    assert recent_projects() == tuple(one.resolve() for one in reversed(folders[1:]))


@pytest.mark.skipif(os.name == "nt", reason="Windows has no permissions of this kind")
def test_nobody_else_can_read_what_was_open(tmp_path: Path, state: Path) -> None:
    remember_project(new_project(tmp_path / "one"))
    assert stat.S_IMODE((state / "recent.json").stat().st_mode) == 0o600
    assert stat.S_IMODE(state.stat().st_mode) == 0o700
