"""All targets by name; what one reads is loaded when it is asked for."""

from collections.abc import Mapping
from importlib import import_module

from support.fuzzing.target import Target

MODULES: Mapping[str, tuple[str, ...]] = {
    "meshes": ("stl", "obj", "ply", "glb", "dae"),
    "texts": ("cell", "robot", "icr", "task", "form"),
    "binaries": ("icb",),
    "recordings": ("recording", "inputs"),
    "robot_files": ("robots",),
    "server": ("lsp",),
    "traces": ("trace",),
    "part21_files": ("part21",),
    "nirox_files": ("nirox",),
    "control_files": ("control",),
}
"""The names of the targets of each module, in its order."""
NAMES = tuple(name for names in MODULES.values() for name in names)


def targets_of(module: str) -> tuple[Target, ...]:
    """Return the targets of a module beside this one."""
    found: tuple[Target, ...] = import_module(f"support.fuzzing.{module}").TARGETS
    return found


def target_of(name: str) -> Target:
    """Return a target by its name, one of `NAMES`."""
    (module,) = (module for module, names in MODULES.items() if name in names)
    (target,) = (one for one in targets_of(module) if one.name == name)
    return target
