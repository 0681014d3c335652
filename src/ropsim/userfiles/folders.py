"""Where settings and state of the user are kept, by the rules of the operating system."""

import os
import sys
from pathlib import Path

CONFIGURATION_OVERRIDE = "ROPSIM_CONFIG_HOME"
STATE_OVERRIDE = "ROPSIM_STATE_HOME"


def configuration_folder() -> Path:
    """Return the folder of what the user has decided, such as which project folders are trusted."""
    return _folder(CONFIGURATION_OVERRIDE, "XDG_CONFIG_HOME", ".config", "APPDATA", "Roaming")


def state_folder() -> Path:
    """Return the folder of what a program wants to find again, such as unsaved texts."""
    return _folder(STATE_OVERRIDE, "XDG_STATE_HOME", ".local/state", "LOCALAPPDATA", "Local")


def _folder(override: str, xdg: str, below_home: str, windows: str, below_app_data: str) -> Path:
    """Return the place an environment variable names, else the usual one; it need not exist yet."""
    named = os.environ.get(override)
    if named:
        return Path(named)
    if sys.platform == "win32":
        return Path(os.environ.get(windows) or Path.home() / "AppData" / below_app_data) / "ropsim"
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Application Support" / "ropsim"
    stated = os.environ.get(xdg, "")
    # a relative path is to be ignored (XDG base directory specification)
    base = Path(stated) if Path(stated).is_absolute() else Path.home() / below_home
    return base / "ropsim"
