"""Starting and ending the web process: one port of this machine, one address, Ctrl+C ends everything."""

import contextlib
import os
import secrets
import signal
import socket
import sys
import threading
import time
import webbrowser
from collections.abc import Callable, Iterator
from enum import Enum
from pathlib import Path
from types import FrameType

import uvicorn
from msgspec.structs import replace
from starlette.applications import Starlette
from starlette.types import ASGIApp

from ropsim.core import frozen_dataclass
from ropsim.studio.diagnostics import PORT_TAKEN, StudioError
from ropsim.studio.processes.isolation import leave_project, neutral_folder
from ropsim.studio.session.place import keep_place, place_of
from ropsim.studio.session.workplace import Workplace
from ropsim.studio.texts.project_files import project_folder
from ropsim.studio.web import pages, sockets
from ropsim.studio.web.entry import Entry
from ropsim.studio.web.security import Gate

ADDRESS = "127.0.0.1"
LONGEST_MESSAGE = 16_000_000
"""Of a page to the server [bytes]: a text of the largest size, escaped."""


class Browser(Enum):
    """Whether the address is opened in the browser."""

    OPENED = "opened"
    LEFT_ALONE = "left alone"


@frozen_dataclass
class StudioOptions:
    """Options from the user.

    Attributes:
        project: path of a project folder, its `cell.toml`, or one of its programs.
        port: 0 for that of the last time, or any free one.
        browser: opened or not.
    """

    project: Path
    port: int = 0
    browser: Browser = Browser.OPENED


def serve(options: StudioOptions, say: Callable[[str], None]) -> None:
    """Serve the studio until Ctrl+C or a request of the system to end.

    Args:
        options: options from the user.
        say: called with the address, once it can be opened.

    Raises:
        StudioError: U950 no project, U951 the port cannot be used, U952 the pages are not built.
    """
    folder = project_folder(options.project)
    page_folder = pages.pages_folder()
    place = place_of(folder, time.time())
    listener = _listen(options.port) if options.port else _listen_again(place.port)
    port = listener.getsockname()[1]
    place = replace(place, port=port)
    keep_place(folder, place)
    token, once = (secrets.token_urlsafe(24) for _ in range(2))

    def ready() -> None:
        say(_address(port, token))
        if options.browser is Browser.OPENED:
            # a browser of the terminal would hold the server up
            threading.Thread(target=webbrowser.open, args=(_address(port, once),), daemon=True).start()

    with neutral_folder() as neutral:
        leave_project(neutral, folder)
        workplace = Workplace(folder, neutral, place)
        entry = Entry(port, token, once, place.secret)
        behind = Starlette(
            routes=[*pages.routes(page_folder, workplace), *sockets.routes(workplace, entry, neutral)]
        )
        try:
            gate = Gate(behind, port, entry)
            _Server(_configuration(gate), workplace, ready).run(sockets=[listener])
        finally:
            workplace.kill()
            os.chdir(neutral.anchor)


def _address(port: int, token: str) -> str:
    """Return the address of the page; browsers never send the fragment."""
    return f"http://{ADDRESS}:{port}/#token={token}"


class _Server(uvicorn.Server):
    """A server with its workplace. It reports when it listens, and ends without an error on request.

    A second request changes nothing: ending takes a few seconds at most, and unsaved text is kept meanwhile.
    """

    def __init__(self, config: uvicorn.Config, workplace: Workplace, ready: Callable[[], None]) -> None:
        super().__init__(config)
        self._workplace = workplace
        self._ready = ready

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        await self._workplace.open()
        await super().startup(sockets)
        if not self.should_exit:
            self._ready()

    async def shutdown(self, sockets: list[socket.socket] | None = None) -> None:
        await super().shutdown(sockets)
        await self._workplace.close()

    @contextlib.contextmanager
    def capture_signals(self) -> Iterator[None]:
        with super().capture_signals():
            # a terminal that is closed ends the studio, unless it was started to outlive its terminal (nohup)
            if sys.platform != "win32" and signal.getsignal(signal.SIGHUP) is signal.SIG_DFL:
                signal.signal(signal.SIGHUP, self.handle_exit)
            yield

    def handle_exit(self, sig: int, frame: FrameType | None) -> None:
        del sig, frame
        self.should_exit = True


def _configuration(app: ASGIApp) -> uvicorn.Config:
    return uvicorn.Config(
        app,
        access_log=False,
        log_config=None,
        log_level="critical",
        lifespan="off",
        ws="websockets-sansio",
        ws_max_size=LONGEST_MESSAGE,
        ws_per_message_deflate=False,
        ws_ping_interval=None,  # the system reports a closed page; a stalled one must not be cut off
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


def _listen_again(port: int) -> socket.socket:
    """Return a socket on the port of the last time, where a page may be waiting, else on any free one."""
    if port:
        with contextlib.suppress(StudioError):
            return _listen(port)
    return _listen(0)
