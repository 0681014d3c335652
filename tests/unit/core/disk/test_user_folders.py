"""Folders of the user: only absolute places of the environment count."""

import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from platformdirs.macos import MacOS
from platformdirs.windows import Windows, get_win_folder_from_env_vars

from ropsim.core import KeptFiles, configuration_folder, state_folder
from ropsim.core.disk import kept_files
from ropsim.core.disk.user_folders import cache_folder

FOLDERS = {
    "ROPSIM_CACHE_DIR": (cache_folder, "XDG_CACHE_HOME", ".cache"),
    "ROPSIM_CONFIG_HOME": (configuration_folder, "XDG_CONFIG_HOME", ".config"),
    "ROPSIM_STATE_HOME": (state_folder, "XDG_STATE_HOME", ".local/state"),
}
WORTHLESS = ["", "cache", "./cache", "../cache", "~/cache"]

linux = pytest.mark.skipif(sys.platform in ("win32", "darwin"), reason="rules of Linux")
pytestmark = linux
each = pytest.mark.parametrize("override", FOLDERS)


@pytest.fixture
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return the home folder; nothing else is set, and findings of a test end with it."""
    monkeypatch.setattr(kept_files, "_findings", {})
    for override, (_, xdg, _) in FOLDERS.items():
        monkeypatch.delenv(override, raising=False)
        monkeypatch.delenv(xdg, raising=False)
    monkeypatch.setenv("HOME", str(tmp_path))
    return tmp_path


@each
def test_the_folder_lies_below_home(override: str, home: Path) -> None:
    folder, _, below = FOLDERS[override]
    assert folder() == home / below / "ropsim"


@each
@pytest.mark.parametrize("value", WORTHLESS)
def test_empty_and_relative_places_do_not_count(
    override: str, value: str, home: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder, xdg, below = FOLDERS[override]
    monkeypatch.setenv(override, value)
    monkeypatch.setenv(xdg, value)
    assert folder() == home / below / "ropsim"


@each
def test_absolute_places_count_the_own_one_first(
    override: str, home: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder, xdg, _ = FOLDERS[override]
    monkeypatch.setenv(xdg, str(home / "around"))
    assert folder() == home / "around" / "ropsim"
    monkeypatch.setenv(override, str(home / "mine"))
    assert folder() == home / "mine"


def unlisted(number: int) -> object:
    raise KeyError(f"getpwuid(): uid not found: {number}")


@each
@pytest.mark.parametrize("value", ["here", "./here"])
def test_without_a_home_there_is_no_folder(
    override: str, value: str, home: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder: Callable[[], Path] = FOLDERS[override][0]
    monkeypatch.chdir(home)
    monkeypatch.setenv("HOME", value)
    monkeypatch.setattr("pwd.getpwuid", unlisted)
    with pytest.raises(OSError, match="no home folder"):
        folder()
    kept = KeptFiles("room", 100, 100)
    kept.keep("a", b"b")
    assert kept.find("a") is None
    assert list(home.iterdir()) == []


@pytest.fixture
def on_mac(home: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Have folders as on macOS and return the home folder."""
    monkeypatch.setattr("platformdirs.PlatformDirs", MacOS)
    monkeypatch.setattr(sys, "platform", "darwin")
    return home


def test_folders_of_macos_lie_in_library(on_mac: Path) -> None:
    support = on_mac / "Library" / "Application Support" / "ropsim"
    assert cache_folder() == on_mac / "Library" / "Caches" / "ropsim"
    assert (configuration_folder(), state_folder()) == (support, support)


@pytest.mark.parametrize("override", ["ROPSIM_CONFIG_HOME", "ROPSIM_STATE_HOME"])
def test_settings_and_state_in_library_are_found_until_there_is_a_folder_of_xdg(
    on_mac: Path, monkeypatch: pytest.MonkeyPatch, override: str
) -> None:
    folder, xdg, _ = FOLDERS[override]
    before = folder()
    monkeypatch.setenv(xdg, str(on_mac / "around"))
    new = on_mac / "around" / "ropsim"
    assert folder() == new
    before.mkdir(parents=True)
    assert folder() == before
    new.mkdir(parents=True)
    assert folder() == new


def test_folders_of_windows_lie_in_the_profile(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Settings go with the user to other computers; the rest stays on this one."""
    local, roaming = home / "AppData" / "Local", home / "AppData" / "Roaming"
    monkeypatch.setenv("LOCALAPPDATA", str(local))
    monkeypatch.setenv("APPDATA", str(roaming))
    monkeypatch.setattr("platformdirs.windows.get_win_folder", get_win_folder_from_env_vars)
    monkeypatch.setattr("platformdirs.PlatformDirs", Windows)
    assert cache_folder() == state_folder() == local / "ropsim"
    assert configuration_folder() == roaming / "ropsim"
