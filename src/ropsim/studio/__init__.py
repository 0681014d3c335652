"""The browser studio: a web process that serves the pages, and worker processes that compute for it.

The front loads its names on request: worker processes also import it and must not load a web server.
"""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ropsim.studio.web.server import Browser as Browser
    from ropsim.studio.web.server import StudioOptions as StudioOptions
    from ropsim.studio.web.server import serve as serve
    from ropsim.studio.wire.commands import Command as Command
    from ropsim.studio.wire.messages import Message as Message

_HOMES = {
    "Browser": "web.server",
    "Command": "wire.commands",
    "Message": "wire.messages",
    "StudioOptions": "web.server",
    "serve": "web.server",
}


def __getattr__(name: str) -> object:
    """Return a name of the front, importing it on first use (PEP 562)."""
    if name not in _HOMES:
        raise AttributeError(f"module 'ropsim.studio' has no attribute {name!r}")
    value: object = getattr(import_module(f"ropsim.studio.{_HOMES[name]}"), name)
    return value
