"""The whole catalogue of diagnostics: imports every module, since any one may define some."""

import pkgutil
from collections.abc import Mapping
from importlib import import_module

import ropsim
from ropsim.core import Kind, catalogue


def all_kinds() -> Mapping[str, Kind]:
    """Return every diagnostic kind of ropsim by code."""
    for module in pkgutil.walk_packages(ropsim.__path__, "ropsim."):
        if module.name != "ropsim.__main__":
            import_module(module.name)
    return catalogue()
