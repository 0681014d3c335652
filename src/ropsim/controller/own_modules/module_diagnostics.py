"""Errors of modules of a project that make entities of the controller."""

from ropsim.core import Diagnostic, RopsimError, Severity, define
from ropsim.model import ControllerFile

JOINT_CONTROLLER = "joint_controller"
"""Function of a module that makes a law: `joint_controller(robot, controller)`."""

MODULE_NOT_TRUSTED = define(
    "C628",
    "module-not-trusted",
    Severity.ERROR,
    "an entity of a controller is a module of a project that is not trusted",
    """
`file = "controllers/mine.py"` in `[controller]` takes the joint controller in Python from the project, and a
key of `[controller.entities]`, such as `path_planner = "controllers/mine.py"`, another entity: the path
planner, an interpolator, the sensors. Such code can do whatever you can do, so it runs only in folders that
you trust. Until then no program of the project runs. The message says which entity the module makes.

If you know where the project comes from, `ropsim trust PATH` lets its code run, `ropsim trust PATH --revoke`
takes that back. A block diagram (`.p21`) is data and needs no trust.
""",
)

MODULE_FAILS = define(
    "C629",
    "module-fails",
    Severity.ERROR,
    "a module of the project that makes an entity of a controller does not do its work",
    """
The module, or another one of the project that it imports, cannot be read as Python or raises an exception,
or it has no function of the name that is needed:
`joint_controller(robot, controller)` for `file` in `[controller]`, which returns a `CompiledLaw` or an
object with `traits` and `step`; for a key of `[controller.entities]` the function of its name, such as
`path_planner(standard, cell, station)`, which returns an object in place of the standard one.
""",
)


class ModuleError(RopsimError):
    """A module of the project may not run, fails, or makes something else than an entity."""


def untrusted(file: ControllerFile, entry: str) -> Diagnostic:
    """Return the finding that a module stays inert.

    Args:
        file: the module.
        entry: name of its function, which is that of the entity.
    """
    message = f"`{file.path}` makes the {entity_words(entry)} and is not run: the folder is not trusted"
    hint = "`ropsim trust PATH` lets it run, if you know where it comes from"
    return MODULE_NOT_TRUSTED.at(None, message, hint=hint, data={"file": file.path})


def entity_words(entry: str) -> str:
    """Return an entity in words, by the name of its function."""
    return entry.replace("_", " ")


def entity_page(entry: str) -> str:
    """Return a hint to the page about modules for an entity."""
    return f"see docs/how-to/{'own-controller' if entry == JOINT_CONTROLLER else 'own-planner'}.md"
