"""Robot off-line programming and real-time simulation: task text in, verified motion out.

The packages are loaded when they are first used, so that `import ropsim` and `ropsim --version` stay quick:
`ropsim.robots`, `ropsim.kinematics`, `ropsim.dynamics` and so on need no import of their own.
"""

from importlib import import_module
from typing import TYPE_CHECKING

from ropsim.version import __version__ as __version__

if TYPE_CHECKING:
    from ropsim import blockdiagram as blockdiagram
    from ropsim import calibration as calibration
    from ropsim import cellfile as cellfile
    from ropsim import collision as collision
    from ropsim import controller as controller
    from ropsim import core as core
    from ropsim import dynamics as dynamics
    from ropsim import exchange as exchange
    from ropsim import express as express
    from ropsim import flow as flow
    from ropsim import icr as icr
    from ropsim import kinematics as kinematics
    from ropsim import language as language
    from ropsim import meshes as meshes
    from ropsim import model as model
    from ropsim import motion as motion
    from ropsim import nirox as nirox
    from ropsim import part21 as part21
    from ropsim import parts as parts
    from ropsim import planning as planning
    from ropsim import program as program
    from ropsim import prolog as prolog
    from ropsim import records as records
    from ropsim import robotfile as robotfile
    from ropsim import robots as robots
    from ropsim import simulation as simulation
    from ropsim import spatial as spatial
    from ropsim import tasks as tasks
    from ropsim import tomltext as tomltext
    from ropsim import userfiles as userfiles
    from ropsim import views as views
    from ropsim import workbench as workbench
    from ropsim import workspace as workspace
    from ropsim.core import RopsimError as RopsimError
    from ropsim.workbench import load_robot as load_robot
    from ropsim.workbench import open_project as open

__all__ = [
    "RopsimError",
    "__version__",
    "blockdiagram",
    "calibration",
    "cellfile",
    "collision",
    "controller",
    "core",
    "dynamics",
    "exchange",
    "express",
    "flow",
    "icr",
    "kinematics",
    "language",
    "load_robot",
    "meshes",
    "model",
    "motion",
    "nirox",
    "open",
    "part21",
    "parts",
    "planning",
    "program",
    "prolog",
    "records",
    "robotfile",
    "robots",
    "simulation",
    "spatial",
    "tasks",
    "tomltext",
    "userfiles",
    "views",
    "workbench",
    "workspace",
]

_SHORT_CUTS = {
    "RopsimError": ("ropsim.core", "RopsimError"),
    "load_robot": ("ropsim.workbench", "load_robot"),
    "open": ("ropsim.workbench", "open_project"),
}


def __getattr__(name: str) -> object:
    """Return a package or a short cut of the public API, importing it on first use (PEP 562)."""
    if name in _SHORT_CUTS:
        module, attribute = _SHORT_CUTS[name]
        value: object = getattr(import_module(module), attribute)
    elif name in __all__:
        value = import_module(f"ropsim.{name}")
    else:
        raise AttributeError(f"module 'ropsim' has no attribute {name!r}")
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    """Return the names of the public API."""
    return sorted(__all__)
