"""The built-in robots by name."""

from collections.abc import Callable, Mapping
from types import MappingProxyType

from ropsim.model import ControllerModel, RobotModel
from ropsim.robots import puma560, two_link
from ropsim.robots.diagnostics import NoControllerError, UnknownRobotError

_MODELS: Mapping[str, Callable[[], RobotModel]] = MappingProxyType(
    {"puma560": puma560.model, "two_link": two_link.model}
)
_CONTROLLERS: Mapping[str, Callable[[], ControllerModel]] = MappingProxyType({"puma560": puma560.controller})


def names() -> tuple[str, ...]:
    """Return the names of the built-in robots."""
    return tuple(sorted(_MODELS))


def load(name: str) -> RobotModel:
    """Return a built-in robot; the same object each time.

    Raises:
        UnknownRobotError: X860, no robot has this name; near names are suggested.
    """
    if name not in _MODELS:
        raise UnknownRobotError(name, names())
    return _MODELS[name]()


def default_controller(robot: str | RobotModel) -> ControllerModel:
    """Return the built-in controller of a robot, with estimated gains.

    Args:
        robot: a built-in name, or a model that was made from a built-in one and kept its name.

    Raises:
        UnknownRobotError: X860, no robot has this name.
        NoControllerError: X861, the library has no controller for it.
    """
    name = robot if isinstance(robot, str) else robot.name
    if isinstance(robot, str) and name not in _MODELS:
        raise UnknownRobotError(name, names())
    if name not in _CONTROLLERS:
        raise NoControllerError(name, sorted(_CONTROLLERS))
    return _CONTROLLERS[name]()
