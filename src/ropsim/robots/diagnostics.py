"""Errors when a robot is requested by name (codes X860 and X861)."""

from collections.abc import Iterable

from ropsim.core import Category, RopsimError, Severity, define, did_you_mean, there_are

UNKNOWN_ROBOT = define(
    "X860",
    "unknown-robot",
    Severity.ERROR,
    "no built-in robot has this name",
    """
A cell or a script asks for a robot that the built-in library does not hold. Names are written in lower
case, such as `puma560`.

`ropsim.robots.names()` lists all of them:

```python
robot = ropsim.robots.load("puma560")
```

The file of a robot, such as `robots/my_arm.stp`, is read by `ropsim.load_robot("robots/my_arm.stp")`.
""",
    Category.USAGE,
)

NO_CONTROLLER = define(
    "X861",
    "no-standard-gains",
    Severity.ERROR,
    "the robot has no drives, so no gains can be made for it",
    """
Gains belong to drives: those of the standard controller are derived from motors, gears and masses of the
model. A robot without drive data has none; in a cell it runs without dynamics, under the ideal controller.

Give the model drives, make a `ControllerModel` with gains of your own, or use a robot that has drives.
""",
)


class UnknownRobotError(RopsimError):
    """No robot of the library has the requested name."""

    def __init__(self, name: str, known: Iterable[str]) -> None:
        names = tuple(known)
        is_path = any(mark in name for mark in "./\\")
        near = "`ropsim.load_robot` reads files" if is_path else did_you_mean(name, names)
        super().__init__(
            UNKNOWN_ROBOT.at(
                None,
                f"no robot is called `{name[:64]}`, {there_are(names)}",
                hint=near or "choose one of these names",
                data={"found": name, "allowed": names},
            )
        )


class NoControllerError(RopsimError):
    """The robot has no drives that gains could be made for."""

    def __init__(self, name: str) -> None:
        super().__init__(
            NO_CONTROLLER.at(
                None,
                f"`{name}` has no drives, a controller needs motors, gears and amplifiers",
                hint="take a robot with drives (`ropsim robot list`), or give the model drives",
                data={"found": name},
            )
        )
