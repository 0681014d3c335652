"""The robots of the package's NIROX files, `arms/NAME.stp`, which tools/robot_library.py writes."""

from functools import lru_cache
from importlib.resources import files
from pathlib import Path

from ropsim.core import SourceText, read_bytes
from ropsim.model import RobotModel

_ENDING = ".stp"


@lru_cache(maxsize=1)
def stored_names() -> tuple[str, ...]:
    """Return the names of the robots that are there, in their order."""
    return tuple(sorted(path.stem for path in _folder().glob(f"*{_ENDING}")))


@lru_cache(maxsize=64)
def stored_robot(name: str) -> RobotModel:
    """Return a robot; its file is read once, and trusted, as the tool and the tests have checked it.

    Args:
        name: one of `stored_names`.
    """
    from ropsim.nirox import read_valid_nirox

    file = f"{name}{_ENDING}"
    return read_valid_nirox(SourceText(file, read_bytes(_folder() / file).decode("ascii")))


def _folder() -> Path:
    return Path(str(files("ropsim.robots").joinpath("arms")))
