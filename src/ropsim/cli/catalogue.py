"""The whole catalogue of diagnostics: imports every module that defines some."""

import pkgutil
from collections.abc import Mapping
from importlib import import_module
from importlib.util import find_spec

import ropsim
from ropsim.core import Kind, catalogue


def all_kinds() -> Mapping[str, Kind]:
    """Return every diagnostic kind of ropsim by code."""
    for module in pkgutil.walk_packages(ropsim.__path__, "ropsim."):
        if module.name != "ropsim.__main__" and _may_define(module.name):
            import_module(module.name)
    return catalogue()


def _may_define(name: str) -> bool:
    """Return whether a module may define kinds by its text, which is read faster than the module is imported.

    Modules that need numba are not imported: they define none, and numba may be absent.
    """
    found = find_spec(name)
    read = getattr(found.loader, "get_source", None) if found else None
    text = read(name) if read else None
    return text is None or "define(" in text
