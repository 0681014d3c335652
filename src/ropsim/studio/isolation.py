"""Keeping the code of projects out: neither this process nor its children find modules in their folders."""

import os
import sys
from pathlib import Path


def leave_project(neutral: Path, folder: Path) -> None:
    """Work in the `neutral` folder from now on, without modules of the project folder."""
    shut_out(folder)
    os.environ["PYTHONSAFEPATH"] = "1"
    os.chdir(neutral)


def shut_out(folder: Path) -> None:
    """Make sure that neither this process nor its children find modules in a project folder."""
    modules = os.environ.get("PYTHONPATH", "").split(os.pathsep)
    os.environ["PYTHONPATH"] = os.pathsep.join(_without(modules, folder))
    sys.path[:] = _without(sys.path, folder)


def _without(places: list[str], folder: Path) -> list[str]:
    """Return module folders as absolute paths, without the one that is named."""
    return [str(Path(place).absolute()) for place in places if place and Path(place).resolve() != folder]
