"""Folders of the user for caches, settings and state, by the rules of the operating system.

A variable of the environment counts only where it names an absolute path, as the XDG base directory
specification demands: an empty or relative one would lead into the working folder, and so into a project that
another person wrote. `platformdirs` has the rules of each system. It is imported with the first folder that
no variable of ropsim names, because `ropsim --version` needs none.
"""

import errno
import os
import sys
from collections.abc import Callable
from pathlib import Path

CACHE_OVERRIDE = "ROPSIM_CACHE_DIR"
CONFIGURATION_OVERRIDE = "ROPSIM_CONFIG_HOME"
STATE_OVERRIDE = "ROPSIM_STATE_HOME"

_NAME = "ropsim"
_MAC = "~/Library/Application Support"
"""Where settings and state lie on macOS if no XDG variable says otherwise."""


def cache_folder() -> Path:
    """Return the folder of reproducible data, such as compiled code; see `ropsim.core.disk.kept_files`.

    Raises:
        OSError: the user has no home folder.
    """
    return _named(CACHE_OVERRIDE) or _absolute(_cache)


def relative_cache_override() -> str:
    """Return the path in `ROPSIM_CACHE_DIR` that is not used because it is relative; else an empty string."""
    named = os.environ.get(CACHE_OVERRIDE, "")
    return "" if Path(named).is_absolute() else named


def configuration_folder() -> Path:
    """Return the folder of the user's decisions, such as which project folders are trusted.

    Raises:
        OSError: the user has no home folder.
    """
    return _named(CONFIGURATION_OVERRIDE) or _former_on_mac(_absolute(_configuration))


def state_folder() -> Path:
    """Return the folder of persistent data of a program, such as unsaved texts.

    Raises:
        OSError: the user has no home folder.
    """
    return _named(STATE_OVERRIDE) or _former_on_mac(_absolute(_state))


def _named(variable: str) -> Path | None:
    """Return the path in a variable of the environment; None where it is empty or relative."""
    path = Path(os.environ.get(variable, ""))
    return path if path.is_absolute() else None


def _cache() -> str:
    from platformdirs import user_cache_dir

    return user_cache_dir(_NAME, appauthor=False, opinion=False)  # no folder `Cache` inside of it on Windows


def _configuration() -> str:
    from platformdirs import user_config_dir

    return user_config_dir(_NAME, appauthor=False, roaming=True)


def _state() -> str:
    from platformdirs import user_state_dir

    return user_state_dir(_NAME, appauthor=False)


def _absolute(folder: Callable[[], str]) -> Path:
    """Return a folder of the user; it need not exist.

    Raises:
        OSError: the user has no home folder.
    """
    try:
        path = Path(folder())
    except RuntimeError:  # neither the environment nor the list of users has a home folder
        path = Path()
    if not path.is_absolute():
        raise OSError(errno.ENOENT, "the user has no home folder")
    return path


def _former_on_mac(folder: Path) -> Path:
    """Return a folder, or on macOS the one in `Library` while that alone exists.

    Earlier versions used the latter even where an XDG variable names another.
    """
    if sys.platform == "darwin":
        former = Path(os.path.expanduser(_MAC)) / _NAME  # noqa: PTH111 - no error where there is no home folder
        if not folder.exists() and former.is_absolute() and former.is_dir():
            return former
    return folder
