"""The browser studio: a web process that serves the pages, and worker processes that compute for it.

The front loads the server when it is asked for it: the worker processes come through here too and shall not
load a web server.
"""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ropsim.studio.server import Browser as Browser
    from ropsim.studio.server import StudioOptions as StudioOptions
    from ropsim.studio.server import serve as serve

_OF_THE_SERVER = ("Browser", "StudioOptions", "serve")


def __getattr__(name: str) -> object:
    """Return what starts the server, importing it on first use (PEP 562)."""
    if name not in _OF_THE_SERVER:
        raise AttributeError(f"module 'ropsim.studio' has no attribute {name!r}")
    from ropsim.studio import server

    value: object = getattr(server, name)
    return value
