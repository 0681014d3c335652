"""Starting and ending the web process: one port of this machine, one address, Ctrl+C ends everything."""

import contextlib
import os
import secrets
import socket
import sys
import tempfile
import threading
import webbrowser
from collections.abc import AsyncIterator, Callable
from dataclasses import dataclass
from enum import Enum
from pathlib import Path
from types import FrameType

import uvicorn
from starlette.applications import Starlette
from starlette.types import ASGIApp

from ropsim.studio import pages, sockets
from ropsim.studio.diagnostics import PORT_TAKEN, StudioError
from ropsim.studio.project_files import project_folder
from ropsim.studio.security import Gate
from ropsim.studio.session import Session
from ropsim.workbench import CONFIGURATION_OVERRIDE, STATE_OVERRIDE

ADDRESS = "127.0.0.1"
LONGEST_MESSAGE = 16_000_000
"""Of a page to the server [bytes]: a text of the largest size, escaped."""


class Browser(Enum):
    """Whether the address is opened in the browser."""

    OPENED = "opened"
    LEFT_ALONE = "left alone"


@dataclass(frozen=True, slots=True)
class StudioOptions:
    """What the user asks for.

    Attributes:
        project: path of a project folder, its `cell.toml`, or one of its programs.
        port: 0 for any free one.
        browser: opened or not.
    """

    project: Path
    port: int = 0
    browser: Browser = Browser.OPENED


def serve(options: StudioOptions, say: Callable[[str], None]) -> None:
    """Serve the studio until Ctrl+C or a request of the system to end.

    Args:
        options: what the user asks for.
        say: told the address, once it can be opened.

    Raises:
        StudioError: U950 no project, U951 the port cannot be used, U952 the pages are not built.
    """
    folder = project_folder(options.project)
    page_folder = pages.pages_folder()
    listener = _listen(options.port)
    port = listener.getsockname()[1]
    token = secrets.token_urlsafe(24)
    address = f"http://{ADDRESS}:{port}/?token={token}"

    def ready() -> None:
        say(address)
        if options.browser is Browser.OPENED:
            # a browser of the terminal would hold the server up
            threading.Thread(target=webbrowser.open, args=(address,), daemon=True).start()

    with tempfile.TemporaryDirectory(prefix="ropsim-", ignore_cleanup_errors=True) as neutral:
        _leave_project(Path(neutral), folder)
        app = application(Session(folder, Path(neutral)), page_folder, Path(neutral))
        _Server(_configuration(Gate(app, port, token)), ready).run(sockets=[listener])
        os.chdir(Path(neutral).anchor)


def application(session: Session, page_folder: Path, neutral: Path) -> Starlette:
    """Return what is behind the gate; the session lives as long as the server."""

    @contextlib.asynccontextmanager
    async def lifespan(app: Starlette) -> AsyncIterator[None]:
        del app
        await session.open()
        try:
            yield
        finally:
            await session.close()

    everything = [*pages.routes(page_folder, session), *sockets.routes(session, neutral)]
    return Starlette(routes=everything, lifespan=lifespan)


class _Server(uvicorn.Server):
    """A server that tells when it listens, and that ends without an error on Ctrl+C."""

    def __init__(self, config: uvicorn.Config, ready: Callable[[], None]) -> None:
        super().__init__(config)
        self._ready = ready

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        await super().startup(sockets)
        self._ready()

    def handle_exit(self, sig: int, frame: FrameType | None) -> None:
        del sig, frame
        self.force_exit = self.should_exit
        self.should_exit = True


def _configuration(app: ASGIApp) -> uvicorn.Config:
    return uvicorn.Config(
        app,
        access_log=False,
        log_config=None,
        log_level="critical",
        lifespan="on",
        ws="websockets-sansio",
        ws_max_size=LONGEST_MESSAGE,
        ws_per_message_deflate=False,
        server_header=False,
        proxy_headers=False,
        timeout_graceful_shutdown=2,
    )


def _listen(port: int) -> socket.socket:
    """Return a socket that listens on this machine only.

    Raises:
        StudioError: U951.
    """
    listener = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
    if sys.platform != "win32":  # there it would let two servers share a port
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        listener.bind((ADDRESS, port))
        listener.listen()
    except (OSError, OverflowError) as error:
        listener.close()
        reason = error.strerror if isinstance(error, OSError) else "ports are numbers from 0 to 65535"
        message = f"port {port} of {ADDRESS} cannot be used: {reason}"
        hint = "leave `--port` out, or give 0, for a free one"
        raise StudioError(PORT_TAKEN.at(None, message, hint=hint)) from error
    return listener


def _leave_project(neutral: Path, folder: Path) -> None:
    """Make sure that neither this process nor its children find modules in the project folder.

    Relative places in the environment are those of the folder that is left, so they are made absolute.
    """
    for name in (CONFIGURATION_OVERRIDE, STATE_OVERRIDE, "ROPSIM_CACHE_DIR"):
        if os.environ.get(name):
            os.environ[name] = str(Path(os.environ[name]).absolute())
    modules = os.environ.get("PYTHONPATH", "").split(os.pathsep)
    os.environ["PYTHONPATH"] = os.pathsep.join(_without(modules, folder))
    os.environ["PYTHONSAFEPATH"] = "1"
    sys.path[:] = _without(sys.path, folder)
    os.chdir(neutral)


def _without(places: list[str], folder: Path) -> list[str]:
    """Return module folders as absolute paths, without the one that is named."""
    return [str(Path(place).absolute()) for place in places if place and Path(place).resolve() != folder]
