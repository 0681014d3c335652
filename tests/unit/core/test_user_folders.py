"""Folders of the user: only absolute places of the environment count."""

import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from ropsim.core import KeptFiles, configuration_folder, kept_files, state_folder
from ropsim.core.user_folders import cache_folder

FOLDERS = {
    "ROPSIM_CACHE_DIR": (cache_folder, "XDG_CACHE_HOME", ".cache"),
    "ROPSIM_CONFIG_HOME": (configuration_folder, "XDG_CONFIG_HOME", ".config"),
    "ROPSIM_STATE_HOME": (state_folder, "XDG_STATE_HOME", ".local/state"),
}
WORTHLESS = ["", "cache", "./cache", "../cache", "~/cache"]

linux = pytest.mark.skipif(sys.platform in ("win32", "darwin"), reason="rules of Linux")
pytestmark = [linux, pytest.mark.parametrize("override", FOLDERS)]


@pytest.fixture
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return the home folder; nothing else is set, and findings of a test end with it."""
    monkeypatch.setattr(kept_files, "_findings", {})
    for override, (_, xdg, _) in FOLDERS.items():
        monkeypatch.delenv(override, raising=False)
        monkeypatch.delenv(xdg, raising=False)
    monkeypatch.setenv("HOME", str(tmp_path))
    return tmp_path


def test_the_folder_lies_below_home(override: str, home: Path) -> None:
    folder, _, below = FOLDERS[override]
    assert folder() == home / below / "ropsim"


@pytest.mark.parametrize("value", WORTHLESS)
def test_empty_and_relative_places_do_not_count(
    override: str, value: str, home: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder, xdg, below = FOLDERS[override]
    monkeypatch.setenv(override, value)
    monkeypatch.setenv(xdg, value)
    assert folder() == home / below / "ropsim"


def test_absolute_places_count_the_own_one_first(
    override: str, home: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder, xdg, _ = FOLDERS[override]
    monkeypatch.setenv(xdg, str(home / "around"))
    assert folder() == home / "around" / "ropsim"
    monkeypatch.setenv(override, str(home / "mine"))
    assert folder() == home / "mine"


@pytest.mark.parametrize("value", ["here", "./here"])
def test_without_a_home_there_is_no_folder(
    override: str, value: str, home: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder: Callable[[], Path] = FOLDERS[override][0]
    monkeypatch.chdir(home)
    monkeypatch.setenv("HOME", value)
    with pytest.raises(OSError, match="no home folder"):
        folder()
    kept = KeptFiles("room", 100, 100)
    kept.keep("a", b"b")
    assert kept.find("a") is None
    assert list(home.iterdir()) == []
