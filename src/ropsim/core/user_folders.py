"""Where caches, settings and state of the user lie, by the rules of the operating system.

A variable of the environment counts only where it names an absolute path, as the XDG base directory
specification demands: an empty or relative one would lead into the working folder, and so into a project that
somebody else wrote.
"""

import errno
import os
import sys
from pathlib import Path

from ropsim.core.frozen_dataclass import frozen_dataclass

CACHE_OVERRIDE = "ROPSIM_CACHE_DIR"
CONFIGURATION_OVERRIDE = "ROPSIM_CONFIG_HOME"
STATE_OVERRIDE = "ROPSIM_STATE_HOME"


@frozen_dataclass
class _Place:
    """One of the folders on each system.

    Attributes:
        override: variable that names the folder itself.
        xdg: variable that names the folder around it on Linux.
        linux: that folder where the variable is not set, below the home folder.
        mac: the same on macOS.
        windows_variable: the same on Windows, as a variable.
        windows: the same on Windows where that variable is not set.
    """

    override: str
    xdg: str
    linux: str
    mac: str
    windows_variable: str
    windows: str


_SUPPORT = "Library/Application Support"
_CACHE = _Place(CACHE_OVERRIDE, "XDG_CACHE_HOME", ".cache", "Library/Caches", "LOCALAPPDATA", "AppData/Local")
_CONFIGURATION = _Place(
    CONFIGURATION_OVERRIDE, "XDG_CONFIG_HOME", ".config", _SUPPORT, "APPDATA", "AppData/Roaming"
)
_STATE = _Place(STATE_OVERRIDE, "XDG_STATE_HOME", ".local/state", _SUPPORT, "LOCALAPPDATA", "AppData/Local")


def cache_folder() -> Path:
    """Return the folder of what can be made again, such as compiled code; see `ropsim.core.kept_files`.

    Raises:
        OSError: the user has no home folder.
    """
    return _folder(_CACHE)


def configuration_folder() -> Path:
    """Return the folder of what the user has decided, such as which project folders are trusted.

    Raises:
        OSError: the user has no home folder.
    """
    return _folder(_CONFIGURATION)


def state_folder() -> Path:
    """Return the folder of what a program wants to find again, such as unsaved texts.

    Raises:
        OSError: the user has no home folder.
    """
    return _folder(_STATE)


def _folder(place: _Place) -> Path:
    """Return the folder that the environment names, else the usual one; it need not exist."""
    named = _absolute(place.override)
    if named is not None:
        return named
    if sys.platform == "win32":
        around = _absolute(place.windows_variable) or _home() / place.windows
    elif sys.platform == "darwin":
        around = _home() / place.mac
    else:
        around = _absolute(place.xdg) or _home() / place.linux
    return around / "ropsim"


def _absolute(variable: str) -> Path | None:
    """Return the path in a variable of the environment; None where it is empty or relative."""
    path = Path(os.environ.get(variable, ""))
    return path if path.is_absolute() else None


def _home() -> Path:
    try:
        home = Path.home()
    except RuntimeError:  # neither the environment nor the list of users tells one
        home = Path()
    if not home.is_absolute():
        raise OSError(errno.ENOENT, "the user has no home folder")
    return home
