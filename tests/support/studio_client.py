"""A page of a running studio without a browser: HTTP, sockets, and the processes behind them."""

import contextlib
import hmac
import http.client
import json
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import closing
from pathlib import Path
from typing import Any, TypeAlias

from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection, connect
from websockets.typing import Origin

from support import studio_launcher
from support.patience import PATIENCE, until
from support.studio_process import Studio


def command(home: Path) -> tuple[str, ...]:
    """Return the command that runs ropsim with a tiny page."""
    return (sys.executable, studio_launcher.__file__, str(home / "pages"))


def key_of(studio: Studio) -> str:
    """Return the key in the address that a studio has printed."""
    return studio.url.partition("#token=")[2]


def secret(studio: Studio, key: str = "") -> dict[str, str]:
    """Return the header with the ticket that a page gets on entering, by the printed key or another one."""
    with connected(studio, "/ws/studio") as socket:
        return {"Authorization": f"Bearer {entered(studio, socket, key)['ticket']}"}


def entered(studio: Studio, socket: ClientConnection, key: str = "") -> dict[str, Any]:
    """Enter on an open socket, and return what the studio says to that."""
    challenge = json.loads(socket.recv(timeout=PATIENCE))
    assert challenge["type"] == "challenge"
    answer = hmac.digest(
        (key or key_of(studio)).encode(), f"{challenge['nonce']} {studio.port}".encode(), "sha256"
    )
    socket.send(json.dumps({"type": "enter", "answer": answer.hex()}))
    said: dict[str, Any] = json.loads(socket.recv(timeout=PATIENCE))
    assert said["type"] == "entered"
    return said


def get(studio: Studio, path: str, headers: dict[str, str], method: str = "GET") -> tuple[int, bytes]:
    with closing(http.client.HTTPConnection("127.0.0.1", studio.port, timeout=PATIENCE)) as connection:
        connection.request(method, path, headers=headers)
        answer = connection.getresponse()
        return answer.status, answer.read()


@contextlib.contextmanager
def opened(studio: Studio, path: str = "/ws/studio", key: str = "") -> Iterator[ClientConnection]:
    """Hold a socket open on which a page has entered, by the printed key or another one."""
    with connected(studio, path) as socket:
        entered(studio, socket, key)
        yield socket


def connected(studio: Studio, path: str = "/ws/studio", **headers: str) -> ClientConnection:
    """Return an open socket on which nobody has entered; a page's headers unless others are given."""
    ours = {"Origin": f"http://127.0.0.1:{studio.port}", **headers}
    return connect(
        f"ws://127.0.0.1:{studio.port}{path}",
        additional_headers={name: value for name, value in ours.items() if name != "Origin" and value},
        origin=Origin(ours["Origin"]) if ours["Origin"] else None,
        max_size=None,
        compression=None,
        proxy=None,
        open_timeout=PATIENCE,
        ping_interval=None,  # a busy machine is no broken line
    )


class Page:
    """A tab of the studio: what it says, and what it has heard and not asked for yet."""

    def __init__(self, socket: ClientConnection, name: str = "a") -> None:
        self.socket = socket
        self._heard: list[dict[str, Any]] = []
        self.say(type="hello", tab=name)

    def say(self, **message: object) -> None:
        self.socket.send(json.dumps(message))

    def hear(self, kind: str, **fields: object) -> dict[str, Any]:
        """Return the oldest message of a kind with these fields; others keep waiting."""
        end = time.monotonic() + PATIENCE
        while True:
            for message in self._heard:
                if message["type"] == kind and all(
                    message.get(name) == value for name, value in fields.items()
                ):
                    self._heard.remove(message)
                    return message
            text = self.socket.recv(timeout=max(0.0, end - time.monotonic()))
            if isinstance(text, str):
                self._heard.append(json.loads(text))

    def start_live(self, speed: float) -> None:
        """Start a live run and wait until it runs; what was heard of earlier ones is forgotten."""
        self.say(type="live_start", program="", speed=speed)
        begin = self.hear("live", state="starting")
        self._heard = [one for one in self._heard if one["type"] != "live"]
        assert begin["speed"] == speed
        self.hear("live", state="running")


@contextlib.contextmanager
def page_of(studio: Studio) -> Iterator[Page]:
    with opened(studio) as socket:
        yield Page(socket)


def leave_for(studio: Studio, folder: Path) -> None:
    """Let a studio have another project than it has, and wait until whoever comes finds that one."""
    with page_of(studio) as page:
        page.say(type="take_over")
        page.say(type="open_project", path=str(folder))
        with contextlib.suppress(ConnectionClosed):  # it comes back by itself where it is one in a browser
            while True:
                page.socket.recv(timeout=PATIENCE)
    with page_of(studio) as page:
        assert page.hear("welcome")["folder"] == str(folder.resolve())


Lend: TypeAlias = Callable[[Path], Studio]
"""Asked for before what opens pages, so that these are closed before the studio has its own project again."""


@contextlib.contextmanager
def lending(studio: Studio, own: Path) -> Iterator[Lend]:
    """Return what lets a studio that tests share have another project than its own, until the end."""
    lent: list[Path] = []

    def lend(folder: Path) -> Studio:
        lent.append(folder)
        leave_for(studio, folder)
        return studio

    yield lend
    if lent:
        leave_for(studio, own)


def wait_for_journal(home: Path, text: str) -> None:
    """Wait until a journal below a folder holds a text."""
    until(lambda: journalled(home, text), f"{text!r} in a journal")


def journalled(home: Path, text: str) -> bool:
    """Return whether a journal below a folder holds a text."""
    for one in home.rglob("journal/*.json"):
        with contextlib.suppress(FileNotFoundError):  # nothing is left to be kept
            if text in one.read_text("utf-8"):
                return True
    return False
