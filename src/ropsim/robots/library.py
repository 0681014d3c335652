"""The built-in robots by name: four that are written in Python, and robots of the package's NIROX files."""

from collections.abc import Callable, Mapping
from functools import lru_cache
from importlib.resources import files
from pathlib import Path
from types import MappingProxyType

from ropsim.core import SourceText, read_bytes
from ropsim.model import ControllerModel, Mechanism, Rates, RobotModel
from ropsim.robots import palletizer, puma560, scara, two_link
from ropsim.robots.diagnostics import UnknownRobotError
from ropsim.robots.standard_controller import standard_controller

_MODELS: Mapping[str, Callable[[], RobotModel]] = MappingProxyType(
    {
        "palletizer": palletizer.model,
        "puma560": puma560.model,
        "scara": scara.model,
        "two_link": two_link.model,
    }
)
STANDARD_RATES = Rates()
"""Rates of a controller by default."""
_ENDING = ".stp"


def names() -> tuple[str, ...]:
    """Return the names of the built-in robots."""
    return tuple(sorted((*_MODELS, *stored_names())))


def load(name: str) -> RobotModel:
    """Return a built-in robot; the same object each time.

    Raises:
        UnknownRobotError: X860, no robot has this name; near names are suggested.
    """
    if name in _MODELS:
        return _MODELS[name]()
    if name in stored_names():
        return stored_robot(name)
    raise UnknownRobotError(name, names())


def default_controller(robot: str | Mechanism, rates: Rates = STANDARD_RATES) -> ControllerModel:
    """Return the standard controller of a robot, its gains derived from the model.

    A robot without drives gets the ideal controller, under which it is where its reference is.

    Args:
        robot: a built-in name, or a model.
        rates: of the controller; the bandwidths follow them.

    Raises:
        UnknownRobotError: X860, no robot has this name.
    """
    model = load(robot) if isinstance(robot, str) else robot
    return _controller(model, rates)


@lru_cache(maxsize=16)
def _controller(robot: Mechanism, rates: Rates) -> ControllerModel:
    return standard_controller(robot, rates)


@lru_cache(maxsize=1)
def stored_names() -> tuple[str, ...]:
    """Return the names of the robots that come as files, in their order."""
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
